// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualShadowViews.h"

#include "vtkLightViewVectors.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterDrawing.h"
#include "vtkShadowDepthState.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkVirtualCoarseFS.h"
#include "vtkVirtualCoarseGS.h"
#include "vtkVirtualConservative.h"
#include "vtkVirtualViewsFS.h"

#include <algorithm>

namespace
{
/** Of what is turned either way a layer. */
constexpr int Sides = 2;

constexpr int VectorsOfView = vtkLightViewVectors::OfView + vtkLightViewVectors::OfSight;

/** Variance of a disk along an axis, against that of the square around it: half side 0.866 R. */
constexpr double VarianceOfDisk = 0.75;
}

//------------------------------------------------------------------------------
bool vtkVirtualShadowViews::Update(vtkShadowFrame& frame, int side)
{
  this->Changes.Update(frame, this->Coarse.GetWidth() != side && this->Coarse.GetWidth() > 1);
  std::vector<Part> parts;
  std::vector<bool> changed;
  int layers = 0;
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    const bool same = this->Changes.IsSame(i);
    Part part;
    if (same && !this->Changes.HaveReceiversMoved())
    {
      part = this->Parts[i];
    }
    else
    {
      vtkLightFrusta::Options options;
      options.Border = vtkLightFrusta::BorderTexels / side;
      options.Texel = 1.0 / side;
      options.Neighbours = true;
      options.Groups = vtkLightFrusta::MostGroups;
      const vtkLightFrusta frusta(frame.Parts[i], *frame.Casters, options);
      const vtkShadowLight& light = frame.Parts[i].Light;
      part.Views = frusta.GetViews(light.IsDirectional() ? -light.Direction : light.Position);
      part.Exceeded =
        !part.Views.empty() && part.Views.front().Face && frusta.IsOverlapExceeded(*frame.Casters);
    }
    part.FirstLayer = layers;
    layers += Sides * static_cast<int>(part.Views.size());
    const bool kept = same && part.FirstLayer == this->Parts[i].FirstLayer &&
                      std::equal(part.Views.begin(), part.Views.end(), this->Parts[i].Views.begin(),
                        this->Parts[i].Views.end(),
                        [](const auto& a, const auto& b)
                        { return a.SWCToClip == b.SWCToClip && a.Casters == b.Casters; });
    changed.push_back(!kept);
    parts.push_back(std::move(part));
  }
  this->Parts = std::move(parts);
  const unsigned long before = this->Coarse.GetGeneration();
  if (!this->Coarse.Allocate(frame.Window, vtkShadowTexture::Format::Depth, layers > 0 ? side : 1,
        layers > 0 ? side : 1, std::max(1, layers)) ||
      !this->Pyramid.Allocate(frame.Window, this->Coarse))
  {
    this->Release(frame.Window);
    return false;
  }
  frame.Counts["coarseMapsDrawn"] = 0;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    if ((changed[i] || before != this->Coarse.GetGeneration()) && !this->Parts[i].Views.empty())
    {
      this->Draw(frame, this->Parts[i]);
      frame.Counts["coarseMapsDrawn"] += static_cast<double>(this->Parts[i].Views.size());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualShadowViews::Draw(vtkShadowFrame& frame, const Part& part)
{
  const int count = static_cast<int>(part.Views.size());
  {
    vtkShadowTimers::Scope timer(*frame.Timers, "coarse maps");
    vtkShadowDepthState depthState(frame.Window->GetState());
    vtkShadowCasterDraw how;
    how.GeometryShader = vtkVirtualCoarseGS;
    how.FragmentShader = vtkVirtualCoarseFS;
    const auto side = static_cast<float>(this->Coarse.GetWidth());
    const unsigned int capability = vtkVirtualConservative::Choose();
    const vtkVirtualConservative conservative(capability);
    float turn = 1.0f;
    how.SetParameters = [side, capability, &turn](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowOwn", capability != 0 ? 1 : 0);
      program->SetUniformf("shadowSide", side);
      program->SetUniformf("shadowTurn", turn);
    };
    vtkShadowFramebuffer::Scope target(
      frame.Window, this->Framebuffer, nullptr, &this->Coarse, part.FirstLayer);
    for (int i = 0; i < Sides * count; ++i)
    {
      target.SetLayer(part.FirstLayer + i);
      const float farthest = 1.0f;
      glClearBufferfv(GL_DEPTH, 0, &farthest);
      turn = i % Sides == 0 ? 1.0f : -1.0f;
      const vtkLightView& view = part.Views[i / Sides];
      frame.Drawing->Draw(frame.Window, view.SWCToClip, view.Casters, how);
    }
  }
  this->Pyramid.Build(frame, this->Coarse, part.FirstLayer, Sides * count);
}

//------------------------------------------------------------------------------
bool vtkVirtualShadowViews::IsOverlapExceeded() const
{
  return std::any_of(
    this->Parts.begin(), this->Parts.end(), [](const Part& part) { return part.Exceeded; });
}

//------------------------------------------------------------------------------
void vtkVirtualShadowViews::Activate(vtkShadowFrame& frame)
{
  this->Coarse.Activate(frame.Window);
  this->Pyramid.Activate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkVirtualShadowViews::Deactivate(vtkShadowFrame& frame)
{
  this->Pyramid.Deactivate(frame.Window);
  this->Coarse.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
std::vector<vtkVirtualShadowViews::Turn> vtkVirtualShadowViews::GetTurns(int part) const
{
  const auto& views = this->Parts[part].Views;
  const int count = static_cast<int>(views.size());
  if (count < 2 || views.front().Face)
  {
    return { { 0, count } };
  }
  std::vector<Turn> turns;
  for (int i = 0; i < count; ++i)
  {
    turns.push_back({ i, 1 });
  }
  return turns;
}

//------------------------------------------------------------------------------
void vtkVirtualShadowViews::SetParameters(
  vtkShaderProgram* program, const vtkShadowFrame& frame, int index, const Turn& range)
{
  const Part& part = this->Parts[index];
  const vtkShadowLight& light = frame.Parts[index].Light;
  const bool square = light.Kind == vtkShadowLight::Shape::Rectangle;
  std::vector<glm::vec4> vectors;
  for (int i = 0; i < range.Count; ++i)
  {
    const vtkLightView& view = part.Views[range.First + i];
    const int layer = part.FirstLayer + Sides * (range.First + i);
    vtkLightViewVectors::AddView(
      vectors, frame, light, view, 1.0, glm::dvec3(layer, square ? 1.0 : VarianceOfDisk, 0.0));
    vtkLightViewVectors::AddSight(vectors, light, view, 1.0, 0.0, 0.0);
  }
  vectors.resize(VectorsOfView * Most, glm::vec4(0.0f));
  program->SetUniformi("shadowViewCount", range.Count);
  program->SetUniform4fv(
    "shadowViews", VectorsOfView * Most, reinterpret_cast<const float(*)[4]>(vectors.data()));
  program->SetUniformi("shadowCoarse", this->Coarse.GetUnit());
  this->Pyramid.SetParameters(program);
}

//------------------------------------------------------------------------------
std::string vtkVirtualShadowViews::GetGLSL()
{
  return vtkShadowDepthPyramid::GetGLSL() + "#define SHADOW_VIEW_VECTORS " +
         std::to_string(VectorsOfView) + "\n#define SHADOW_MOST_VIEWS " + std::to_string(Most) +
         "\n" + vtkVirtualViewsFS + vtkLightViewVectors::GetViewGLSL() +
         vtkLightViewVectors::GetSightGLSL();
}

//------------------------------------------------------------------------------
void vtkVirtualShadowViews::Release(vtkOpenGLRenderWindow* window)
{
  this->Coarse.Release(window);
  this->Pyramid.Release(window);
  this->Framebuffer.Release(window);
  this->Parts.clear();
  this->Changes.Reset();
}
