// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOcclusionTextures.h"

#include "vtkOcclusionCopyFS.h"
#include "vtkOcclusionMeanFS.h"
#include "vtkOcclusionPackFS.h"
#include "vtkOcclusionSliceFS.h"
#include "vtkOcclusionSliceVS.h"
#include "vtkOcclusionSumFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterDrawing.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace
{
using Format = vtkShadowTexture::Format;

/** Texels around what a window has to hold: those at the very border stay empty. */
constexpr int Border = 2;

/** N-buffers and mipmaps hold what kernels can reach beyond, as a share of the widest. */
constexpr double Padding = 1.5;

/** Their texels follow the light's form up to this ratio of its sides. */
constexpr double MostAspect = 8.0;

/** The texture's shorter side is a multiple of this share of the longer one. */
constexpr int SideSteps = 8;

/** The stages of a summed-area table along an axis. */
constexpr int SumStages = 3;
}

//------------------------------------------------------------------------------
bool vtkOcclusionSettings::operator==(const vtkOcclusionSettings& other) const
{
  const auto tie = [](const vtkOcclusionSettings& s)
  {
    return std::tie(
      s.Resolution, s.Slices, s.Prefilter, s.Placement, s.Twice, s.Skipping, s.Samples, s.Combine);
  };
  return tie(*this) == tie(other);
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::FitWindow(Set& set) const
{
  const bool padded =
    this->Current.Prefilter == Filter::Means || this->Current.Prefilter == Filter::Mips;
  glm::dvec2 kernel(0.0); // half sides
  for (const auto& slice : set.Slices)
  {
    kernel = glm::max(kernel, set.View.GetKernel(slice.Plane));
  }
  const glm::dvec2 pad = padded ? Padding * kernel : glm::dvec2(0.0);
  const glm::dvec2 size = set.View.High - set.View.Low + 2.0 * pad;
  // Square boxes are to be of the light's form: texels are.
  const double longest = std::max({ kernel.x, kernel.y, 1e-300 });
  const double least = std::min(kernel.x / size.x, kernel.y / size.y);
  const glm::dvec2 form = padded && 2.0 * least * this->Current.Resolution >= 1.0
                            ? glm::max(kernel / longest, glm::dvec2(1.0 / MostAspect))
                            : glm::dvec2(1.0); // within a texel
  const glm::dvec2 inner = glm::dvec2(this->Current.Resolution - 2 * Border);
  const glm::dvec2 reach = glm::max(glm::abs(set.View.Low), glm::abs(set.View.High));
  const glm::dvec2 sides = size / form / inner;
  const double texel = std::max({ sides.x, sides.y, 1e-7 * std::max(reach.x, reach.y),
    std::numeric_limits<float>::min() * 1e6 });
  set.Texel = texel * form;
  const glm::dvec2 texels = glm::ceil(size / set.Texel - 1e-6);
  set.Size = glm::min(glm::ivec2(texels) + 2 * Border, glm::ivec2(this->Current.Resolution));
  set.Low = 0.5 * (set.View.Low + set.View.High) - 0.5 * glm::dvec2(set.Size) * set.Texel;
  const glm::dvec2 most = 2.0 * kernel / set.Texel;
  set.Kernel = std::max(most.x, most.y);
}

//------------------------------------------------------------------------------
std::vector<vtkOcclusionTextures::Set> vtkOcclusionTextures::MakeSets(
  vtkShadowFrame& frame, int part) const
{
  std::vector<Set> sets;
  for (auto& view :
    vtkOcclusionView::Find(frame.Parts[part], *frame.Casters, this->Current.Resolution))
  {
    Set set;
    set.Part = part;
    set.View = std::move(view);
    set.Slices = vtkOcclusionSlice::Place(
      set.View, *frame.Casters, this->Current.Slices, this->Current.Placement);
    if (!set.Slices.empty())
    {
      this->FitWindow(set);
      sets.push_back(std::move(set));
    }
  }
  return sets;
}

//------------------------------------------------------------------------------
int vtkOcclusionTextures::GetLayer(int set, int target, int level) const
{
  const int levels = level % 2 ? this->GetOddLevels() : this->GetEvenLevels();
  return (set * this->Targets + target) * levels + level / 2;
}

//------------------------------------------------------------------------------
bool vtkOcclusionTextures::Update(vtkShadowFrame& frame, const vtkOcclusionSettings& settings)
{
  this->Changes.Update(frame, !(settings == this->Current) || !this->Nearest.GetHandle());
  const bool all = this->Changes.IsAll();
  this->Current = settings;
  this->Color = frame.Color;
  this->Hard = frame.Hard;
  std::vector<Set> sets;
  std::vector<int> first;
  std::vector<bool> changed;
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    first.push_back(static_cast<int>(sets.size()));
    std::vector<Set> made;
    bool same = this->Changes.IsSame(i);
    if (same)
    {
      made.assign(this->Sets.begin() + this->First[i], this->Sets.begin() + this->First[i + 1]);
    }
    if (!same || this->Changes.HaveReceiversMoved())
    {
      auto anew = this->MakeSets(frame, i);
      // Receivers matter only where they change what is seen.
      same = same && anew.size() == made.size() &&
             std::equal(anew.begin(), anew.end(), made.begin(),
               [](const Set& a, const Set& b)
               {
                 return a.View.Casters == b.View.Casters && a.Low == b.Low && a.Texel == b.Texel &&
                        a.Size == b.Size && a.Kernel == b.Kernel;
               });
      made = std::move(anew);
    }
    const bool moved = all || first.back() != this->First[i];
    for (auto& set : made)
    {
      sets.push_back(std::move(set));
      changed.push_back(!same || moved);
    }
  }
  first.push_back(static_cast<int>(sets.size()));
  this->Sets = std::move(sets);
  this->First = std::move(first);

  const unsigned long before = this->Nearest.GetGeneration();
  const int targetsBefore = this->Targets;
  const int levelsBefore = this->Levels;
  if (!this->Allocate(frame))
  {
    this->Release(frame.Window);
    return false;
  }
  const bool fresh = before != this->Nearest.GetGeneration() || targetsBefore != this->Targets ||
                     levelsBefore != this->Levels;
  frame.Counts["slicesDrawn"] = 0;
  frame.Counts["mapsDrawn"] = 0;
  std::size_t slices = 0;
  for (const auto& set : this->Sets)
  {
    slices += set.Slices.size();
  }
  for (int i = 0; i < static_cast<int>(this->Sets.size()); ++i)
  {
    if (fresh || changed[i])
    {
      this->Draw(frame, i);
      this->Make(frame, i, 1);
      frame.Counts["mapsDrawn"] += 1;
      frame.Counts["slicesDrawn"] += static_cast<double>(this->Sets[i].Slices.size());
    }
  }
  if (settings.Prefilter == Filter::Mips && frame.Counts["mapsDrawn"] > 0)
  {
    this->Mips.MakeLevels(frame.Window);
  }
  frame.Counts["slices"] = static_cast<double>(slices);
  frame.Counts["levels"] =
    settings.Prefilter == Filter::Means || settings.Prefilter == Filter::Mips ? this->Levels : 1;
  this->UpdateSamples(frame);
  this->UpdateVectors(frame);
  return true;
}

//------------------------------------------------------------------------------
bool vtkOcclusionTextures::Allocate(vtkShadowFrame& frame)
{
  vtkOpenGLRenderWindow* window = frame.Window;
  glm::ivec2 size(1);
  double kernel = 1.0;
  this->MostInSet = 1;
  for (const auto& set : this->Sets)
  {
    size = glm::max(size, set.Size);
    kernel = std::max(kernel, set.Kernel);
    this->MostInSet = std::max(this->MostInSet, static_cast<int>(set.Slices.size()));
  }
  const int step = std::max(1, this->Current.Resolution / SideSteps);
  size = this->Sets.empty()
           ? size
           : glm::min((size + step - 1) / step * step, glm::ivec2(this->Current.Resolution));
  this->Targets = (this->MostInSet + 3) / 4;
  // The widest kernel lies between two levels; a mipmap ends at one texel.
  this->Levels = 1 + static_cast<int>(std::ceil(std::log2(kernel) - 1e-9));
  const int sets = std::max(1, static_cast<int>(this->Sets.size()));
  const Filter filter = this->Current.Prefilter;
  if (filter == Filter::Mips)
  {
    this->Levels =
      std::min(this->Levels, 1 + static_cast<int>(std::floor(std::log2(std::max(size.x, size.y)))));
  }
  int most = 256;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
  const auto allocate =
    [&](vtkShadowTexture& texture, Format format, int layers, bool wanted, int levels = 1)
  {
    if (!wanted)
    {
      texture.Release(window);
      return true;
    }
    return layers <= most && texture.Allocate(window, format, size.x, size.y, layers, levels);
  };
  bool made = allocate(this->Nearest, Format::Float1, sets, true);
  for (int i = 0; i < 4; ++i)
  {
    made = made && allocate(this->Slices[i], Format::Byte4, sets, i < this->Targets);
  }
  const int layers = sets * this->Targets;
  made =
    made &&
    allocate(this->Even, Format::Byte4, layers * this->GetEvenLevels(), filter == Filter::Means) &&
    allocate(this->Odd, Format::Byte4, layers * this->GetOddLevels(), filter == Filter::Means) &&
    allocate(this->Mips, Format::Byte4, layers, filter == Filter::Mips, this->Levels) &&
    allocate(this->Sums, Format::Integer4, layers, filter == Filter::Sums) &&
    allocate(this->Steps[0], Format::Integer4, 1, filter == Filter::Sums) &&
    allocate(this->Steps[1], Format::Integer4, 1, filter == Filter::Sums) &&
    allocate(this->Bits, Format::Integer1, sets, filter == Filter::Bits);
  if (made)
  {
    for (auto* texture : { &this->Even, &this->Odd, &this->Mips })
    {
      if (texture->GetHandle())
      {
        texture->SetSampling(window, vtkShadowTexture::Sampling::Linear);
      }
    }
  }
  return made;
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::Draw(vtkShadowFrame& frame, int index)
{
  vtkShadowTimers::Scope timer(*frame.Timers, "slices");
  const Set& set = this->Sets[index];
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullFace(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  std::vector<const vtkShadowTexture*> targets;
  for (int i = 0; i < this->Targets; ++i)
  {
    targets.push_back(&this->Slices[i]);
  }
  targets.push_back(&this->Nearest);
  vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, targets, nullptr, index);
  const float empty[] = { 0.0f, 0.0f, 0.0f, 0.0f };
  for (int i = 0; i <= this->Targets; ++i)
  {
    glClearBufferfv(GL_COLOR, i, empty);
  }
  target.SetRectangle(0, 0, set.Size.x, set.Size.y);
  state->vtkglScissor(1, 1, set.Size.x - 2, set.Size.y - 2);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_MAX);
  float cuts[MostSlices] = {};
  const int count = static_cast<int>(set.Slices.size());
  for (int i = 0; i + 1 < count; ++i)
  {
    cuts[i] = static_cast<float>(0.5 * (set.Slices[i].Plane + set.Slices[i + 1].Top));
  }
  const glm::dvec2 range = set.View.GetClipRange();
  const float form[] = { set.View.Directional ? 0.0f : 1.0f, static_cast<float>(set.View.Behind),
    static_cast<float>(1.0 / (range.y - range.x)), static_cast<float>(range.y) };
  vtkShadowCasterDraw how;
  how.VertexShader = vtkOcclusionSliceVS;
  how.FragmentShader = vtkOcclusionSliceFS;
  how.Definitions = "#define SHADOW_TARGETS " + std::to_string(this->Targets) + "\n";
  how.SetParameters = [&](vtkShaderProgram* program)
  {
    program->SetUniform4f("shadowForm", form);
    program->SetUniformi("shadowSlices", count);
    program->SetUniformi("shadowTwice", this->Current.Twice);
    program->SetUniform1fv("shadowCuts", MostSlices, cuts);
  };
  const glm::dvec4 depthRow(set.View.Z, -glm::dot(set.View.Z, set.View.Place));
  how.SetCasterParameters = [&](vtkShaderProgram* program, const vtkShadowCaster& caster)
  {
    const glm::vec4 row(depthRow * caster.MeshToSWC);
    program->SetUniform4f("shadowDepthMC", &row.x);
  };
  const glm::dmat4 SWCToClip =
    set.View.GetSWCToClip(set.Low, set.Low + glm::dvec2(set.Size) * set.Texel);
  frame.Drawing->Draw(frame.Window, SWCToClip, set.View.Casters, how);
  state->vtkglBlendEquation(GL_FUNC_ADD);
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::Make(vtkShadowFrame& frame, int first, int count)
{
  vtkShadowTimers::Scope timer(*frame.Timers, "prefilter");
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  for (int i = first; i < first + count; ++i)
  {
    switch (this->Current.Prefilter)
    {
      case Filter::Means:
        this->MakeMeans(frame, i);
        break;
      case Filter::Sums:
        this->MakeSums(frame, i);
        break;
      case Filter::Bits:
        this->MakeBits(frame, i);
        break;
      case Filter::Mips:
        for (int k = 0; k < this->Targets; ++k)
        {
          this->DrawCopy(frame, this->Mips, i * this->Targets + k, i, k);
        }
    }
  }
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::DrawCopy(
  vtkShadowFrame& frame, vtkShadowTexture& texture, int layer, int set, int slices)
{
  vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, &texture, nullptr, layer);
  vtkShadowTexture& source = this->Slices[slices];
  source.Activate(frame.Window);
  frame.Quad->Draw(frame.Window, vtkOcclusionCopyFS,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowSource", source.GetUnit());
      program->SetUniformi("shadowLayer", set);
    });
  source.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::MakeMeans(vtkShadowFrame& frame, int set)
{
  for (int k = 0; k < this->Targets; ++k)
  {
    this->DrawCopy(frame, this->Even, this->GetLayer(set, k, 0), set, k);
    for (int level = 1; level < this->Levels; ++level)
    {
      vtkShadowTexture& source = this->GetLevel(level - 1);
      vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, &this->GetLevel(level),
        nullptr, this->GetLayer(set, k, level));
      source.Activate(frame.Window);
      const int half = level == 1 ? 1 : 1 << (level - 2);
      const int offsets[] = { -half, level == 1 ? 0 : half };
      frame.Quad->Draw(frame.Window, vtkOcclusionMeanFS,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi("shadowSource", source.GetUnit());
          program->SetUniformi("shadowLayer", this->GetLayer(set, k, level - 1));
          program->SetUniform2i("shadowOffsets", offsets);
        });
      source.Deactivate(frame.Window);
    }
  }
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::MakeSums(vtkShadowFrame& frame, int set)
{
  std::string firstSource = vtkOcclusionSumFS;
  vtkShaderProgram::Substitute(
    firstSource, "#ifdef SHADOW_FIRST", "#define SHADOW_FIRST\n#ifdef SHADOW_FIRST", false);
  for (int k = 0; k < this->Targets; ++k)
  {
    vtkShadowTexture* source = &this->Slices[k];
    for (int pass = 0; pass < 2 * SumStages; ++pass)
    {
      const int axis = pass / SumStages;
      const int side = axis == 0 ? this->Sums.GetWidth() : this->Sums.GetHeight();
      const int taps = static_cast<int>(std::ceil(std::cbrt(static_cast<double>(side)) - 1e-9));
      int stride[] = { 0, 0 };
      stride[axis] = 1;
      for (int i = 0; i < pass % SumStages; ++i)
      {
        stride[axis] *= taps;
      }
      const bool last = pass + 1 == 2 * SumStages;
      vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer,
        last ? &this->Sums : &this->Steps[pass % 2], nullptr, last ? set * this->Targets + k : 0);
      source->Activate(frame.Window);
      frame.Quad->Draw(frame.Window, pass == 0 ? firstSource : vtkOcclusionSumFS,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi("shadowSource", source->GetUnit());
          program->SetUniformi("shadowLayer", pass == 0 ? set : 0);
          program->SetUniform2i("shadowStride", stride);
          program->SetUniformi("shadowTaps", taps);
        });
      source->Deactivate(frame.Window);
      source = &this->Steps[pass % 2];
    }
  }
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::MakeBits(vtkShadowFrame& frame, int set)
{
  std::string text = vtkOcclusionPackFS;
  vtkShaderProgram::Substitute(text, "uniform sampler2DArray shadowSource0",
    "#define SHADOW_TARGETS " + std::to_string(this->Targets) +
      "\nuniform sampler2DArray shadowSource0");
  vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, &this->Bits, nullptr, set);
  for (int i = 0; i < this->Targets; ++i)
  {
    this->Slices[i].Activate(frame.Window);
  }
  frame.Quad->Draw(frame.Window, text,
    [&](vtkShaderProgram* program)
    {
      for (int i = 0; i < 4; ++i)
      {
        program->SetUniformi(("shadowSource" + std::to_string(i)).c_str(),
          this->Slices[std::min(i, this->Targets - 1)].GetUnit());
      }
      program->SetUniformi("shadowLayer", set);
    });
  for (int i = 0; i < this->Targets; ++i)
  {
    this->Slices[i].Deactivate(frame.Window);
  }
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::Release(vtkOpenGLRenderWindow* window)
{
  for (auto& texture : this->Slices)
  {
    texture.Release(window);
  }
  for (auto* texture : { &this->Nearest, &this->Even, &this->Odd, &this->Mips, &this->Sums,
         &this->Steps[0], &this->Steps[1], &this->Bits })
  {
    texture->Release(window);
  }
  this->Vectors.Release(window);
  this->Samples.Release(window);
  this->Framebuffer.Release(window);
  this->Sets.clear();
  this->First.clear();
  this->Changes.Reset();
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkOcclusionTextures::GetBytes() const
{
  std::size_t slices = this->Nearest.GetBytes();
  for (const auto& texture : this->Slices)
  {
    slices += texture.GetBytes();
  }
  std::size_t filtered = 0;
  for (const auto* texture : { &this->Even, &this->Odd, &this->Mips, &this->Sums, &this->Steps[0],
         &this->Steps[1], &this->Bits })
  {
    filtered += texture->GetBytes();
  }
  return { { "slices", slices }, { "prefilter", filtered },
    { "sets", this->Vectors.GetBytes() + this->Samples.GetBytes() } };
}
