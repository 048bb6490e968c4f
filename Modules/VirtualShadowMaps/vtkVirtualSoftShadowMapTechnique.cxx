// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualSoftShadowMapTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"
#include "vtkVirtualKernelFS.h"
#include "vtkVirtualSumFS.h"
#include "vtkVirtualTilesFS.h"
#include "vtkVirtualVisibilityFS.h"
#include "vtkVisibilityBuffer.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace
{
/** Texels along a side of a kernel before some are left out; more than any metric asks for. */
constexpr int MostTaps = 48;

/** Sides of maps where none is asked for, and the least. */
constexpr int AutomaticSide = 512;
constexpr int LeastFixedSide = 1024;
constexpr int LeastSide = 16;

/** The virtual map is never finer than so many halvings of a map of one texel: floats end there. */
constexpr int MostHalvings = 18;

/** Cells of the coarse map along a side of what may hide the light. */
constexpr int MeanTaps = 6;

int FloorToPowerOfTwo(int value)
{
  int power = 1;
  while (2 * power <= value)
  {
    power *= 2;
  }
  return power;
}
}

//------------------------------------------------------------------------------
std::string vtkVirtualSoftShadowMapTechnique::FindUnsupported(vtkOpenGLRenderWindow*)
{
  return VTK_SHADOW_HAS_GL(VERSION_3_3) || VTK_SHADOW_HAS_GL(ARB_sampler_objects)
           ? ""
           : "OpenGL 3.3 is needed, or ARB_sampler_objects";
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowMapTechnique::FindSide(vtkShadowFrame& frame)
{
  const bool fixed = this->Settings.GetChoice("metric") == "none";
  this->Keeps = this->Settings.GetBoolean("cache");
  const std::size_t budget = std::size_t(1048576) * this->Settings.GetInteger("budget");
  const int asked = this->Settings.GetInteger("resolution");
  this->Side = frame.ChooseResolution(
    asked == 0 && !fixed ? AutomaticSide : asked, LeastSide, LeastFixedSide);
  if (this->Keeps && !fixed)
  {
    // A page of a power of two, and within the budget.
    this->Side = FloorToPowerOfTwo(this->Side);
    while (this->Side > LeastSide && std::size_t(4) * this->Side * this->Side > budget)
    {
      this->Side /= 2;
    }
  }
  this->MostPages = this->Pages.SetLimits(this->Side, budget, this->Keeps);
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowMapTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  int largest = 1024;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const int coarse =
    FloorToPowerOfTwo(std::min(std::max(this->Settings.GetInteger("coarse"), 32), largest));
  if (!this->Views.Update(frame, coarse))
  {
    frame.Messages->Error("no memory for coarse maps of " + std::to_string(coarse) + " x " +
                          std::to_string(coarse) + "; drawn without shadows.");
    return false;
  }
  if (this->Views.IsOverlapExceeded())
  {
    frame.Messages->Warn(
      "a light is among its casters and larger than three fifths of its distance from "
      "one: penumbrae that reach further beyond the face of its cube are drawn in.");
  }
  this->FindSide(frame);
  const int parts = static_cast<int>(frame.Parts.size());
  for (int i = 0; i < parts; ++i)
  {
    this->Pages.Follow(frame, i, this->Views.GetViews(i));
  }
  this->Pages.FollowEnd(parts);
  for (const char* name : { "tiles", "tilesDrawn", "tilesKept", "tileTexels", "tileTrianglesDrawn",
         "pixelsFiltered" })
  {
    frame.Counts[name] = 0.0;
  }
  frame.Counts["coarser"] = 1.0;
  return true;
}

//------------------------------------------------------------------------------
std::string vtkVirtualSoftShadowMapTechnique::GetTilesGLSL() const
{
  const int log2 = static_cast<int>(std::ceil(std::log2(this->Side)));
  const int halvings =
    std::clamp(MostHalvings - log2, 0, vtkVirtualShadowRequests::MostHalvings);
  return (this->Keeps ? "#define SHADOW_PAGES\n" : "") + std::string("#define SHADOW_PAGE_SIDE ") +
         std::to_string(this->Side) + ".0\n#define SHADOW_MOST_HALVINGS " +
         std::to_string(halvings) + ".0\n" + vtkVirtualTilesFS;
}

//------------------------------------------------------------------------------
std::string vtkVirtualSoftShadowMapTechnique::GetVisibilityGLSL()
{
  return vtkVirtualShadowViews::GetGLSL() + this->GetTilesGLSL() + vtkVirtualVisibilityFS;
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowMapTechnique::Activate(vtkShadowFrame& frame)
{
  this->Views.Activate(frame);
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowMapTechnique::Deactivate(vtkShadowFrame& frame)
{
  for (vtkShadowTexture* texture : { &this->Kernels, &this->Requests, &this->Sums, &this->Nodes,
         &this->Pages.GetTexture() })
  {
    texture->Deactivate(frame.Window);
  }
  this->Views.Deactivate(frame);
  this->Frame = nullptr;
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowMapTechnique::SetTiles(vtkShaderProgram* program)
{
  program->SetUniformi("shadowNodes", this->Nodes.GetUnit());
  if (this->Keeps)
  {
    program->SetUniformi("shadowTableSize", this->TableSize);
    program->SetUniformi("shadowCoarser", this->Coarser);
    return;
  }
  int first[vtkVirtualShadowViews::Most + 1] = {};
  const int views = static_cast<int>(this->Views.GetViews(this->Part).size());
  for (int i = 0; i <= vtkVirtualShadowViews::Most; ++i)
  {
    first[i] = this->Tree.GetFirstNode(std::min(i, views));
  }
  program->SetUniform1iv("shadowFirstNode", vtkVirtualShadowViews::Most + 1, first);
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowMapTechnique::SetVisibilityParameters(vtkShaderProgram* program)
{
  if (this->Frame)
  {
    this->Views.SetParameters(program, *this->Frame, this->Part);
    program->SetUniformi("shadowKernels", this->Kernels.GetUnit());
    program->SetUniformi("shadowSums", this->Sums.GetUnit());
    program->SetUniformi("shadowRequests", this->Requests.GetUnit());
    this->SetTiles(program);
  }
}

//------------------------------------------------------------------------------
std::size_t vtkVirtualSoftShadowMapTechnique::FindKernels(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part)
{
  const std::string metric = this->Settings.GetChoice("metric");
  {
    vtkShadowTimers::Scope timer(*frame.Timers, "kernels");
    const glm::vec4 eyeVC(frame.GetEyeVC());
    const glm::vec4 wRow(glm::row(frame.VCToClip, 3));
    float pixels[2][3];
    for (int axis = 0; axis < 2; ++axis)
    {
      const glm::vec3 pixelVC(frame.GetPixelVC(axis));
      std::copy_n(glm::value_ptr(pixelVC), 3, pixels[axis]);
    }
    std::string source = vtkVirtualKernelFS;
    vtkShaderProgram::Substitute(source, "//SHADOW::Declarations",
      frame.GetLightsGLSL() + vtkShadowReceivers::GetGLSL() + vtkVirtualShadowViews::GetGLSL() +
        this->GetTilesGLSL() + "#define SHADOW_CELLS " +
        std::to_string(vtkVirtualShadowTree::Cells) + ".0\n#define SHADOW_MEAN_TAPS " + std::to_string(MeanTaps) + ".0\n" +
        (metric == "static" ? "#define SHADOW_METRIC_STATIC\n" : "") +
        (metric == "none" ? "#define SHADOW_METRIC_NONE\n" : "") +
        (this->Settings.GetBoolean("antialias") ? "#define SHADOW_ANTIALIAS\n" : ""));
    vtkShadowFramebuffer::Scope target(
      frame.Window, this->Framebuffer, { &this->Kernels, &this->Requests }, nullptr, 0);
    vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
    receivers.Activate(frame.Window);
    frame.Quad->Draw(frame.Window, source,
      [&](vtkShaderProgram* program)
      {
        program->SetUniformi("shadowReceivers", receivers.GetUnit());
        program->SetUniformi("shadowLight", part);
        program->SetUniform4f("shadowEyeVC", glm::value_ptr(eyeVC));
        program->SetUniform4f("shadowWRow", glm::value_ptr(wRow));
        program->SetUniform3fv("shadowPixelVC", 2, pixels);
        frame.SetLights(program);
        this->Views.SetParameters(program, frame, part);
      });
    receivers.Deactivate(frame.Window);
  }
  vtkShadowTimers::Scope timer(*frame.Timers, "requests");
  this->Texels.resize(
    static_cast<std::size_t>(this->Requests.GetWidth()) * this->Requests.GetHeight());
  this->Framebuffer.Read(frame.Window, this->Requests, 0, &this->Texels[0].x);
  if (this->Keeps)
  {
    return this->Asked.Read(this->Texels);
  }
  this->Tree.Start(static_cast<int>(this->Views.GetViews(part).size()));
  return this->Tree.AddRequests(this->Texels);
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowMapTechnique::FindTiles(vtkShadowFrame& frame, int part)
{
  this->Coarser = 0;
  if (this->Keeps)
  {
    this->Tiles = this->Asked.GetTiles(this->Side, 0);
    while (static_cast<int>(this->Tiles.size()) > this->MostPages && this->Coarser < MostHalvings)
    {
      ++this->Coarser;
      this->Tiles = this->Asked.GetTiles(this->Side, this->Coarser);
    }
    if (this->Coarser > 0)
    {
      frame.Messages->Warn("the pages that the picture asks for are more than the budget of " +
                           std::to_string(this->Settings.GetInteger("budget")) +
                           " MB: shadows are coarser than they should be. A larger budget mends that.");
    }
  }
  else
  {
    this->Tree.Build({ this->Side, this->Settings.GetChoice("metric") == "none" });
    this->Tiles = this->Tree.GetTiles();
  }
  if (!this->Pages.Place(frame, part, this->Tiles))
  {
    return false;
  }
  if (!this->Keeps)
  {
    this->Tree.GetTiles() = this->Tiles;
  }
  frame.Counts["coarser"] = std::max(frame.Counts["coarser"], std::exp2(this->Coarser));
  frame.Counts["tiles"] += static_cast<double>(this->Tiles.size());
  for (const auto& tile : this->Tiles)
  {
    frame.Counts["tileTexels"] += static_cast<double>(tile.Size.x) * tile.Size.y;
    frame.Counts["tilesKept"] += tile.Kept ? 1.0 : 0.0;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowMapTechnique::Sum(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part)
{
  vtkOpenGLState* state = frame.Window->GetState();
  const auto nodes = this->Keeps ? vtkVirtualShadowRequests::GetTable(this->Tiles)
                                 : this->Tree.GetNodes();
  this->TableSize = static_cast<int>(nodes.size());
  this->Nodes.UploadBuffer(frame.Window, nodes);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  std::string source = vtkVirtualSumFS;
  vtkShaderProgram::Substitute(source, "//SHADOW::Declarations",
    frame.GetLightsGLSL() + vtkShadowReceivers::GetGLSL() + vtkVirtualShadowViews::GetGLSL() +
      this->GetTilesGLSL() + "#define SHADOW_MOST_TAPS " + std::to_string(MostTaps) + ".0\n");
  for (int batch = 0; batch < this->Pages.GetNumberOfBatches(); ++batch)
  {
    this->Pages.Draw(frame, this->Views.GetViews(part), this->Tiles, batch);
    vtkShadowTimers::Scope timer(*frame.Timers, "filter");
    vtkShadowFramebuffer::Scope target(
      frame.Window, this->Framebuffer, &this->Sums, nullptr, 0);
    if (batch > 0)
    {
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    }
    vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
    for (vtkShadowTexture* texture :
      { &receivers, &this->Kernels, &this->Nodes, &this->Pages.GetTexture() })
    {
      texture->Activate(frame.Window);
    }
    frame.Quad->Draw(frame.Window, source,
      [&](vtkShaderProgram* program)
      {
        program->SetUniformi("shadowReceivers", receivers.GetUnit());
        program->SetUniformi("shadowKernels", this->Kernels.GetUnit());
        program->SetUniformi("shadowTiles", this->Pages.GetTexture().GetUnit());
        program->SetUniformi("shadowLight", part);
        program->SetUniformi("shadowBatch", batch);
        frame.SetLights(program);
        this->Views.SetParameters(program, frame, part);
        this->SetTiles(program);
      });
    for (vtkShadowTexture* texture :
      { &receivers, &this->Kernels, &this->Nodes, &this->Pages.GetTexture() })
    {
      texture->Deactivate(frame.Window);
    }
  }
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowMapTechnique::FillVisibility(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  using Format = vtkShadowTexture::Format;
  this->Frame = &frame;
  for (vtkShadowTexture* texture : { &this->Kernels, &this->Requests, &this->Sums })
  {
    if (!texture->Allocate(frame.Window, Format::Float4, buffer.GetWidth(), buffer.GetHeight(), 1))
    {
      frame.Messages->Error("no memory for kernels of " + std::to_string(buffer.GetWidth()) +
                            " x " + std::to_string(buffer.GetHeight()) +
                            " pixels; nothing is in shadow.");
      return;
    }
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    this->Part = i;
    const std::size_t pixels = this->FindKernels(frame, buffer, i);
    frame.Counts["pixelsFiltered"] += static_cast<double>(pixels);
    if (!this->FindTiles(frame, i))
    {
      frame.Messages->Error("no memory for tiles; nothing is in shadow.");
      this->Tiles.clear();
      this->Tree.Start(static_cast<int>(this->Views.GetViews(i).size()));
    }
    this->Sum(frame, buffer, i);
    for (vtkShadowTexture* texture : { &this->Kernels, &this->Requests, &this->Sums, &this->Nodes })
    {
      texture->Activate(frame.Window);
    }
    {
      vtkShadowFramebuffer::Scope target(
        frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, i);
      this->DrawEvaluation(frame, buffer, i);
    }
    for (vtkShadowTexture* texture : { &this->Kernels, &this->Requests, &this->Sums, &this->Nodes })
    {
      texture->Deactivate(frame.Window);
    }
  }
  this->Frame = nullptr;
}

//------------------------------------------------------------------------------
double vtkVirtualSoftShadowMapTechnique::GetMaximumCost()
{
  return static_cast<double>(MostTaps) * MostTaps;
}

//------------------------------------------------------------------------------
std::string vtkVirtualSoftShadowMapTechnique::GetDebugQuantity(const std::string& view)
{
  static const std::pair<const char*, const char*> quantities[] = { { "tiles", "shadowTile" },
    { "predicted-resolution", "shadowResolution" }, { "kernel-size", "shadowKernelSize" },
    { "lit-mask", "shadowLitMask" }, { "cache-hits", "shadowReused" } };
  for (const auto& quantity : quantities)
  {
    if (view == quantity.first)
    {
      return quantity.second;
    }
  }
  return vtkShadowTechnique::GetDebugQuantity(view);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkVirtualSoftShadowMapTechnique::GetBytes()
{
  return { { "coarse maps", this->Views.GetBytes() },
    { "tiles", this->Pages.GetBytes() + this->Nodes.GetBytes() },
    { "kernels",
      this->Kernels.GetBytes() + this->Requests.GetBytes() + this->Sums.GetBytes() } };
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowMapTechnique::Release(vtkOpenGLRenderWindow* window)
{
  this->Views.Release(window);
  this->Pages.Release(window);
  for (vtkShadowTexture* texture : { &this->Kernels, &this->Requests, &this->Sums, &this->Nodes })
  {
    texture->Release(window);
  }
  this->Framebuffer.Release(window);
  std::vector<glm::vec4>().swap(this->Texels);
}
