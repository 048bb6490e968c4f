// SPDX-License-Identifier: BSD-3-Clause
// Input that cannot be used gives one clear message, or none where it is harmless, and a frame.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCellArray.h"
#include "vtkMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShadowTechniques.h"
#include "vtkShadowVTKVersion.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{
using ShadowTest::Message;

/** The stage still draws, and its shadow is there. */
void CheckDrawn(ShadowStage& stage, const std::string& what, bool shadow = true)
{
  stage.Render();
  const Visibility visibility = stage.GetVisibility();
  const auto range = GetRange(visibility);
  ShadowTest::CheckAtLeast(
    static_cast<double>(visibility.GetNumberOfReceivers()), 5000.0, what + ", receivers");
  ShadowTest::CheckEqual(range.first, shadow ? 0.0 : 1.0, what + ", lowest V");
  ShadowTest::CheckEqual(range.second, 1.0, what + ", highest V");
}

/** A square of two triangles, and one more of other points. */
void AddWithTriangle(ShadowStage& stage, const glm::dvec3 (&triangle)[3])
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec3& p :
    { glm::dvec3(-0.5, -0.5, 1.0), glm::dvec3(0.5, -0.5, 1.0), glm::dvec3(0.5, 0.5, 1.0),
      glm::dvec3(-0.5, 0.5, 1.0), triangle[0], triangle[1], triangle[2] })
  {
    points->InsertNextPoint(&p.x);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 4, 5, 6 });
  triangles->InsertNextCell({ 0, 2, 3 });
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(points);
  polygons->SetPolys(triangles);
  stage.Add(polygons);
}

void Stand(ShadowStage& stage)
{
  stage.AddFloor();
  stage.AddLight(LightKind::Point);
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(BadInput, UnknownTechnique, Once)
{
  vtkShadowPass* pass = vtkShadowTechniques::Create("map-sofd");
  ShadowTest::Check(pass == nullptr, "a pass of an unknown technique");
  std::vector<std::string> words = { "map-sofd" };
  for (int i = 0; i < vtkShadowTechniques::GetNumberOfTechniques(); ++i)
  {
    words.emplace_back(vtkShadowTechniques::GetName(i));
  }
  ShadowTest::CheckOneMessage(Message::Error, words, "Create");
  ShadowTest::Check(vtkShadowTechniques::Describe("map-sofd").empty(), "a description");
  ShadowTest::CheckOneMessage(Message::Error, { "map-sofd" }, "Describe");
}

//------------------------------------------------------------------------------
SHADOW_TEST(BadInput, Parameters, Each)
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  vtkShadowPass* pass = stage.SetPass(technique);
  const auto refuse = [&](const std::string& name, const std::string& value)
  {
    const bool known = ShadowStage::HasParameter(technique, name);
    const std::string before = known ? pass->GetParameter(name) : "";
    ShadowTest::Check(!pass->SetParameter(name, value), name + " took '" + value + "'");
    ShadowTest::CheckOneMessage(Message::Error, { name, technique }, name + " = '" + value + "'");
    if (known)
    {
      ShadowTest::Check(pass->GetParameter(name) == before, name + " changed nevertheless");
    }
  };
  refuse("sampels", "64");
  refuse("", "64");
  ShadowTest::Check(pass->GetParameter("sampels").empty(), "value of an unknown parameter");
  ShadowTest::CheckOneMessage(Message::Error, { "sampels" }, "GetParameter");
  refuse("evaluation", "sideways");
  for (const auto& parameter : ShadowStage::Describe(technique).Parameters)
  {
    refuse(parameter.Name, "");
    refuse(parameter.Name, "maybe");
    if (parameter.ValueType == vtkShadowParameter::Type::Integer ||
        parameter.ValueType == vtkShadowParameter::Type::Real)
    {
      refuse(parameter.Name, std::to_string(parameter.Minimum - 1.0));
      refuse(parameter.Name, std::to_string(parameter.Maximum + 1.0));
      refuse(parameter.Name, "nan");
      refuse(parameter.Name, "inf");
      refuse(parameter.Name, "8x");
    }
    if (parameter.ValueType == vtkShadowParameter::Type::Integer)
    {
      refuse(parameter.Name, std::to_string(parameter.Minimum + 0.5));
    }
    // The declared default and the presets are values of it.
    ShadowTest::Check(pass->SetParameter(parameter.Name, parameter.Default), "default refused");
    for (const auto& preset : parameter.Presets)
    {
      ShadowTest::Check(pass->SetParameter(parameter.Name, preset), "preset refused: " + preset);
    }
    ShadowTest::Check(pass->SetParameter(parameter.Name, parameter.Default), "default refused");
  }
  ShadowTest::Check(!pass->SetDebugView("wireframe"), "an unknown debug view was taken");
  ShadowTest::CheckOneMessage(Message::Error, { "wireframe", "visibility" }, "SetDebugView");
  ShadowTest::Check(!pass->SetTechnique("no-such"), "an unknown technique was taken");
  ShadowTest::CheckOneMessage(Message::Error, { "no-such" }, "SetTechnique");
  stage.SetPass(technique);
  CheckDrawn(stage, "after all that");
}

//------------------------------------------------------------------------------
SHADOW_TEST(BadInput, VisibilityBeforeTheFirstFrame, Each)
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  stage.SetPass(technique);
  ShadowTest::Check(stage.Pass->GetVisibility(0) == nullptr, "visibility of no frame");
  ShadowTest::CheckOneMessage(Message::Error, { "GetVisibility" }, "before the first frame");
  CheckDrawn(stage, "then");
}

//------------------------------------------------------------------------------
// Points that are not finite: VTK drops their triangles, and so do shadows, with one word.
SHADOW_TEST(BadInput, PointsThatAreNotFinite, Each)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { std::nan(""), infinity, -infinity })
  {
    const std::string what = "a point at " + std::to_string(bad);
    ShadowStage stage;
    Stand(stage);
    AddWithTriangle(stage, { { bad, 0.0, 1.0 }, { 1.0, bad, 1.0 }, { 1.0, 1.0, bad } });
    stage.SetPass(technique);
    stage.Render();
    stage.Render();
    ShadowTest::CheckOneMessage(Message::Warning, { technique }, what);
    ShadowTest::CheckEqual(stage.Count("trianglesDropped"), 1.0, what + ", trianglesDropped");
    ShadowTest::CheckEqual(stage.Count("triangles"), 4.0, what + ", triangles");
    const Visibility expected = RenderVisibility(technique, {},
      [](ShadowStage& other)
      {
        Stand(other);
        other.AddQuad({ -0.5, -0.5, 1.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 });
      });
    CheckDrawn(stage, what);
    ShadowTest::CheckAtMost(Compare(stage.GetVisibility(), expected).Share, 0.001,
      what + ": pixels other than without it");
  }
}

//------------------------------------------------------------------------------
// Triangles without an area cast nothing, are counted, and are common: no word.
SHADOW_TEST(BadInput, DegenerateTriangles, Each)
{
  const glm::dvec3 shapes[][3] = {
    { { 1.0, 0.5, 0.5 }, { 1.0, 0.5, 0.5 }, { 1.0, 0.5, 0.5 } }, // a point
    { { 1.0, 0.5, 0.5 }, { 1.0, 0.5, 0.5 }, { 2.0, 0.5, 0.5 } }, // two points
    { { 0.0, 0.5, 0.5 }, { 1.0, 0.5, 0.5 }, { 3.0, 0.5, 0.5 } }, // on a line
  };
  for (const auto& shape : shapes)
  {
    ShadowStage stage;
    Stand(stage);
    AddWithTriangle(stage, shape);
    stage.SetPass(technique);
    CheckDrawn(stage, "degenerate triangle");
    ShadowTest::CheckEqual(stage.Count("trianglesDropped"), 1.0, "trianglesDropped");
    ShadowTest::CheckEqual(stage.Count("triangles"), 4.0, "triangles");
  }
}

//------------------------------------------------------------------------------
SHADOW_TEST(BadInput, EmptyScenes, Each)
{
  {
    ShadowStage stage;
    stage.SetPass(technique);
    stage.Render();
    ShadowTest::CheckEqual(
      static_cast<double>(stage.GetVisibility().GetNumberOfReceivers()), 0.0, "an empty scene");
  }
  {
    ShadowStage stage;
    Stand(stage);
    vtkNew<vtkPolyData> empty;
    vtkNew<vtkPoints> points;
    empty->SetPoints(points);
    stage.Add(empty);
    vtkNew<vtkActor> withoutMapper;
    stage.Renderer->AddActor(withoutMapper);
    stage.SetPass(technique);
    CheckDrawn(stage, "empty polygons and an actor without a mapper", false);
    stage.AddBox({ 0.0, 0.0, 0.5 }, { 1.0, 1.0, 1.0 });
    CheckDrawn(stage, "and a box");
  }
}

//------------------------------------------------------------------------------
// Lights that cast nothing are no mistake.
SHADOW_TEST(BadInput, LightsThatCastNothing, Each)
{
  const std::pair<const char*, std::function<void(ShadowStage&)>> cases[] = {
    { "no light", [](ShadowStage&) {} },
    { "light off", [](ShadowStage& stage) { stage.AddLight(LightKind::Point)->SwitchOff(); } },
    { "black light",
      [](ShadowStage& stage) { stage.AddLight(LightKind::Point)->SetColor(0.0, 0.0, 0.0); } },
    { "light of intensity 0",
      [](ShadowStage& stage) { stage.AddLight(LightKind::Point)->SetIntensity(0.0); } },
    { "shadow of strength 0",
      [](ShadowStage& stage) { stage.AddLight(LightKind::Point)->SetShadowAttenuation(0.0); } },
  };
  for (const auto& test : cases)
  {
    ShadowStage stage;
    stage.AddThings();
    test.second(stage);
    stage.Render();
    const Picture plain = stage.GetPicture();
    stage.SetPass(technique);
    stage.Render();
    ShadowTest::Check(
      Same(stage.GetPicture(), plain), std::string(test.first) + ": not the picture of no pass");
    // Without any light there are no receivers, as nothing is lit.
    const Visibility visibility = stage.GetVisibility();
    ShadowTest::Check(
      std::all_of(visibility.V.begin(), visibility.V.end(), [](float v) { return v == 1.0f; }),
      std::string(test.first) + ": V is not 1");
    ShadowTest::CheckAtMost(
      stage.Count("mapsDrawn"), 0.0, std::string(test.first) + ", maps drawn");
  }
}

//------------------------------------------------------------------------------
// A light at its focal point has no direction, one whose up vector is its direction no axes.
SHADOW_TEST(BadInput, LightsWithoutDirection, Each)
{
  for (const LightKind kind : { LightKind::Point, LightKind::Disk, LightKind::Rectangle })
  {
    if (!ShadowStage::Supports(technique, kind))
    {
      continue;
    }
    ShadowStage stage;
    stage.AddThings();
    vtkAreaLight* light = stage.AddLight(kind, { -0.5, -0.3, 6.0 }, { -0.5, -0.3, 6.0 });
    light->SetUpVector(0.0, 0.0, 1.0);
    stage.SetPass(technique);
    CheckDrawn(stage, std::string(GetName(kind)) + " at its focal point");
    light->SetUpVector(0.0, 0.0, 0.0);
    CheckDrawn(stage, std::string(GetName(kind)) + " without an up vector");
  }
}

//------------------------------------------------------------------------------
// A shape that a technique does not take: one warning that names it, and no shadow of that light.
SHADOW_TEST(BadInput, UnsupportedShapes, Each)
{
  for (const LightKind kind : LightKinds)
  {
    ShadowStage stage;
    stage.AddThings();
    stage.AddLight(kind);
    stage.SetPass(technique);
    stage.Render();
    stage.Render();
    if (ShadowStage::Supports(technique, kind))
    {
      ShadowTest::CheckNoMessage(GetName(kind));
      continue;
    }
    ShadowTest::CheckOneMessage(Message::Warning,
      { technique, kind == LightKind::Spot ? "point" : GetName(kind) }, GetName(kind));
    ShadowTest::CheckEqual(GetRange(stage.GetVisibility()).first, 1.0, "V of that light");
  }
}
