// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMaps.h"

#include "vtkLightViewVectors.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterDrawing.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDepthState.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapBiasFS.h"
#include "vtkShadowMapMidpointFS.h"
#include "vtkShadowMapPeelFS.h"
#include "vtkShadowMapViewsFS.h"
#include "vtkShadowOpenGL.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>

namespace
{
/** So many views are uniforms, and the shader's loops over them constant. */
constexpr int MostFewViews = 12;

/** Look-ups end so many texels before a border that is cut, and never at another. */
constexpr double CutTexels = 2.0;

/** So many groups of casters get maps of their own for each of many samples. */
constexpr int MostGroupsOfSample = 2;
}

//------------------------------------------------------------------------------
bool vtkShadowMapSettings::operator==(const vtkShadowMapSettings& other) const
{
  const auto tie = [](const vtkShadowMapSettings& s)
  {
    return std::tie(s.Resolution, s.Samples, s.Bilinear, s.Midpoint, s.Faces, s.Slabs, s.Neighbours,
      s.Separation, s.MemoryLimit);
  };
  return tie(*this) == tie(other);
}

//------------------------------------------------------------------------------
std::vector<vtkShadowMaps::View> vtkShadowMaps::MakeViews(
  vtkShadowFrame& frame, int index, PartState& state) const
{
  const vtkShadowLightPart& part = frame.Parts[index];
  vtkLightFrusta::Options options;
  options.Border = vtkLightFrusta::BorderTexels / this->Current.Resolution;
  options.Texel = 1.0 / this->Current.Resolution;
  options.Neighbours = this->Current.Neighbours;
  options.Groups = this->Current.Samples == 1 ? vtkLightFrusta::MostGroups : MostGroupsOfSample;
  const vtkLightFrusta frusta(part, *frame.Casters, options);
  state.Casters = frusta.GetCasters();
  state.Extent = frusta.GetExtent();
  const auto& casters = state.Casters;
  std::vector<View> views;
  if (casters.empty())
  {
    return views;
  }
  const auto places = frame.Casters->GetPlaces(part.Light, this->Current.Samples, casters);
  for (const auto& place : places)
  {
    for (const auto& frustum : frusta.GetViews(place.Point))
    {
      views.push_back({ frustum, place.Weight, index });
    }
  }
  state.Exceeded =
    !views.empty() && views.front().Frustum.Face && frusta.IsOverlapExceeded(*frame.Casters);
  return views;
}

//------------------------------------------------------------------------------
bool vtkShadowMaps::Update(vtkShadowFrame& frame, const vtkShadowMapSettings& settings)
{
  this->Changes.Update(frame, !(settings == this->Current) || !this->Maps.GetHandle());
  const bool all = this->Changes.IsAll();
  this->Current = settings;
  this->ReleaseUnused(frame.Window);

  // Views of the lights that changed; the others keep theirs, and their layers if none shifts.
  std::vector<View> views;
  std::vector<PartState> parts;
  std::vector<bool> changed;
  for (std::size_t i = 0; i < frame.Parts.size(); ++i)
  {
    PartState state;
    state.First = static_cast<int>(views.size());
    bool same = this->Changes.IsSame(static_cast<int>(i));
    const auto old = !all ? this->Views.begin() + this->Parts[i].First : this->Views.end();
    if (same && !this->Changes.HaveReceiversMoved())
    {
      views.insert(views.end(), old, old + this->Parts[i].Count);
      state.Casters = this->Parts[i].Casters;
      state.Extent = this->Parts[i].Extent;
      state.Exceeded = this->Parts[i].Exceeded;
    }
    else
    {
      const auto made = this->MakeViews(frame, static_cast<int>(i), state);
      views.insert(views.end(), made.begin(), made.end());
      // Receivers matter only where they change what the frusta hug.
      same = same && static_cast<int>(made.size()) == this->Parts[i].Count &&
             state.Casters == this->Parts[i].Casters &&
             std::equal(made.begin(), made.end(), old,
               [](const View& a, const View& b) {
                 return a.Frustum.SWCToClip == b.Frustum.SWCToClip &&
                        a.Frustum.Casters == b.Frustum.Casters;
               });
    }
    state.Count = static_cast<int>(views.size()) - state.First;
    changed.push_back(!same || state.First != this->Parts[i].First);
    parts.push_back(std::move(state));
  }
  this->Views = std::move(views);
  this->Parts = std::move(parts);
  frame.Counts["mapsDrawn"] = 0;
  frame.Counts["mapsHeld"] = 0;
  if (this->Views.empty())
  {
    // Nothing can be shadowed by these lights.
    this->Batches = 1;
    this->BatchFirst = this->BatchCount = 0;
    this->ViewVectors.Get().clear();
    this->ViewVectors.Update(frame.Window, true);
    return this->Maps.Allocate(frame.Window, vtkShadowTexture::Format::Depth, 1, 1, 1) &&
           (!settings.Neighbours || this->Pyramid.Allocate(frame.Window, this->Maps)) &&
           (!settings.Slabs || this->Slabs.Allocate(frame.Window, this->Maps));
  }

  int mostLayers = 256;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &mostLayers);
  const std::size_t layerBytes = std::size_t(4) * settings.Resolution * settings.Resolution;
  const int total = this->GetNumberOfViews();
  this->BatchSize = static_cast<int>(
    std::clamp<std::size_t>(settings.MemoryLimit / layerBytes, 1, std::min(mostLayers, total)));
  this->Batches = (total + this->BatchSize - 1) / this->BatchSize;
  const unsigned long before = this->Maps.GetGeneration();
  if (!this->Maps.Allocate(frame.Window, vtkShadowTexture::Format::Depth, settings.Resolution,
        settings.Resolution, this->BatchSize) ||
      (settings.Neighbours && !this->Pyramid.Allocate(frame.Window, this->Maps)) ||
      (settings.Midpoint && !this->AllocateLayers(frame.Window)) ||
      (settings.Slabs && !this->Slabs.Allocate(frame.Window, this->Maps)))
  {
    this->Release(frame.Window);
    return false;
  }
  const bool fresh = before != this->Maps.GetGeneration();
  if (all || fresh)
  {
    this->Maps.SetSampling(frame.Window, settings.Bilinear
                                           ? vtkShadowTexture::Sampling::CompareLinear
                                           : vtkShadowTexture::Sampling::CompareNearest);
  }
  this->UpdateViewVectors(
    frame, all || fresh || std::find(changed.begin(), changed.end(), true) != changed.end());
  this->BatchFirst = 0;
  this->BatchCount = this->BatchSize;
  if (this->AreResident())
  {
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      if (fresh || changed[i])
      {
        this->Draw(frame, this->Parts[i].First, this->Parts[i].Count);
        if (settings.Neighbours)
        {
          this->Pyramid.Build(frame, settings.Slabs ? this->Slabs.GetTexture() : this->Maps,
            this->Parts[i].First, this->Parts[i].Count);
        }
      }
    }
  }
  frame.Counts["mapsHeld"] = this->BatchSize;
  frame.Counts["mapsReused"] = this->AreResident() ? total - frame.Counts["mapsDrawn"] : 0;
  for (const auto& part : this->Parts)
  {
    frame.Counts["castersLeftOut"] +=
      static_cast<double>(frame.Casters->Get().size() - part.Casters.size());
  }
  frame.Counts["mapBatches"] = this->Batches;
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowMaps::DrawBatch(vtkShadowFrame& frame, int batch)
{
  this->BatchFirst = batch * this->BatchSize;
  this->BatchCount = std::min(this->BatchSize, this->GetNumberOfViews() - this->BatchFirst);
  this->Draw(frame, this->BatchFirst, this->BatchCount);
}

//------------------------------------------------------------------------------
double vtkShadowMaps::GetBatchShare(int light) const
{
  const PartState& state = this->Parts[light];
  if (state.Count == 0)
  {
    return this->BatchFirst == 0 ? 1.0 : 0.0;
  }
  const int first = std::max(state.First, this->BatchFirst);
  const int last = std::min(state.First + state.Count, this->BatchFirst + this->BatchCount);
  return static_cast<double>(std::max(0, last - first)) / state.Count;
}

//------------------------------------------------------------------------------
void vtkShadowMaps::Draw(vtkShadowFrame& frame, int first, int count)
{
  if (count == 0)
  {
    return;
  }
  vtkShadowTimers::Scope timer(*frame.Timers, "maps");
  vtkOpenGLState* state = frame.Window->GetState();
  vtkShadowDepthState depthState(state);
  frame.Counts["mapsDrawn"] += count;
  if (this->Current.Slabs)
  {
    for (int i = first; i < first + count; ++i)
    {
      this->Slabs.Draw(frame, this->Views[i].Frustum, this->Maps, i - this->BatchFirst,
        [this, state] { this->ClearLayer(state); });
    }
    return;
  }
  if (this->Current.Midpoint)
  {
    for (int i = first; i < first + count; ++i)
    {
      this->DrawMidpoint(frame, i);
    }
    return;
  }
  vtkShadowFramebuffer::Scope target(
    frame.Window, this->Framebuffer, nullptr, &this->Maps, first - this->BatchFirst);
  for (int i = first; i < first + count; ++i)
  {
    target.SetLayer(i - this->BatchFirst);
    this->ClearLayer(state);
    const View& view = this->Views[i];
    const vtkShadowMapFaces faces(state, this->Current.Faces, view.Frustum.SWCToClip);
    frame.Drawing->Draw(frame.Window, view.Frustum.SWCToClip, view.Frustum.Casters, faces.Get());
    state->vtkglDisable(GL_SCISSOR_TEST);
  }
}

//------------------------------------------------------------------------------
void vtkShadowMaps::ClearLayer(vtkOpenGLState* state)
{
  const float farthest = 1.0f;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  if (this->Current.Neighbours)
  {
    // A border of light, also where casters reach over it: look-ups beyond it read that.
    const int inner = std::max(1, this->Current.Resolution - 2);
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(1, 1, inner, inner);
  }
}

//------------------------------------------------------------------------------
bool vtkShadowMaps::AllocateLayers(vtkOpenGLRenderWindow* window)
{
  using Format = vtkShadowTexture::Format;
  const int side = this->Current.Resolution;
  bool made = true;
  for (int layer = 0; layer < 2; ++layer)
  {
    made = made && this->Layers[layer].Allocate(window, Format::Depth, side, side, 1) &&
           this->Sides[layer].Allocate(window, Format::Float1, side, side, 1);
  }
  return made;
}

//------------------------------------------------------------------------------
void vtkShadowMaps::ReleaseUnused(vtkOpenGLRenderWindow* window)
{
  if (!this->Current.Neighbours)
  {
    this->Pyramid.Release(window);
  }
  if (!this->Current.Slabs)
  {
    this->Slabs.Release(window);
  }
  for (int layer = 0; !this->Current.Midpoint && layer < 2; ++layer)
  {
    this->Layers[layer].Release(window);
    this->Sides[layer].Release(window);
  }
}

//------------------------------------------------------------------------------
void vtkShadowMaps::DrawMidpoint(vtkShadowFrame& frame, int index)
{
  const View& view = this->Views[index];
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  for (int layer = 0; layer < 2; ++layer)
  {
    vtkShadowFramebuffer::Scope target(
      frame.Window, this->Framebuffer, &this->Sides[layer], &this->Layers[layer], 0);
    const float farthest = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    if (layer == 1)
    {
      this->Layers[0].Activate(frame.Window);
      this->Sides[0].Activate(frame.Window);
    }
    for (const bool sheet : { false, true })
    {
      std::vector<int> casters;
      const auto& all = view.Frustum.Casters;
      std::copy_if(all.begin(), all.end(), std::back_inserter(casters),
        [&](int i) { return frame.Casters->Get()[i].Mesh->Sheet == sheet; });
      const auto setParameters = [&](vtkShaderProgram* program)
      {
        program->SetUniformi("shadowSheet", sheet);
        if (layer == 1)
        {
          program->SetUniformi("shadowFirstDepth", this->Layers[0].GetUnit());
          program->SetUniformi("shadowFirstSide", this->Sides[0].GetUnit());
        }
      };
      vtkShadowCasterDraw how;
      how.FragmentShader = vtkShadowMapPeelFS;
      how.Definitions = layer == 1 ? "#define SHADOW_SECOND\n" : "";
      how.SetParameters = setParameters;
      frame.Drawing->Draw(frame.Window, view.Frustum.SWCToClip, casters, how);
    }
  }
  this->Sides[0].Deactivate(frame.Window);
  this->Layers[1].Activate(frame.Window);
  this->Sides[1].Activate(frame.Window);
  vtkShadowFramebuffer::Scope target(
    frame.Window, this->Framebuffer, nullptr, &this->Maps, index - this->BatchFirst);
  this->ClearLayer(state);
  state->vtkglDepthFunc(GL_ALWAYS);
  const auto& frustum = view.Frustum;
  const bool directional = frame.Parts[view.Light].Light.IsDirectional();
  const float form[] = { static_cast<float>(frustum.DepthConstant),
    directional ? 0.0f : static_cast<float>(frustum.DepthScale) };
  frame.Quad->Draw(frame.Window, vtkShadowMapMidpointFS,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowFirstDepth", this->Layers[0].GetUnit());
      program->SetUniformi("shadowSecondDepth", this->Layers[1].GetUnit());
      program->SetUniformi("shadowSides", this->Sides[1].GetUnit());
      program->SetUniform2f("shadowDepthForm", form);
    });
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDisable(GL_SCISSOR_TEST);
  this->Layers[0].Deactivate(frame.Window);
  this->Layers[1].Deactivate(frame.Window);
  this->Sides[1].Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkShadowMaps::UpdateViewVectors(vtkShadowFrame& frame, bool changed)
{
  if (!changed && frame.VCToSWC == this->VCToSWC)
  {
    return;
  }
  this->VCToSWC = frame.VCToSWC;
  auto& vectors = this->ViewVectors.Get();
  vectors.clear();
  const double texels = this->Current.Resolution;
  for (const auto& view : this->Views)
  {
    const vtkShadowLight& light = frame.Parts[view.Light].Light;
    vtkLightViewVectors::AddView(vectors, frame, light, view.Frustum, texels, view.Weight);
    if (this->Current.Neighbours)
    {
      vtkLightViewVectors::AddSight(
        vectors, light, view.Frustum, texels, this->GetSeparation(view.Light), CutTexels / texels);
    }
  }
  // The constants of few views are those of all at once.
  this->ViewVectors.Update(
    frame.Window, this->AreResident() && this->GetNumberOfViews() <= MostFewViews);
}

//------------------------------------------------------------------------------
bool vtkShadowMaps::HasViewOfEach() const
{
  return this->Current.Samples == 1 && this->ViewVectors.AreFew() &&
         std::all_of(this->Parts.begin(), this->Parts.end(),
           [](const PartState& part) { return part.Count > 0; });
}

//------------------------------------------------------------------------------
bool vtkShadowMaps::IsOverlapExceeded() const
{
  return std::any_of(
    this->Parts.begin(), this->Parts.end(), [](const PartState& part) { return part.Exceeded; });
}

//------------------------------------------------------------------------------
double vtkShadowMaps::GetSeparation(int light) const
{
  return this->Current.Separation * this->Parts[light].Extent;
}

//------------------------------------------------------------------------------
std::string vtkShadowMaps::GetGLSL() const
{
  const bool clipped = std::any_of(
    this->Views.begin(), this->Views.end(), [](const View& v) { return v.Frustum.Clipped; });
  const bool cut = std::any_of(this->Views.begin(), this->Views.end(),
    [](const View& v) { return std::count(v.Frustum.Cut.begin(), v.Frustum.Cut.end(), true) > 0; });
  const int vectors =
    vtkLightViewVectors::OfView + (this->Current.Neighbours ? vtkLightViewVectors::OfSight : 0);
  std::string source = "#define SHADOW_VIEW_VECTORS " + std::to_string(vectors) +
                       "\n#define SHADOW_MAP_SIDE " + std::to_string(this->Current.Resolution) +
                       ".0\n" + (this->Current.Bilinear ? "#define SHADOW_BILINEAR\n" : "") +
                       (clipped ? "#define SHADOW_CLIPPED_VIEWS\n" : "") +
                       (cut ? "#define SHADOW_CUT_VIEWS\n" : "") + "#define SHADOW_MAP_LEVELS " +
                       std::to_string(this->Pyramid.GetLevels()) + "\n";
  if (this->ViewVectors.AreFew())
  {
    // Choices, which fold where the light is a constant: an array of constants may become memory, and
    // then nothing that depends on it unrolls.
    std::string first;
    std::string end;
    for (std::size_t i = 0; i < this->Parts.size(); ++i)
    {
      const bool last = i + 1 == this->Parts.size();
      const std::string condition = last ? "" : "(light) == " + std::to_string(i) + " ? ";
      const std::string otherwise = last ? "" : " : ";
      const auto& light = this->Parts[i];
      first += condition + std::to_string(light.First) + otherwise;
      end += condition + std::to_string(light.First + light.Count) + otherwise;
    }
    source += "#define SHADOW_FEW_VIEWS " + std::to_string(std::max(1, this->GetNumberOfViews())) +
              "\n#define SHADOW_FIRST_VIEW(light) (" + first +
              ")\n#define SHADOW_END_OF_VIEWS(light) (" + end + ")\n";
  }
  source += vtkShadowMapViewsFS + vtkLightViewVectors::GetViewGLSL() + vtkShadowMapBiasFS;
  return this->Current.Neighbours
           ? source + vtkLightViewVectors::GetSightGLSL() + vtkShadowDepthPyramid::GetGLSL()
           : source;
}

//------------------------------------------------------------------------------
void vtkShadowMaps::Activate(vtkShadowFrame& frame)
{
  this->Maps.Activate(frame.Window);
  this->ViewVectors.Activate(frame.Window);
  if (this->Current.Neighbours)
  {
    this->Depths.Activate(frame.Window, this->Maps, vtkShadowTexture::Sampling::Nearest);
    this->Pyramid.Activate(frame.Window);
  }
  if (this->Current.Slabs)
  {
    this->Slabs.Activate(frame.Window);
  }
}

//------------------------------------------------------------------------------
void vtkShadowMaps::Deactivate(vtkShadowFrame& frame)
{
  this->Slabs.Deactivate(frame.Window);
  this->Pyramid.Deactivate(frame.Window);
  this->Depths.Deactivate(frame.Window);
  this->ViewVectors.Deactivate(frame.Window);
  this->Maps.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkShadowMaps::SetParameters(vtkShaderProgram* program)
{
  program->SetUniformi("shadowMaps", this->Maps.GetUnit());
  if (this->Current.Neighbours)
  {
    program->SetUniformi("shadowDepths", this->Depths.GetUnit());
    this->Pyramid.SetParameters(program);
  }
  if (this->Current.Slabs)
  {
    this->Slabs.SetParameters(program);
  }
  this->ViewVectors.SetParameter(program, "shadowViews");
  if (this->ViewVectors.AreFew())
  {
    return;
  }
  std::array<int, vtkShadowFrame::MostParts> first{};
  std::array<int, vtkShadowFrame::MostParts> count{};
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    const PartState& state = this->Parts[i];
    first[i] = std::max(state.First, this->BatchFirst);
    const int last = std::min(state.First + state.Count, this->BatchFirst + this->BatchCount);
    count[i] = std::max(0, last - first[i]);
  }
  const int lights = static_cast<int>(this->Parts.size());
  program->SetUniform1iv("shadowFirstView", lights, first.data());
  program->SetUniform1iv("shadowViewCount", lights, count.data());
  program->SetUniformi("shadowFirstLayer", this->BatchFirst);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkShadowMaps::GetBytes() const
{
  const std::size_t maps = this->Maps.GetBytes() + this->ViewVectors.GetBytes();
  std::vector<std::pair<std::string, std::size_t>> bytes = { { "maps", maps } };
  if (this->Current.Neighbours)
  {
    bytes.emplace_back("pyramid", this->Pyramid.GetBytes());
  }
  if (this->Current.Slabs)
  {
    bytes.emplace_back("slabs", this->Slabs.GetBytes());
  }
  if (this->Current.Midpoint)
  {
    bytes.emplace_back("layers", this->Layers[0].GetBytes() + this->Layers[1].GetBytes() +
                                   this->Sides[0].GetBytes() + this->Sides[1].GetBytes());
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkShadowMaps::Release(vtkOpenGLRenderWindow* window)
{
  this->Maps.Release(window);
  this->ViewVectors.Release(window);
  this->Depths.Release(window);
  this->Pyramid.Release(window);
  this->Slabs.Release(window);
  for (int layer = 0; layer < 2; ++layer)
  {
    this->Layers[layer].Release(window);
    this->Sides[layer].Release(window);
  }
  this->Framebuffer.Release(window);
  this->Views.clear();
  this->Parts.clear();
}
