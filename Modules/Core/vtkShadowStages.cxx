// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowStages.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSettings.h"
#include "vtkShadowTechnique.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <exception>

namespace
{
/** Whether the context that is current draws on the processor: by what Mesa and Google call theirs. */
bool IsSoftware()
{
  const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string name = text ? text : "";
  const auto has = [&name](const char* part) { return name.find(part) != std::string::npos; };
  return has("llvmpipe") || has("softpipe") || has("swrast") || has("SwiftShader");
}
}

//------------------------------------------------------------------------------
vtkShadowStages::vtkShadowStages()
  : Drawing(Casters)
{
}

//------------------------------------------------------------------------------
void vtkShadowStages::Start(vtkRenderer* renderer, vtkOpenGLRenderWindow* window, const int size[2],
  vtkShadowMessages* messages)
{
  vtkShadowFrame& frame = this->Frame;
  frame.Renderer = renderer;
  frame.Window = window;
  frame.Casters = &this->Casters;
  frame.Drawing = &this->Drawing;
  frame.Timers = &this->Timers;
  frame.Quad = &this->Quad;
  frame.Messages = messages;
  frame.Receivers = nullptr;
  frame.SamplesPerPixel = std::max(1, window->GetMultiSamples());
  frame.IsSoftware = IsSoftware();
  frame.Size[0] = size[0];
  frame.Size[1] = size[1];
  frame.Lights.clear();
  frame.Parts.clear();
  frame.Counts.clear();
  this->LightNotes.clear();
  this->Drawing.ResetCounts();
  this->Opaque.Drawn = this->Opaque.Valid = false;
  this->Translucent.Drawn = this->Translucent.Valid = false;
}

//------------------------------------------------------------------------------
bool vtkShadowStages::Gather(
  const vtkShadowSettings& settings, double defaultRadius, double defaultAngle)
{
  const vtkShadowFrame& frame = this->Frame;
  return this->GatherLights(settings, defaultRadius, defaultAngle) &&
         this->GatherCasters(settings) && this->SetCamera() && frame.Size[0] > 0 &&
         frame.Size[1] > 0;
}

//------------------------------------------------------------------------------
bool vtkShadowStages::GatherLights(
  const vtkShadowSettings& settings, double defaultRadius, double defaultAngle)
{
  vtkShadowFrame& frame = this->Frame;
  const vtkShadowDeclaration& declaration = *settings.GetDeclaration();
  for (const auto& light : vtkShadowLight::Gather(
         frame.Renderer, defaultRadius, defaultAngle, settings.GetReal("darkness")))
  {
    const int shape = light.Emission ? 5 : static_cast<int>(light.Kind);
    const std::string name = vtkShadowDeclaration::ShapeNames[shape];
    std::string note = name + ": shadowed";
    if (!light.IsFinite())
    {
      note = name + ": position or size is not finite, casts no shadow";
      frame.Messages->Warn("a light's position or size is not finite: it casts no shadow.");
    }
    else if (declaration.LightShapes[shape] == vtkShadowShapeSupport::Unsupported)
    {
      note = name + ": not supported by this technique, casts no shadow";
      frame.Messages->Warn("a " + note + ".");
    }
    else if (static_cast<int>(frame.Lights.size()) >= vtkShadowFrame::MostParts)
    {
      note = name + ": one casting light too many, casts no shadow";
      frame.Messages->Warn("more than " + std::to_string(vtkShadowFrame::MostParts) +
                           " casting lights: the rest cast no shadow.");
    }
    else
    {
      frame.Lights.push_back(light);
    }
    this->LightNotes.push_back(note);
  }
  frame.Counts["lights"] = frame.Renderer->GetLights()->GetNumberOfItems();
  frame.Counts["lightsSkipped"] = frame.Counts["lights"] - frame.Lights.size();
  frame.Color = std::any_of(frame.Lights.begin(), frame.Lights.end(),
    [](const vtkShadowLight& light) { return light.Emission != nullptr; });
  frame.Hard =
    declaration.Traits.Hard || std::all_of(frame.Lights.begin(), frame.Lights.end(),
                                 [](const vtkShadowLight& light) { return light.IsPoint(); });
  return !frame.Lights.empty();
}

//------------------------------------------------------------------------------
bool vtkShadowStages::GatherCasters(const vtkShadowSettings& settings)
{
  vtkShadowFrame& frame = this->Frame;
  const std::string rule = settings.GetChoice("translucent-casters");
  const bool changed = this->Casters.Update(frame.Renderer,
    rule == "off"      ? vtkTranslucentCasters::Off
    : rule == "opaque" ? vtkTranslucentCasters::Opaque
                       : vtkTranslucentCasters::Weighted,
    vtkShadowFrame::MostParts / static_cast<int>(frame.Lights.size()) - 1,
    settings.GetReal("alpha-threshold"));
  frame.Parts = vtkShadowLightPart::Split(frame.Lights, this->Casters.GetOpacities());
  frame.Counts["casters"] = static_cast<double>(this->Casters.Get().size());
  frame.Counts["castersRebuilt"] = changed ? 1 : 0;
  frame.Counts["vertices"] = static_cast<double>(this->Casters.GetNumberOfVertices());
  frame.Counts["triangles"] = static_cast<double>(this->Casters.GetNumberOfTriangles());
  frame.Counts["trianglesDropped"] =
    static_cast<double>(this->Casters.GetNumberOfDroppedTriangles());
  if (const std::size_t count = this->Casters.GetNumberOfTrianglesNotFinite())
  {
    frame.Messages->Warn(
      std::to_string(count) + " triangles have points that are not finite: they cast no shadow.");
  }
  frame.Counts["trianglesClear"] = static_cast<double>(this->Casters.GetNumberOfClearTriangles());
  frame.Counts["castersWithHoles"] = static_cast<double>(this->Casters.GetNumberWithHoles());
  if (const std::size_t count = this->Casters.GetNumberOfUnknownAlphas())
  {
    frame.Messages->Warn(
      std::to_string(count) +
      " props have alpha in several textures at once, in a texture of glyphs or in an "
      "image slice: it makes no holes in what they cast.");
  }
  return frame.Counts["triangles"] > 0;
}

//------------------------------------------------------------------------------
bool vtkShadowStages::SetCamera()
{
  vtkShadowFrame& frame = this->Frame;
  vtkCamera* camera = frame.Renderer->GetActiveCamera();
  glm::dmat4 VTKToClip(1.0);
  if (auto* glCamera = vtkOpenGLCamera::SafeDownCast(camera))
  {
    vtkMatrix4x4 *wcvc, *vcdc, *wcdc; // transposed already, and the camera's own
    vtkMatrix3x3* normals;
    glCamera->GetKeyMatrices(frame.Renderer, wcvc, normals, vcdc, wcdc);
    VTKToClip = glm::make_mat4(vcdc->GetData());
  }
  const bool set = frame.SetCamera(
    glm::transpose(glm::make_mat4(camera->GetModelViewTransformMatrix()->GetData())), VTKToClip,
    this->Casters.GetOrigin());
  if (!set)
  {
    frame.Messages->Warn("drawn without shadows: the camera's view transform flattens, is not "
                         "finite, or is not affine.");
  }
  return set;
}

//------------------------------------------------------------------------------
bool vtkShadowStages::Guard(vtkShadowTechnique& technique, const std::function<bool()>& call)
{
  try
  {
    return call();
  }
  catch (const std::exception& exception)
  {
    this->Frame.Messages->Error(
      std::string("drawn without shadows, as the technique failed: ") + exception.what());
    // What it has begun is not to be taken for what it keeps.
    technique.Deactivate(this->Frame);
    technique.Release(this->Frame.Window);
    return false;
  }
}

//------------------------------------------------------------------------------
bool vtkShadowStages::UpdateLightData(vtkShadowTechnique& technique)
{
  vtkShadowTimers::Scope timer(this->Timers, "light data");
  return this->Guard(technique, [&] { return technique.UpdateLightData(this->Frame); });
}

//------------------------------------------------------------------------------
void vtkShadowStages::ChooseEvaluation(
  vtkShadowTechnique* technique, const vtkShadowSettings& settings)
{
  const std::string choice = settings.GetChoice("evaluation");
  const vtkShadowTraits traits = technique ? technique->GetTraits() : vtkShadowTraits();
  const bool canForward =
    traits.Forward && !traits.NeedsReceivers && technique->CanEvaluateForward();
  if (technique && choice == "forward" && !canForward)
  {
    this->Frame.Messages->Warn(
      "cannot be evaluated forward with these parameters; it is in screen space.");
  }
  this->ScreenSpace = choice == "screen" || !canForward ||
                      (choice == "auto" && !technique->PrefersForward(this->Frame));
}

//------------------------------------------------------------------------------
bool vtkShadowStages::Allocate(vtkShadowScreen& screen)
{
  const vtkShadowFrame& frame = this->Frame;
  const int parts = std::max(1, static_cast<int>(frame.Parts.size()));
  const bool made = screen.Receivers.Allocate(frame.Window, frame.Size[0], frame.Size[1]) &&
                    screen.Visibility.Allocate(frame.Window, screen.Receivers, parts, frame.Color);
  if (!made)
  {
    frame.Messages->Error("no memory for the visibility of " + std::to_string(frame.Size[0]) +
                          " x " + std::to_string(frame.Size[1]) +
                          " pixels; drawn without shadows.");
  }
  return made;
}

//------------------------------------------------------------------------------
bool vtkShadowStages::Accumulate(vtkShadowScreen& screen, int before)
{
  vtkShadowTimers::Scope timer(this->Timers, "visibility");
  if (!screen.Visibility.Accumulate(this->Frame, before))
  {
    this->Frame.Messages->Error(
      "no memory for the mean of several frames' visibility; drawn without "
      "shadows.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowStages::Evaluate(vtkShadowTechnique& technique, vtkShadowScreen& screen)
{
  vtkShadowTimers::Scope timer(this->Timers, "visibility");
  screen.Visibility.SetQuantity(this->Frame.Window, ""); // whatever a debug view left
  return this->Guard(technique,
    [&]
    {
      technique.Evaluate(this->Frame, screen.Visibility);
      return true;
    });
}

//------------------------------------------------------------------------------
std::vector<vtkLight*> vtkShadowStages::GetLights() const
{
  std::vector<vtkLight*> lights;
  for (const auto& light : this->Frame.Lights)
  {
    lights.push_back(light.Light);
  }
  vtkCollectionSimpleIterator cookie;
  vtkLightCollection* all = this->Frame.Renderer->GetLights();
  all->InitTraversal(cookie);
  while (vtkLight* light = all->GetNextLight(cookie))
  {
    if (std::find(lights.begin(), lights.end(), light) == lights.end())
    {
      lights.push_back(light);
    }
  }
  return lights;
}

//------------------------------------------------------------------------------
void vtkShadowStages::Release(vtkOpenGLRenderWindow* window)
{
  this->Timers.Release();
  this->Drawing.Release(window);
  this->Opaque.Release(window);
  this->Translucent.Release(window);
  this->Quad.Release();
}

//------------------------------------------------------------------------------
void vtkShadowStages::ReleaseOfTechnique()
{
  this->Timers.Release();
  this->Quad.Release();
  this->Drawing.ReleasePrograms();
  this->NewTechnique = true;
}

//------------------------------------------------------------------------------
void vtkShadowStages::Finish()
{
  this->Frame.Counts["trianglesDrawn"] = static_cast<double>(this->Drawing.GetDrawnTriangles());
  this->Frame.Counts["trianglesCulled"] = static_cast<double>(this->Drawing.GetCulledTriangles());
  if (this->NewTechnique && !this->Drawing.IsUsed())
  {
    this->Drawing.Release(this->Frame.Window);
  }
  this->NewTechnique = false;
}
