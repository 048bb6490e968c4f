// SPDX-License-Identifier: BSD-3-Clause
#include "ExtremeMeasure.h"

#include "Errors.h"
#include "ExtremeField.h"
#include "ExtremeScenes.h"
#include "Interruption.h"
#include "OffscreenWindow.h"
#include "References.h"

#include "vtkAreaLight.h"
#include "vtkOpenGLError.h" // GL
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowDeclaration.h"

#include <cmath>
#include <map>
#include <utility>

namespace
{
using Json = nlohmann::ordered_json;

std::string LastGLError;

void GLAPIENTRY NoteGLError(
  GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void*)
{
  if (type == GL_DEBUG_TYPE_ERROR && LastGLError.empty())
  {
    LastGLError = text;
  }
}

/** What is true of a scene, for the techniques that promise less, too. */
struct Truth
{
  ExtremeField Soft;
  ExtremeField Hard;
  ExtremeField Flat;      // its receivers are what is flat
  bool Everywhere = true; // else only those of Flat count
};

/** What a technique drew at a value. */
struct Frame
{
  ExtremeField Visibility;
  std::string Warning;
  std::string Error;
};

double Round(double value)
{
  return std::round(value * 1e5) / 1e5;
}
}

class ExtremeMeasure::Internals
{
public:
  explicit Internals(const BenchPlan& plan);

  ExtremeScene Build(const ExtremeCase& one, const ExtremeValue& at);
  ExtremeField Draw(ExtremeScene& scene, vtkShadowPass* pass);
  Truth DrawTruth(ExtremeScene& scene);
  Frame DrawFrame(ExtremeScene& scene, const BenchEntry& entry);
  Json Judge(const ExtremeCase& one, const BenchEntry& entry, const Frame& frame,
    const Frame& ordinary, const Truth& truth, const Truth& ordinaryTruth) const;

  const BenchPlan& Plan;
  OffscreenWindow Window;
};

//------------------------------------------------------------------------------
ExtremeMeasure::Internals::Internals(const BenchPlan& plan)
  : Plan(plan)
  , Window(plan.Default.Scene.Size.data(), 0)
{
  vtkShadowPass::SetAdvice(true); // what a user is told
  this->Window.GetOpenWindow();
  if (glDebugMessageCallback)
  {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(NoteGLError, nullptr);
  }
}

//------------------------------------------------------------------------------
ExtremeScene ExtremeMeasure::Internals::Build(const ExtremeCase& one, const ExtremeValue& at)
{
  vtkRenderWindow* window = this->Window.GetOpenWindow();
  const auto& size = this->Plan.Default.Scene.Size;
  window->SetSize(size[0], size[1]);
  window->SetTileScale(1, 1);
  window->SetTileViewport(0.0, 0.0, 1.0, 1.0);
  ExtremeScene scene(window, this->Window.GetRenderer());
  ExtremeScenes::Find(one.Scene)(scene, at);
  return scene;
}

//------------------------------------------------------------------------------
ExtremeField ExtremeMeasure::Internals::Draw(ExtremeScene& scene, vtkShadowPass* pass)
{
  this->Window.GetRenderer()->SetPass(pass);
  for (int i = 0; i < scene.Frames; ++i)
  {
    if (scene.BeforeFrame)
    {
      scene.BeforeFrame(i);
    }
    this->Window.Render();
  }
  vtkAreaLight* light = scene.GetLight();
  vtkImageData* image = light ? pass->GetVisibility(light) : pass->GetVisibility(0);
  Messages::Check();
  if (!LastGLError.empty())
  {
    throw Failure("OpenGL: " + std::exchange(LastGLError, ""));
  }
  return ExtremeField(image);
}

//------------------------------------------------------------------------------
Truth ExtremeMeasure::Internals::DrawTruth(ExtremeScene& scene)
{
  const auto pass = References::MakePass(this->Plan.Default.ReferenceSamples);
  Truth truth;
  truth.Soft = this->Draw(scene, pass);
  scene.MakeLightsPoints(true);
  truth.Hard = this->Draw(scene, pass);
  scene.LetBodiesReceive(false);
  truth.Flat = this->Draw(scene, pass);
  truth.Everywhere = !scene.Counts;
  for (std::size_t i = 0; scene.Counts && i < truth.Flat.V.size(); ++i)
  {
    const int x = static_cast<int>(i) % truth.Flat.Width;
    const int y = static_cast<int>(i) / truth.Flat.Width;
    truth.Flat.Receives[i] =
      truth.Flat.Receives[i] &&
      scene.Counts(scene.FindFloor((x + 0.5) / truth.Flat.Width, (y + 0.5) / truth.Flat.Height));
  }
  scene.LetBodiesReceive(true);
  scene.MakeLightsPoints(false);
  return truth;
}

//------------------------------------------------------------------------------
Frame ExtremeMeasure::Internals::DrawFrame(ExtremeScene& scene, const BenchEntry& entry)
{
  Frame frame;
  Messages::TakeWarnings();
  LastGLError.clear();
  try
  {
    BenchCase settings;
    for (const auto& [name, value] : scene.Settings)
    {
      settings.Settings.Settings.push_back({ "", name, value });
    }
    const auto pass = BenchPlans::MakePass(settings, entry);
    frame.Visibility = this->Draw(scene, pass);
  }
  catch (const Failure& failure)
  {
    frame.Error = failure.what();
  }
  this->Window.GetRenderer()->SetPass(nullptr);
  frame.Warning = Messages::TakeWarnings();
  return frame;
}

//------------------------------------------------------------------------------
// Whether the bounds hold, or the technique has said that it does not do that.
Json ExtremeMeasure::Internals::Judge(const ExtremeCase& one, const BenchEntry& entry,
  const Frame& frame, const Frame& ordinary, const Truth& truth, const Truth& ordinaryTruth) const
{
  Json cell;
  if (!frame.Error.empty())
  {
    const bool told = frame.Error.rfind(entry.Technique + ": ", 0) == 0; // it refuses, in words
    return { { "status", told ? "told" : "failed" }, { "note", frame.Error } };
  }
  const vtkShadowTraits traits = vtkShadowTechniqueRegistration::Find(entry.Technique)->Traits;
  const auto pick = [&traits](const Truth& from) -> const ExtremeField&
  { return traits.Hard ? from.Hard : from.Soft; };
  const auto mask = [&traits](const Truth& from)
  { return traits.PlanarReceivers || !from.Everywhere ? from.Flat : ExtremeField(); };
  bool holds = true;
  const auto judge = [&](const char* name, double value, const std::optional<double>& bound)
  {
    cell[name] = Round(value);
    holds = holds && (!bound || value <= *bound);
  };
  if (one.Change)
  {
    const auto change = ExtremeFields::Compare(frame.Visibility, ordinary.Visibility);
    judge("change", change.RMSE, one.Change);
    judge("receivers", change.MaskShare, 0.01);
  }
  if (!truth.Soft.IsEmpty())
  {
    const auto error = ExtremeFields::Compare(frame.Visibility, pick(truth), mask(truth));
    const auto before =
      ExtremeFields::Compare(ordinary.Visibility, pick(ordinaryTruth), mask(ordinaryTruth));
    judge("error", error.RMSE, std::nullopt);
    judge("growth", error.RMSE - before.RMSE, one.Growth);
    judge("bias", std::abs(error.Bias) - std::abs(before.Bias), one.Bias);
    judge("wrong", error.Wrong, one.Wrong);
  }
  if (one.Motion)
  {
    judge("motion",
      ExtremeFields::CompareChanges(frame.Visibility, ordinary.Visibility, pick(truth),
        pick(ordinaryTruth), mask(ordinaryTruth)),
      one.Motion);
  }
  const bool told = !frame.Warning.empty() && frame.Warning != ordinary.Warning;
  cell["status"] = holds ? "ok" : told ? "told" : "failed";
  if (told)
  {
    cell["note"] = frame.Warning;
  }
  return cell;
}

//------------------------------------------------------------------------------
ExtremeMeasure::ExtremeMeasure(const BenchPlan& plan)
  : Internal(std::make_unique<Internals>(plan))
{
}

//------------------------------------------------------------------------------
ExtremeMeasure::~ExtremeMeasure() = default;

//------------------------------------------------------------------------------
Json ExtremeMeasure::Run(const ExtremeCase& one)
{
  Internals& with = *this->Internal;
  const bool needsTruth = one.Growth || one.Wrong || one.Bias || one.Motion;
  Json techniques = Json::object();
  std::map<std::string, Frame> ordinary;
  Truth ordinaryTruth;
  {
    ExtremeScene scene = with.Build(one, one.Ordinary);
    ordinaryTruth = with.DrawTruth(scene);
    for (const BenchEntry& entry : with.Plan.Entries)
    {
      if (entry.Kind == BenchEntry::Role::Technique)
      {
        Frame frame = with.DrawFrame(scene, entry);
        if (frame.Visibility.IsEmpty())
        {
          throw Failure(entry.GetId() + " does not draw the ordinary case: " + frame.Error);
        }
        const vtkShadowTraits traits =
          vtkShadowTechniqueRegistration::Find(entry.Technique)->Traits;
        const auto error = ExtremeFields::Compare(frame.Visibility,
          traits.Hard ? ordinaryTruth.Hard : ordinaryTruth.Soft,
          traits.PlanarReceivers || !ordinaryTruth.Everywhere ? ordinaryTruth.Flat
                                                              : ExtremeField());
        techniques[entry.GetId()] = { { "ordinary", Round(error.RMSE) },
          { "values", Json::array() } };
        ordinary[entry.GetId()] = std::move(frame);
      }
    }
  }
  for (const ExtremeValue& at : one.Values)
  {
    ExtremeScene scene = with.Build(one, at);
    Truth truth;
    if (needsTruth)
    {
      truth = with.DrawTruth(scene);
    }
    for (const BenchEntry& entry : with.Plan.Entries)
    {
      if (Interruption::IsAsked())
      {
        return techniques;
      }
      if (entry.Kind == BenchEntry::Role::Technique)
      {
        Json cell = { { "at", at.GetText() } };
        cell.update(with.Judge(
          one, entry, with.DrawFrame(scene, entry), ordinary[entry.GetId()], truth, ordinaryTruth));
        techniques[entry.GetId()]["values"].push_back(cell);
      }
    }
  }
  return techniques;
}
