// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDepthBounds.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterDrawing.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthBoundsFS.h"
#include "vtkShadowDepthBoundsGS.h"
#include "vtkShadowDepthBoundsVS.h"
#include "vtkShadowDepthState.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSeesAllFS.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>

namespace
{
/** A map's border that stays clear of casters, in texels: those that touch it reach a texel further. */
constexpr double BorderTexels = 4.0;

/** So many groups of casters get maps of their own. */
constexpr int MostGroups = 4;

/** No corner of what casts lies before the near plane, where it would be clipped, or behind the light. */
bool IsWhole(const vtkLightView& view, const vtkShadowCasters& casters)
{
  return !view.Face && std::all_of(view.Casters.begin(), view.Casters.end(),
                         [&](int index)
                         {
                           const auto& corners = casters.Get()[index].Corners;
                           return std::all_of(corners.begin(), corners.end(),
                             [&](const glm::dvec3& corner)
                             {
                               const glm::dvec4 clip = view.SWCToClip * glm::dvec4(corner, 1.0);
                               return clip.w > 0.0 && clip.z >= -clip.w;
                             });
                         });
}
}

//------------------------------------------------------------------------------
bool vtkShadowDepthBounds::Part::IsSame(const Part& other) const
{
  return this->First == other.First && this->Known == other.Known &&
         std::equal(this->Views.begin(), this->Views.end(), other.Views.begin(), other.Views.end(),
           [](const vtkLightView& a, const vtkLightView& b)
           { return a.SWCToClip == b.SWCToClip && a.Casters == b.Casters; });
}

//------------------------------------------------------------------------------
vtkShadowDepthBounds::Part vtkShadowDepthBounds::MakePart(
  const vtkShadowFrame& frame, int index, int first) const
{
  const vtkShadowLightPart& part = frame.Parts[index];
  vtkLightFrusta::Options options;
  options.Border = BorderTexels / this->Resolution;
  options.Texel = 1.0 / this->Resolution;
  options.Neighbours = true;
  options.Groups = MostGroups;
  const vtkLightFrusta frusta(part, *frame.Casters, options);
  Part made;
  made.First = first;
  made.Views =
    frusta.GetViews(part.Light.IsDirectional() ? -part.Light.Direction : part.Light.Position);
  made.Known = std::all_of(made.Views.begin(), made.Views.end(),
    [&](const vtkLightView& view) { return IsWhole(view, *frame.Casters); });
  if (!made.Known)
  {
    made.Views.clear();
  }
  return made;
}

//------------------------------------------------------------------------------
void vtkShadowDepthBounds::Update(vtkShadowFrame& frame, int resolution)
{
  this->Changes.Update(frame, resolution != this->Resolution || !this->Maps.GetHandle());
  this->Resolution = resolution;
  frame.Counts["mapsDrawn"] = 0;
  const auto before = std::move(this->Parts);
  this->Parts.clear();
  int views = 0;
  for (std::size_t i = 0; i < frame.Parts.size(); ++i)
  {
    const bool same =
      this->Changes.IsSame(static_cast<int>(i)) && !this->Changes.HaveReceiversMoved();
    this->Parts.push_back(same && before[i].First == views
                            ? before[i]
                            : this->MakePart(frame, static_cast<int>(i), views));
    views += static_cast<int>(this->Parts.back().Views.size());
  }
  const unsigned long generation = this->Maps.GetGeneration();
  if (!this->Maps.Allocate(frame.Window, vtkShadowTexture::Format::Depth,
        views > 0 ? resolution : 1, views > 0 ? resolution : 1, std::max(1, views)) ||
      !this->Pyramid.Allocate(frame.Window, this->Maps))
  {
    // Without memory nothing is known, and all is traced.
    this->Release(frame.Window);
    this->Parts.assign(frame.Parts.size(), Part());
    std::for_each(this->Parts.begin(), this->Parts.end(), [](Part& part) { part.Known = false; });
    this->Changes.Reset();
  }
  else
  {
    const bool fresh = generation != this->Maps.GetGeneration();
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      const Part& part = this->Parts[i];
      if (fresh || !this->Changes.IsSame(static_cast<int>(i)) || !part.IsSame(before[i]))
      {
        this->Draw(frame, part);
      }
    }
  }
  this->UpdateVectors(frame);
  frame.Counts["mapsHeld"] = views;
}

//------------------------------------------------------------------------------
void vtkShadowDepthBounds::Draw(vtkShadowFrame& frame, const Part& part)
{
  if (part.Views.empty())
  {
    return;
  }
  const int count = static_cast<int>(part.Views.size());
  {
    vtkShadowTimers::Scope timer(*frame.Timers, "maps");
    vtkShadowDepthState depthState(frame.Window->GetState());
    vtkShadowCasterDraw how;
    how.VertexShader = vtkShadowDepthBoundsVS;
    how.GeometryShader = vtkShadowDepthBoundsGS;
    how.FragmentShader = vtkShadowDepthBoundsFS;
    how.FillHoles = true;
    how.SetParameters = [this](vtkShaderProgram* program)
    { program->SetUniformf("shadowSide", static_cast<float>(this->Resolution)); };
    vtkShadowFramebuffer::Scope target(
      frame.Window, this->Framebuffer, nullptr, &this->Maps, part.First);
    for (int i = 0; i < count; ++i)
    {
      const float farthest = 1.0f;
      target.SetLayer(part.First + i);
      glClearBufferfv(GL_DEPTH, 0, &farthest);
      frame.Drawing->Draw(frame.Window, part.Views[i].SWCToClip, part.Views[i].Casters, how);
    }
  }
  this->Pyramid.Build(frame, this->Maps, part.First, count);
  frame.Counts["mapsDrawn"] += count;
}

//------------------------------------------------------------------------------
void vtkShadowDepthBounds::UpdateVectors(vtkShadowFrame& frame)
{
  const glm::dmat4 toUnit =
    glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)), glm::dvec3(0.5));
  auto& vectors = this->Vectors.Get();
  vectors.clear();
  const double border = BorderTexels / std::max(1, this->Resolution);
  constexpr double far = 1e30;
  for (const Part& part : this->Parts)
  {
    int layer = part.First;
    for (const vtkLightView& view : part.Views)
    {
      const glm::dmat4 rows = glm::transpose(toUnit * view.SWCToClip * frame.VCToSWC);
      for (int r = 0; r < 4; ++r)
      {
        vectors.emplace_back(rows[r]);
      }
      vectors.emplace_back(
        static_cast<float>(view.DepthScale), static_cast<float>(layer++), 0.0f, 0.0f);
      vectors.emplace_back(glm::dvec4(view.Cut[0] ? border : -far, view.Cut[1] ? border : -far,
        view.Cut[2] ? 1.0 - border : far, view.Cut[3] ? 1.0 - border : far));
    }
  }
  if (vectors.empty())
  {
    vectors.emplace_back(0.0f);
  }
  this->Vectors.Update(frame.Window, false);
}

//------------------------------------------------------------------------------
std::string vtkShadowDepthBounds::GetGLSL()
{
  return vtkShadowDepthPyramid::GetGLSL() + vtkShadowSeesAllFS;
}

//------------------------------------------------------------------------------
void vtkShadowDepthBounds::Activate(vtkShadowFrame& frame)
{
  this->Pyramid.Activate(frame.Window);
  this->Vectors.Activate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkShadowDepthBounds::Deactivate(vtkShadowFrame& frame)
{
  this->Vectors.Deactivate(frame.Window);
  this->Pyramid.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkShadowDepthBounds::SetParameters(vtkShaderProgram* program)
{
  this->Pyramid.SetParameters(program);
  this->Vectors.SetParameter(program, "shadowBoundsViews");
  std::array<int, vtkShadowFrame::MostParts> first{};
  std::array<int, vtkShadowFrame::MostParts> count{};
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    first[i] = this->Parts[i].First;
    count[i] = this->Parts[i].Known ? static_cast<int>(this->Parts[i].Views.size()) : -1;
  }
  const int parts = static_cast<int>(this->Parts.size());
  program->SetUniform1iv("shadowFirstBounds", parts, first.data());
  program->SetUniform1iv("shadowBoundsCount", parts, count.data());
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkShadowDepthBounds::GetBytes() const
{
  return { { "maps", this->Maps.GetBytes() }, { "views", this->Vectors.GetBytes() },
    { "pyramid", this->Pyramid.GetBytes() } };
}

//------------------------------------------------------------------------------
void vtkShadowDepthBounds::Release(vtkOpenGLRenderWindow* window)
{
  this->Maps.Release(window);
  this->Pyramid.Release(window);
  this->Vectors.Release(window);
  this->Framebuffer.Release(window);
  this->Parts.clear();
}
