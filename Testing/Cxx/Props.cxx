// SPDX-License-Identifier: BSD-3-Clause
// Every kind of prop goes on being drawn as VTK draws it, and casts the shadow of what VTK draws.

#include "ShadowOracle.h"
#include "ShadowProps.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
constexpr int Size = 300;
constexpr double ViewAngle = 50.0;

/** Nine props at most that cast, or do not, from number `first` on, three by three over a floor. */
class PropStage : public ShadowStage
{
public:
  PropStage(bool casting, std::size_t& next)
    : ShadowStage(Size, Size)
  {
    this->AddFloor(4.0);
    const auto& props = GetShadowProps();
    for (; next < props.size() && this->Names.size() < 9; ++next)
    {
      if (props[next].Casts == casting)
      {
        const auto cell = static_cast<double>(this->Names.size());
        this->Places.emplace_back(
          1.6 * (std::fmod(cell, 3.0) - 1.0), 1.6 * (std::floor(cell / 3.0) - 1.0), 0.9);
        this->Names.push_back(props[next].Name);
        props[next].Add(*this, this->Places.back());
      }
    }
  }
  std::string GetNearest(const glm::dvec3& point) const
  {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      nearest = glm::distance(point, this->Places[i]) < glm::distance(point, this->Places[nearest])
                  ? i
                  : nearest;
    }
    return this->Names[nearest];
  }

private:
  std::vector<glm::dvec3> Places;
  std::vector<std::string> Names;
};

/** A pinhole camera, to know which pixel shows a point and which point a pixel. */
struct Eye
{
  glm::dvec3 Position;
  glm::dvec3 Right, Up, Ahead;
  double Tangent = std::tan(glm::radians(0.5 * ViewAngle));

  Eye(ShadowStage& stage, const glm::dvec3& position)
    : Position(position)
  {
    stage.LookAt(position, glm::dvec3(0.0), ViewAngle);
    glm::dvec3 up;
    stage.Renderer->GetActiveCamera()->GetViewUp(&up.x);
    this->Ahead = glm::normalize(-position);
    this->Right = glm::normalize(glm::cross(this->Ahead, up));
    this->Up = glm::cross(this->Right, this->Ahead);
  }
  glm::dvec2 Project(const glm::dvec3& point) const
  {
    const glm::dvec3 ray = point - this->Position;
    const double scale = 0.5 * Size / (this->Tangent * glm::dot(ray, this->Ahead));
    return { 0.5 * Size + scale * glm::dot(ray, this->Right),
      0.5 * Size + scale * glm::dot(ray, this->Up) };
  }
  /** Where a pixel's ray meets the floor. */
  glm::dvec3 GetFloor(int x, int y) const
  {
    const glm::dvec3 ray = this->Ahead +
                           this->Tangent * ((2.0 * x + 1.0) / Size - 1.0) * this->Right +
                           this->Tangent * ((2.0 * y + 1.0) / Size - 1.0) * this->Up;
    return this->Position - ray * (this->Position.z / ray.z);
  }
};

/** Pixels in which VTK, without a pass and without the floor, draws something. */
std::vector<bool> GetCovered(ShadowStage& stage)
{
  auto* floor = vtkProp::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
  floor->VisibilityOff();
  stage.Renderer->SetBackground(0.0, 0.0, 1.0);
  stage.Render();
  const Picture picture = stage.GetPicture();
  floor->VisibilityOn();
  std::vector<bool> covered;
  for (std::size_t i = 0; i < picture.RGB.size(); i += 3)
  {
    covered.push_back(
      !(picture.RGB[i] == 0 && picture.RGB[i + 1] == 0 && picture.RGB[i + 2] == 255));
  }
  return covered;
}
}

//------------------------------------------------------------------------------
// What a point light does not see of the floor, since VTK draws a prop there in a picture taken from
// the light, lies in shadow; what it sees does not. Pixels beside an edge of that picture are left
// out; a texel of a map or the sides of a polyhedron that stands for a ball may reach further, and VTK
// draws the far ends of sticks a pixel short.
SHADOW_TEST(Props, CastWhatTheLightSees, Each)
{
  const glm::dvec3 place(-0.5, -1.0, 6.0);
  for (std::size_t next = 0; next < GetShadowProps().size();)
  {
    PropStage stage(true, next);
    stage.AddLight(LightKind::Point, place, glm::dvec3(0.0));
    const Eye light(stage, place);
    const std::vector<bool> hidden = GetCovered(stage);
    const Eye eye(stage, { 1.5, -6.0, 6.0 });
    const std::vector<bool> covered = GetCovered(stage);
    stage.SetPass(technique, { { "resolution", "1024" }, { "samples", "4" } });
    stage.Render();
    const Visibility visibility = stage.GetVisibility();
    ShadowTest::CheckNoMessage("props that cast");

    std::map<std::string, std::pair<int, int>> wrong; // of pixels in shadow
    std::size_t used = 0;
    for (int i = 0; i < Size * Size; ++i)
    {
      const glm::dvec3 point = eye.GetFloor(i % Size, i / Size);
      const glm::dvec2 seen = light.Project(point);
      const int x = static_cast<int>(std::floor(seen.x));
      const int y = static_cast<int>(std::floor(seen.y));
      if (covered[i] || std::max(std::abs(point.x), std::abs(point.y)) > 3.9 || x < 1 || y < 1 ||
          x > Size - 2 || y > Size - 2)
      {
        continue;
      }
      int count = 0;
      for (int k = 0; k < 9; ++k)
      {
        count += hidden[(y + k / 3 - 1) * Size + x + k % 3 - 1];
      }
      if (count == 0 || count == 9)
      {
        auto& of = wrong[stage.GetNearest(point + 0.13 * (place - point))];
        of.first += !visibility.Mask[i] || (visibility.V[i] < 0.5) != (count == 9);
        of.second += count == 9;
        ++used;
      }
    }
    ShadowTest::CheckAtLeast(static_cast<double>(used), 10000.0, "pixels of the floor");
    for (const auto& prop : wrong)
    {
      ShadowTest::CheckAtLeast(prop.second.second, 30, prop.first + ", pixels in its shadow");
      ShadowTest::CheckAtMost(
        prop.second.first, 0.03 * prop.second.second, prop.first + ", wrong pixels");
    }
  }
}

//------------------------------------------------------------------------------
SHADOW_TEST(Props, WhatHasNoSurfaceCastsNothing, Each)
{
  for (std::size_t next = 0; next < GetShadowProps().size();)
  {
    PropStage stage(false, next);
    stage.AddBox({ 3.4, 3.4, 0.3 }, glm::dvec3(0.2)); // lest there be no shadow at all
    stage.AddLight(LightKind::Point, { -0.5, -1.0, 6.0 }, glm::dvec3(0.0));
    const Eye eye(stage, { 1.5, -6.0, 6.0 });
    const std::vector<bool> covered = GetCovered(stage);
    stage.SetPass(technique);
    stage.Render();
    const Visibility visibility = stage.GetVisibility();
    ShadowTest::CheckNoMessage("props that do not cast");
    int shadowed = 0;
    for (int i = 0; i < Size * Size; ++i)
    {
      const glm::dvec3 point = eye.GetFloor(i % Size, i / Size);
      shadowed += !covered[i] && std::max(std::abs(point.x), std::abs(point.y)) < 2.8 &&
                  visibility.V[i] != 1.0f;
    }
    ShadowTest::CheckEqual(shadowed, 0.0, "pixels in shadow");
  }
}

//------------------------------------------------------------------------------
// Soft points, as VTK draws them by default, cast balls, and are no veil over what lies behind them.
SHADOW_TEST(Props, SoftPointsHideNothing, Each)
{
  ShadowStage stage;
  stage.AddFloor();
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(0.0, 0.0, 1.2);
  vtkNew<vtkPolyData> data;
  data->SetPoints(places);
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleFactor(0.3);
  mapper->EmissiveOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  const glm::dvec3 light(0.0, 0.0, 6.0);
  stage.AddLight(LightKind::Point, light, glm::dvec3(0.0));
  stage.LookAt({ 0.0, -6.0, 5.0 }, { 0.0, 0.0, 0.3 });
  stage.SetPass(technique, { { "resolution", "1024" }, { "samples", "4" } });
  stage.Render();
  const Visibility visibility = stage.GetVisibility();
  actor->VisibilityOff();
  const ShadowOracle oracle(stage);
  // Half opaque at a radius of 0.3 sqrt(2 ln 2), from the light's height onto the floor.
  const double radius = 0.3 * std::sqrt(2.0 * std::log(2.0)) * 6.0 / 4.8;
  std::size_t wrong = 0;
  std::size_t dark = 0;
  for (std::size_t i = 0; i < visibility.V.size(); ++i)
  {
    const double distance = glm::length(glm::dvec2(oracle.GetPixels()[i].Position));
    if (oracle.GetPixels()[i].Actor && std::abs(distance - radius) > 0.04)
    {
      dark += visibility.V[i] == 0.0f;
      wrong += !visibility.Mask[i] || (visibility.V[i] < 0.5f) != (distance < radius);
    }
  }
  ShadowTest::CheckAtLeast(static_cast<double>(dark), 100.0, "dark pixels");
  ShadowTest::CheckAtMost(static_cast<double>(wrong), 10.0, "wrong pixels");
}

//------------------------------------------------------------------------------
// Where V is 1 or nothing receives, the picture is that of no pass to 1/255, whatever is drawn; where
// V is 0 it is that of the light all but out. But for a single pixel: of a body's far side that wins the
// depth test at its silhouette V is that of its outside, which shading in each prop's shader cannot tell.
SHADOW_TEST(Props, AreDrawnAsVTKDrawsThem, Each)
{
  for (const bool casting : { true, false })
  {
    for (std::size_t next = 0; next < GetShadowProps().size();)
    {
      PropStage stage(casting, next);
      vtkAreaLight* light = stage.AddLight(LightKind::Point, { -2.0, -2.5, 4.0 }, glm::dvec3(0.0));
      const Eye eye(stage, { 1.5, -6.0, 6.0 });
      stage.Render();
      stage.Render(); // levels of detail are chosen by the time of the first
      const Picture plain = stage.GetPicture();
      light->SetIntensity(1e-6);
      stage.Render();
      const Picture out = stage.GetPicture();
      light->SetIntensity(1.0);
      ShadowTest::CheckNoMessage("props without a pass");
      stage.SetPass(technique);
      stage.Render();
      const Picture picture = stage.GetPicture();
      const Visibility visibility = stage.GetVisibility();
      ShadowTest::CheckNoMessage("props with a pass");
      std::map<std::string, int> different;
      std::size_t dark = 0;
      for (int i = 0; i < Size * Size; ++i)
      {
        const bool lit = !visibility.Mask[i] || visibility.V[i] == 1.0f;
        if (lit || visibility.V[i] == 0.0f)
        {
          const glm::dvec3 point = eye.GetFloor(i % Size, i / Size);
          different[stage.GetNearest(point + 0.15 * (eye.Position - point)) +
                    (lit ? ", lit" : ", dark")] += picture.Difference(lit ? plain : out, i) > 1;
          dark += !lit;
        }
      }
      ShadowTest::CheckAtLeast(static_cast<double>(dark), casting ? 500.0 : 0.0, "dark pixels");
      for (const auto& prop : different)
      {
        ShadowTest::CheckAtMost(
          prop.second, 1.0, prop.first + ": pixels that differ by more than 1/255");
      }
    }
  }
}
