// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlanarShadowMaps.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlanarCasterFS.h"
#include "vtkPlanarCasterVS.h"
#include "vtkPlanarFakeFS.h"
#include "vtkPlanarHardFS.h"
#include "vtkPlanarShadowFS.h"
#include "vtkPlanarSoftFS.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterDrawing.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowPlanes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace
{
/** A light this near to a plane, as a share of the casters' size, lies in it. */
constexpr double Level = 1e-6;

/** Heights above the plane are off by so much of a caster's size: floats, and their product. */
constexpr double HeightRounding = 1.0 / 1048576.0;

/** So many vectors of records are uniforms. */
constexpr std::size_t MostFewRecords = 96;

/** Samples that one clear of the stencil serves. */
constexpr int MostReferences = 254;

/** A layer's border that stays clear, in texels, for the interpolation of what lies outside. */
constexpr double BorderTexels = 1.5;

/** Of casters far apart on one plane: a power of two, each a layer and a look-up. */
constexpr int MostGroups = 4;
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowSettings::operator==(const vtkPlanarShadowSettings& other) const
{
  const auto tie = [](const vtkPlanarShadowSettings& s)
  { return std::tie(s.Technique, s.Resolution, s.Samples, s.Kernel); };
  return tie(*this) == tie(other);
}

//------------------------------------------------------------------------------
std::vector<vtkLightSample> vtkPlanarShadowMaps::GetSamples(const vtkShadowLightPart& part,
  const vtkShadowPlane& plane, const vtkShadowCasters& casters) const
{
  const vtkShadowLight& light = part.Light;
  const glm::dvec3 centre = light.IsDirectional() ? -light.Direction : light.Position;
  std::vector<vtkLightSample> samples = { { centre, glm::dvec3(1.0) } };
  const bool one =
    this->Current.Technique != Kind::Soft || (this->Current.Samples == 1 && light.FirstSample < 0);
  if (!one && !light.IsPoint())
  {
    // A sphere's samples lie on the disk that faces the middle of the centre's shadow.
    glm::dvec3 middle(0.0);
    if (light.Kind == vtkShadowLight::Shape::Sphere)
    {
      const glm::dvec3 centreSWC = centre - casters.GetOrigin();
      vtkPlanarShadow shadow(part, plane, plane.GetHeight(centreSWC) < 0.0 ? -1.0 : 1.0);
      shadow.Samples = { { centreSWC, glm::dvec3(1.0) } };
      shadow.Find(casters, false);
      middle = shadow.GetMiddle();
    }
    samples = light.GetSamples(this->Current.Samples, middle + casters.GetOrigin());
  }
  for (auto& sample : samples)
  {
    sample.Point -= light.IsDirectional() ? glm::dvec3(0.0) : casters.GetOrigin();
  }
  return samples;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::MakeEntries(
  vtkShadowFrame& frame, const vtkShadowPlanes& planes, int mostGroups, bool keep)
{
  const vtkShadowCasters& casters = *frame.Casters;
  std::vector<std::vector<Entry>> both; // by light, plane, side: those of groups of casters
  bool divided = false;
  for (const auto& part : frame.Parts)
  {
    const vtkShadowLight& light = part.Light;
    for (const auto& plane : planes.Get())
    {
      const auto samples = this->GetSamples(part, plane, casters);
      int sides = 0;
      for (const double side : { 1.0, -1.0 })
      {
        Entry entry{ { part, plane, side } };
        vtkPlanarShadow& shadow = entry.Shadow;
        const double least = Level * (light.IsDirectional() ? 1.0 : casters.GetSize());
        for (const auto& sample : samples)
        {
          if (shadow.GetHeight(shadow.GetPlace(sample)) > least)
          {
            shadow.Samples.push_back(sample);
            shadow.Weight += sample.Weight;
          }
        }
        shadow.Find(casters, this->Current.Technique == Kind::Fake && !light.IsPoint());
        sides += shadow.Samples.empty() ? 0 : 1;
        both.emplace_back();
        // A mask of pixels has no window.
        const int most = this->Current.Technique == Kind::Hard ? 1 : mostGroups;
        for (vtkPlanarShadow& group : shadow.Divide(most))
        {
          both.back().push_back({ std::move(group) });
        }
      }
      divided = divided || sides == 2;
    }
  }
  std::vector<Entry> entries;
  this->Sides = divided ? 2 : 1;
  this->Layers = 0;
  this->Groups = 1;
  for (const auto& groups : both)
  {
    this->Groups = std::max(this->Groups, static_cast<int>(groups.size()));
  }
  for (std::size_t i = 0; i < both.size(); i += 2)
  {
    for (std::size_t side = 0; side < (divided ? 2u : 1u); ++side)
    {
      const bool other = !divided && both[i].front().Shadow.Samples.empty();
      std::vector<Entry>& groups = both[i + (other ? 1 : side)];
      const vtkPlanarShadow& one = groups.front().Shadow;
      Entry none{ { one.LightPart, one.Plane, one.Side } };
      none.Shadow.Samples = one.Samples;
      none.Shadow.Weight = one.Weight;
      groups.resize(this->Groups, none);
      for (Entry& entry : groups)
      {
        entry.Layer = entry.Shadow.Casters.empty() ? -1 : this->Layers++;
        const double border = BorderTexels / std::max(this->Current.Resolution - 3, 1);
        const glm::dvec2 margin = border * (entry.Shadow.Window.High - entry.Shadow.Window.Low);
        entry.Shadow.Window.Low -= margin;
        entry.Shadow.Window.High += margin;
        entries.push_back(std::move(entry));
      }
    }
  }
  for (auto& entry : entries)
  {
    entry.Drawn =
      keep && std::any_of(this->Entries.begin(), this->Entries.end(),
                [&entry](const Entry& old)
                { return old.Drawn && old.Layer == entry.Layer && old.Shadow.Same(entry.Shadow); });
  }
  this->Entries = std::move(entries);
  this->Planes = planes.Get();
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowMaps::Allocate(vtkShadowFrame& frame)
{
  using Format = vtkShadowTexture::Format;
  const unsigned long before = this->Maps.GetGeneration();
  const bool hard = this->Current.Technique == Kind::Hard;
  const bool soft = this->Current.Technique == Kind::Soft;
  const int side = this->Current.Resolution;
  const int layers = std::max(1, this->Layers);
  const bool none = this->Layers == 0;
  const int width = none ? 1 : (hard ? frame.Size[0] : side);
  const int height = none ? 1 : (hard ? frame.Size[1] : side);
  const Format format =
    hard ? Format::Byte1
         : (soft ? (this->Color ? Format::Float4 : Format::Float1) : Format::Float2);
  int levels = 1;
  while (this->Current.Technique == Kind::Fake && (std::max(width, height) >> levels) > 0)
  {
    ++levels;
  }
  int mostLayers = layers;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &mostLayers);
  bool made = layers <= mostLayers &&
              this->Maps.Allocate(frame.Window, format, width, height, layers, levels);
  if (soft && made && this->Layers > 0)
  {
    made = this->Stencil.Allocate(frame.Window, Format::Depth24, side, side, 1);
  }
  else
  {
    this->Stencil.Release(frame.Window);
  }
  if (!made)
  {
    this->ReleaseTextures(frame.Window);
    return false;
  }
  if (before != this->Maps.GetGeneration())
  {
    for (auto& entry : this->Entries)
    {
      entry.Drawn = false;
    }
    if (!hard)
    {
      this->Maps.SetSampling(frame.Window, vtkShadowTexture::Sampling::Linear);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::UpdateCamera(vtkShadowFrame& frame)
{
  // What mappers draw with. Nothing is cut at the near and far plane, as z is 0 and w positive.
  glm::dmat4 rows = glm::transpose(frame.VCToClip * frame.GetSWCToVC());
  rows[2] = glm::dvec4(0.0);
  const glm::dmat4 SWCToClip = glm::transpose(rows);
  const bool moved = SWCToClip != this->SWCToClip;
  this->SWCToClip = SWCToClip;
  for (auto& entry : this->Entries)
  {
    entry.Drawn = entry.Drawn && !moved;
    const vtkPlanarShadow& shadow = entry.Shadow;
    if (entry.Layer < 0)
    {
      continue;
    }
    // Out of view: all corners of what is darkened are beyond the same side of the picture.
    int beyond[5] = { 0, 0, 0, 0, 0 };
    for (int corner = 0; corner < 4; ++corner)
    {
      const glm::dvec2 place(corner & 1 ? shadow.Window.High.x : shadow.Window.Low.x,
        corner & 2 ? shadow.Window.High.y : shadow.Window.Low.y);
      const vtkShadowPlane& plane = shadow.Plane;
      const glm::dvec4 p =
        SWCToClip *
        glm::dvec4(plane.Distance * plane.Normal + place.x * plane.X + place.y * plane.Y, 1.0);
      const bool sides[5] = { p.x<-p.w, p.x> p.w, p.y<-p.w, p.y> p.w, p.w <= 0.0 };
      for (int i = 0; i < 5; ++i)
      {
        beyond[i] += sides[i];
      }
    }
    entry.InView = std::find(beyond, beyond + 5, 4) == beyond + 5;
    frame.Counts["planarMapsOutOfView"] += entry.InView ? 0 : 1;
  }
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowMaps::Update(vtkShadowFrame& frame, const vtkShadowPlanes& planes,
  bool planesChanged, const vtkPlanarShadowSettings& settings)
{
  this->Changes.Update(frame, !(settings == this->Current) || frame.Color != this->Color);
  this->Current = settings;
  this->Color = frame.Color;
  const bool keep = !this->Changes.IsAll();
  if (planesChanged || this->Changes.IsAny())
  {
    this->MakeEntries(frame, planes, MostGroups, keep);
    this->VCToSWC = glm::dmat4(0.0);
  }
  if (!this->Allocate(frame))
  {
    // What there is no room for in groups may fit as a whole.
    if (this->Groups == 1)
    {
      this->Release(frame.Window);
      return false;
    }
    this->MakeEntries(frame, planes, 1, keep);
    if (!this->Allocate(frame))
    {
      this->Release(frame.Window);
      return false;
    }
  }
  if (settings.Technique == Kind::Hard)
  {
    this->UpdateCamera(frame);
  }
  frame.Counts["planarMapsDrawn"] = 0;
  this->Draw(frame);
  frame.Counts["planarMapsReused"] =
    this->Layers - frame.Counts["planarMapsDrawn"] - frame.Counts["planarMapsOutOfView"];
  this->UpdateRecords(frame);
  return true;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::Draw(vtkShadowFrame& frame)
{
  const auto toDraw = [](const Entry& entry)
  { return entry.Layer >= 0 && !entry.Drawn && entry.InView; };
  if (std::none_of(this->Entries.begin(), this->Entries.end(), toDraw))
  {
    return;
  }
  vtkShadowTimers::Scope timer(*frame.Timers, "planes");
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullFace(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable stencilTest(state, GL_STENCIL_TEST);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  glEnable(GL_CLIP_DISTANCE0);
  glEnable(GL_CLIP_DISTANCE1);
  {
    vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, &this->Maps,
      this->Stencil.GetHandle() ? &this->Stencil : nullptr, 0);
    for (auto& entry : this->Entries)
    {
      if (toDraw(entry))
      {
        target.SetLayer(entry.Layer);
        this->DrawLayer(frame, entry.Shadow);
        entry.Drawn = true;
        frame.Counts["planarMapsDrawn"] += 1;
      }
    }
  }
  glDisable(GL_CLIP_DISTANCE0);
  glDisable(GL_CLIP_DISTANCE1);
  if (this->Current.Technique == Kind::Fake)
  {
    this->Maps.MakeLevels(frame.Window);
  }
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::DrawLayer(vtkShadowFrame& frame, const vtkPlanarShadow& shadow)
{
  vtkOpenGLState* state = frame.Window->GetState();
  const float lit[] = { 1.0f, 1.0f, 1.0f, 1.0f };
  const float empty[] = { 0.0f, 0.0f, 0.0f, 0.0f };
  switch (this->Current.Technique)
  {
    case Kind::Hard:
      glClearBufferfv(GL_COLOR, 0, lit);
      this->DrawProjected(frame, shadow, shadow.Samples.front(), this->SWCToClip);
      break;
    case Kind::Fake:
      glClearBufferfv(GL_COLOR, 0, empty);
      state->vtkglEnable(GL_BLEND);
      state->vtkglBlendEquation(GL_MAX);
      this->DrawProjected(frame, shadow, shadow.Samples.front(), shadow.GetWindow());
      state->vtkglBlendEquation(GL_FUNC_ADD);
      state->vtkglDisable(GL_BLEND);
      break;
    case Kind::Soft:
    {
      glClearBufferfv(GL_COLOR, 0, lit);
      state->vtkglEnable(GL_BLEND);
      state->vtkglEnable(GL_STENCIL_TEST);
      state->vtkglStencilMask(0xff);
      state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
      const glm::dmat4 SWCToClip = shadow.GetWindow();
      int reference = MostReferences;
      for (const auto& sample : shadow.Samples)
      {
        // A texel is darkened by a sample once, however many surfaces hide it.
        if (reference == MostReferences)
        {
          glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
          reference = 0;
        }
        state->vtkglStencilFunc(GL_GREATER, ++reference, 0xff);
        this->DrawProjected(frame, shadow, sample, SWCToClip);
      }
      state->vtkglStencilFunc(GL_ALWAYS, 0, 0xff);
      state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
      state->vtkglDisable(GL_STENCIL_TEST);
      state->vtkglDisable(GL_BLEND);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::DrawProjected(vtkShadowFrame& frame, const vtkPlanarShadow& shadow,
  const vtkLightSample& sample, const glm::dmat4& SWCToClip)
{
  static constexpr const char* outputs[] = { "#define SHADOW_MASK\n", "#define SHADOW_SHARE\n",
    "#define SHADOW_SPREAD\n" };
  const glm::dvec4 place = shadow.GetPlace(sample);
  const double height = shadow.GetHeight(place);
  const glm::dvec4 equation = shadow.GetEquation() / height;
  vtkShadowCasterDraw how;
  how.VertexShader = vtkPlanarCasterVS;
  how.FragmentShader = vtkPlanarCasterFS;
  how.Definitions = outputs[static_cast<int>(this->Current.Technique)];
  how.SetParameters = [&](vtkShaderProgram* program)
  {
    if (this->Current.Technique == Kind::Soft)
    {
      const glm::vec3 weight(sample.Weight);
      program->SetUniform3f("shadowWeight", glm::value_ptr(weight));
    }
    else if (this->Current.Technique == Kind::Fake)
    {
      program->SetUniformf("shadowSpread", static_cast<float>(std::max(shadow.Spread, 1e-30)));
    }
  };
  how.SetCasterParameters = [&](vtkShaderProgram* program, const vtkShadowCaster& caster)
  {
    const glm::vec4 heightMC(equation * caster.MeshToSWC);
    const glm::vec2 limits(
      HeightRounding * 2.0 * caster.GetRadius() / height, static_cast<float>(place.w));
    program->SetUniform4f("shadowHeightMC", glm::value_ptr(heightMC));
    program->SetUniform2f("shadowHeightLimits", glm::value_ptr(limits));
  };
  frame.Drawing->Draw(frame.Window, SWCToClip * shadow.GetProjection(place), shadow.Casters, how);
}

//------------------------------------------------------------------------------
int vtkPlanarShadowMaps::GetRecordSize() const
{
  static constexpr int sizes[] = { 1, 3, 7 };
  return sizes[static_cast<int>(this->Current.Technique)];
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::UpdateRecords(vtkShadowFrame& frame)
{
  // Which layers are in view can change only with the camera.
  if (frame.VCToSWC == this->VCToSWC && this->Current.Technique != Kind::Hard)
  {
    return;
  }
  this->VCToSWC = frame.VCToSWC;
  auto& records = this->Records.Get();
  records.clear();
  for (const auto& plane : this->Planes)
  {
    // Of unit normal, whatever the view's transform scales by.
    const glm::dvec4 equation = plane.GetEquation() * frame.VCToSWC;
    records.emplace_back(equation / glm::length(glm::dvec3(equation)));
  }
  for (const auto& entry : this->Entries)
  {
    const vtkPlanarShadow& shadow = entry.Shadow;
    records.emplace_back(
      glm::vec3(shadow.Weight), entry.InView ? static_cast<float>(entry.Layer) : -1.0f);
    if (this->Current.Technique == Kind::Hard)
    {
      continue;
    }
    const glm::dmat4 rows =
      entry.Layer < 0 ? glm::dmat4(0.0) : glm::transpose(shadow.GetWindow() * frame.VCToSWC);
    records.emplace_back(0.5 * (rows[0] + rows[3]));
    records.emplace_back(0.5 * (rows[1] + rows[3]));
    if (this->Current.Technique == Kind::Fake)
    {
      this->AddFakeVectors(shadow);
    }
  }
  this->Records.Update(frame.Window, records.size() <= MostFewRecords);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::AddFakeVectors(const vtkPlanarShadow& shadow)
{
  auto& records = this->Records.Get();
  if (shadow.Casters.empty())
  {
    records.resize(records.size() + 4, glm::vec4(0.0f));
    return;
  }
  // A point of the light that moves by U moves the shadow of something of spread s by -s times what
  // U shows as along the ray from the receiver: U + (n.U) (x - L) / H; or U - (n.U) d / H.
  const vtkShadowLight& light = shadow.LightPart.Light;
  const glm::dvec4 place = shadow.GetPlace(shadow.Samples.front());
  const double height = shadow.GetHeight(place);
  const glm::dvec2 foot = shadow.Plane.GetPlace(glm::dvec3(place));
  const glm::dvec2 size = shadow.Window.High - shadow.Window.Low;
  glm::dvec4 axes(0.0);
  glm::dvec2 growth(0.0);
  for (int i = 0; i < 2; ++i)
  {
    const glm::dvec3& axis = i == 0 ? light.U : light.V;
    const double slope = shadow.Side * glm::dot(shadow.Plane.Normal, axis) / height;
    const glm::dvec2 along = place.w > 0.0 ? shadow.Window.Low - foot : -foot;
    const glm::dvec2 start = (shadow.Plane.GetPlace(axis) + slope * along) / size;
    axes[2 * i] = start.x;
    axes[2 * i + 1] = start.y;
    growth[i] = place.w * slope;
  }
  using Shape = vtkShadowLight::Shape;
  const bool sphere = light.Kind == Shape::Sphere;
  const double form = sphere ? 2.0 : (light.Kind == Shape::Rectangle ? 0.0 : 1.0);
  records.emplace_back(axes);
  records.emplace_back(glm::dvec4(growth, shadow.Spread, form));
  records.emplace_back(
    glm::dvec4((foot - shadow.Window.Low) / size, height, sphere ? glm::length(light.U) : 0.0));
  records.emplace_back(glm::dvec4(size, 0.0, 0.0));
}

//------------------------------------------------------------------------------
std::string vtkPlanarShadowMaps::GetGLSL() const
{
  if (this->Layers == 0 && this->Sides == 1)
  {
    // Nothing falls onto a plane.
    return "SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)\n"
           "{\n  return SHADOW_VISIBILITY(1.0);\n}\n";
  }
  std::string source = vtkPlanarShadowFS;
  const char* const lookUps[] = { vtkPlanarHardFS, vtkPlanarSoftFS, vtkPlanarFakeFS };
  vtkShaderProgram::Substitute(
    source, "//SHADOW::LookUp", lookUps[static_cast<int>(this->Current.Technique)]);
  const auto define = [](const char* name, std::size_t value)
  { return "#define " + std::string(name) + " " + std::to_string(value) + "\n"; };
  return define("SHADOW_PLANES", this->Planes.size()) + define("SHADOW_SIDES", this->Sides) +
         define("SHADOW_GROUPS", this->Groups) +
         define("SHADOW_RECORD_VECTORS", this->GetRecordSize()) +
         define("SHADOW_KERNEL", this->Current.Kernel) + "#define SHADOW_CHANNELS " +
         (this->Color ? "rgb\n" : "rrr\n") +
         (this->Records.AreFew() ? define("SHADOW_FEW_RECORDS", this->Records.GetCount()) : "") +
         source;
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::Activate(vtkShadowFrame& frame)
{
  this->Maps.Activate(frame.Window);
  this->Records.Activate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::Deactivate(vtkShadowFrame& frame)
{
  this->Records.Deactivate(frame.Window);
  this->Maps.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::SetParameters(vtkShaderProgram* program)
{
  program->SetUniformi("shadowPlanarMaps", this->Maps.GetUnit());
  this->Records.SetParameter(program, "shadowRecords");
}

//------------------------------------------------------------------------------
double vtkPlanarShadowMaps::GetMaximumCost() const
{
  const double taps = std::pow(this->Current.Kernel, 2);
  return this->Sides * this->Groups *
         (this->Current.Technique == Kind::Fake ? 1.0 + 2.0 * taps : 1.0);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkPlanarShadowMaps::GetBytes() const
{
  return { { "planes", this->Maps.GetBytes() + this->Records.GetBytes() },
    { "stencil", this->Stencil.GetBytes() } };
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::ReleaseTextures(vtkOpenGLRenderWindow* window)
{
  this->Maps.Release(window);
  this->Stencil.Release(window);
  this->Records.Release(window);
  this->Framebuffer.Release(window);
  for (auto& entry : this->Entries)
  {
    entry.Drawn = false;
  }
}

//------------------------------------------------------------------------------
void vtkPlanarShadowMaps::Release(vtkOpenGLRenderWindow* window)
{
  this->ReleaseTextures(window);
  this->Entries.clear();
  this->Changes.Reset();
}
