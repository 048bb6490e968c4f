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
  const auto budget = static_cast<std::size_t>(1048576.0 * this->Settings.GetReal("budget"));
  const int asked = this->Settings.GetInteger("resolution");
  this->Side =
    frame.ChooseResolution(asked == 0 && !fixed ? AutomaticSide : asked, LeastSide, LeastFixedSide);
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
  frame.Counts["lightsTooLarge"] = frame.CountLargeLights();
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
         "tileChunksDrawn", "chunksPerTile", "pixelsFiltered" })
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
  const int halvings = std::clamp(MostHalvings - log2, 0, vtkVirtualShadowRequests::MostHalvings);
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
  for (vtkShadowTexture* texture :
    { &this->Kernels, &this->Requests, &this->Sums, &this->Nodes, &this->Pages.GetTexture() })
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
  const int views = this->Turn.Count;
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
    this->Views.SetParameters(program, *this->Frame, this->Part, this->Turn);
    program->SetUniformi("shadowKernels", this->Kernels.GetUnit());
    program->SetUniformi("shadowSums", this->Sums.GetUnit());
    program->SetUniformi("shadowRequests", this->Requests.GetUnit());
    this->SetTiles(program);
  }
}

//------------------------------------------------------------------------------
std::size_t vtkVirtualSoftShadowMapTechnique::FindKernels(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
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
        std::to_string(vtkVirtualShadowTree::Cells) + ".0\n#define SHADOW_MEAN_TAPS " +
        std::to_string(MeanTaps) + ".0\n" +
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
        program->SetUniformi("shadowLight", this->Part);
        program->SetUniform4f("shadowEyeVC", glm::value_ptr(eyeVC));
        program->SetUniform4f("shadowWRow", glm::value_ptr(wRow));
        program->SetUniform3fv("shadowPixelVC", 2, pixels);
        frame.SetLights(program);
        program->SetUniformf("shadowTexel", static_cast<float>(this->Settings.GetReal("texel")));
        this->Views.SetParameters(program, frame, this->Part, this->Turn);
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
  this->Tree.Start(this->Turn.Count);
  return this->Tree.AddRequests(this->Texels);
}

//------------------------------------------------------------------------------
bool vtkVirtualSoftShadowMapTechnique::FindTiles(vtkShadowFrame& frame)
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
      frame.Messages->Warn(
        "the pages that the picture asks for are more than the budget of " +
        *this->Settings.Find("budget") +
        " MB: shadows are coarser than they should be. A larger budget mends that.");
    }
  }
  else
  {
    this->Tree.Build({ this->Side, this->Settings.GetChoice("metric") == "none" });
    this->Tiles = this->Tree.GetTiles();
  }
  for (auto& tile : this->Tiles)
  {
    tile.View += this->Turn.First;
  }
  if (!this->Pages.Place(frame, this->Part, this->Tiles))
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
void vtkVirtualSoftShadowMapTechnique::Sum(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  vtkOpenGLState* state = frame.Window->GetState();
  const auto nodes = this->Keeps ? vtkVirtualShadowRequests::GetTable(this->Tiles, this->Turn.First)
                                 : this->Tree.GetNodes();
  this->TableSize = static_cast<int>(nodes.size());
  this->Nodes.UploadBuffer(frame.Window, nodes);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  std::string source = vtkVirtualSumFS;
  vtkShaderProgram::Substitute(source, "//SHADOW::Declarations",
    frame.GetLightsGLSL() + vtkShadowReceivers::GetGLSL() + vtkVirtualShadowViews::GetGLSL() +
      this->GetTilesGLSL() + "#define SHADOW_MOST_TAPS " +
      std::to_string(this->Settings.GetInteger("taps")) + ".0\n");
  for (int batch = 0; batch < this->Pages.GetNumberOfBatches(); ++batch)
  {
    this->Pages.Draw(frame, this->Views.GetViews(this->Part), this->Tiles, batch);
    vtkShadowTimers::Scope timer(*frame.Timers, "filter");
    vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, &this->Sums, nullptr, 0);
    if (batch > 0)
    {
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    }
    vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
    for (vtkShadowTexture* texture :
      { &receivers, &this->Kernels, &this->Requests, &this->Nodes, &this->Pages.GetTexture() })
    {
      texture->Activate(frame.Window);
    }
    frame.Quad->Draw(frame.Window, source,
      [&](vtkShaderProgram* program)
      {
        program->SetUniformi("shadowReceivers", receivers.GetUnit());
        program->SetUniformi("shadowKernels", this->Kernels.GetUnit());
        program->SetUniformi("shadowRequests", this->Requests.GetUnit());
        program->SetUniformi("shadowTiles", this->Pages.GetTexture().GetUnit());
        program->SetUniformi("shadowLight", this->Part);
        program->SetUniformi("shadowBatch", batch);
        frame.SetLights(program);
        this->Views.SetParameters(program, frame, this->Part, this->Turn);
        this->SetTiles(program);
      });
    for (vtkShadowTexture* texture :
      { &receivers, &this->Kernels, &this->Requests, &this->Nodes, &this->Pages.GetTexture() })
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
    for (const auto& turn : this->Views.GetTurns(i))
    {
      this->Turn = turn;
      this->FillPart(frame, buffer);
    }
  }
  frame.Counts["chunksPerTile"] =
    frame.Counts["tileChunksDrawn"] / std::max(frame.Counts["tilesDrawn"], 1.0);
  this->Frame = nullptr;
}

//------------------------------------------------------------------------------
void vtkVirtualSoftShadowMapTechnique::FillPart(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  frame.Counts["pixelsFiltered"] += static_cast<double>(this->FindKernels(frame, buffer));
  if (!this->FindTiles(frame))
  {
    frame.Messages->Error("no memory for tiles; nothing is in shadow.");
    this->Tiles.clear();
    this->Tree.Start(this->Turn.Count);
  }
  this->Sum(frame, buffer);
  const auto textures = { &this->Kernels, &this->Requests, &this->Sums, &this->Nodes };
  for (vtkShadowTexture* texture : textures)
  {
    texture->Activate(frame.Window);
  }
  {
    vtkOpenGLState* state = frame.Window->GetState();
    vtkShadowFramebuffer::Scope target(
      frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, this->Part);
    if (this->Turn.First > 0)
    {
      // What one group of casters hides or another does.
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendEquation(buffer.GetQuantity().empty() ? GL_MIN : GL_MAX);
    }
    this->DrawEvaluation(frame, buffer, this->Part);
    state->vtkglBlendEquation(GL_FUNC_ADD);
  }
  for (vtkShadowTexture* texture : textures)
  {
    texture->Deactivate(frame.Window);
  }
}

//------------------------------------------------------------------------------
double vtkVirtualSoftShadowMapTechnique::GetMaximumCost()
{
  const double taps = this->Settings.GetInteger("taps");
  return taps * taps;
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
    { "kernels", this->Kernels.GetBytes() + this->Requests.GetBytes() + this->Sums.GetBytes() } };
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
