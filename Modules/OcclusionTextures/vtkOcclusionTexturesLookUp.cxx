// SPDX-License-Identifier: BSD-3-Clause
// What shaders are told of occlusion textures.

#include "vtkOcclusionTextures.h"

#include "vtkOcclusionBitsFS.h"
#include "vtkOcclusionCombineFS.h"
#include "vtkOcclusionFilterFS.h"
#include "vtkOcclusionLookUpFS.h"
#include "vtkOcclusionViewFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSampling.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
/** Vectors of a view, and of each slice: see vtkOcclusionLookUpFS.glsl. */
constexpr int Header = 9;

/** So many are uniforms. */
constexpr std::size_t MostFewVectors = 128;

}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::UpdateVectors(vtkShadowFrame& frame)
{
  const int vectors = Header + 2 * this->MostInSet;
  auto& values = this->Vectors.Get();
  values.assign(std::max<std::size_t>(1, this->Sets.size() * vectors), glm::vec4(0.0f));
  const glm::dmat4 toSWC = frame.VCToSWC;
  std::size_t next = 0;
  for (const auto& set : this->Sets)
  {
    const vtkOcclusionView& view = set.View;
    glm::vec4* v = &values[next];
    next += vectors;
    const glm::dvec3 axes[] = { view.X, view.Y, view.Z };
    for (int c = 0; c < 3; ++c)
    {
      const glm::dvec4 row(axes[c], -glm::dot(axes[c], view.Place));
      v[c] = glm::vec4(row * toSWC); // the row times the matrix
    }
    const int count = static_cast<int>(set.Slices.size());
    v[3] = glm::vec4(view.Directional ? 0.0f : 1.0f, static_cast<float>(view.Behind),
      static_cast<float>(count), view.Face ? 1.0f : 0.0f);
    v[4] = glm::vec4(glm::dvec4(set.Low, 1.0 / set.Texel));
    v[5] = glm::vec4(glm::dvec4(set.Texel, glm::dvec2(set.Size)));
    const vtkShadowLight& light = frame.Parts[set.Part].Light;
    using Shape = vtkShadowLight::Shape;
    const bool rectangle = light.Kind == Shape::Rectangle;
    // The half side of a square of the same second moments as a disk.
    const bool exact = rectangle || this->Current.Prefilter == Filter::Bits;
    const double side = exact ? 1.0 : std::sqrt(0.75);
    const auto axis = [&](const glm::dvec3& a, double w) {
      return glm::vec4(
        glm::dvec4(glm::dot(a, view.X), glm::dot(a, view.Y), glm::dot(a, view.Z), w));
    };
    const double radius = light.Kind == Shape::Sphere ? side * glm::length(light.U) : 0.0;
    v[6] = axis(side * light.U, radius);
    v[7] = axis(side * light.V, rectangle ? 2.0 : 1.0);
    const glm::dvec2 range = view.GetClipRange();
    v[8] =
      glm::vec4(glm::dvec4(range.y, view.Directional ? 1.0 / (range.y - range.x) : 0.0, 0.0, 0.0));
    for (int i = 0; i < count; ++i)
    {
      const vtkOcclusionSlice& slice = set.Slices[i];
      // Rounded like the rest: an infinite rate would be no number times 0.
      v[Header + 2 * i] = glm::vec4(glm::dvec4(slice.Plane, 1.0 / slice.Fade,
        view.Directional ? -slice.Plane : 1.0 / view.GetW(slice.Plane), slice.Top));
      // A texel counts where its middle is covered.
      v[Header + 2 * i + 1] = glm::vec4(glm::dvec4(
        (slice.Low - set.Low) / set.Texel - 0.51, (slice.High - set.Low) / set.Texel + 0.51));
    }
  }
  this->Vectors.Update(frame.Window, values.size() <= MostFewVectors);
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::UpdateSamples(vtkShadowFrame& frame)
{
  auto& values = this->Samples.Get();
  values.clear();
  const int count = this->Current.Samples;
  for (const auto& part : frame.Parts)
  {
    const std::size_t first = values.size();
    glm::dvec3 sum(0.0);
    for (const auto bits : vtkShadowSampling::Sobol(count))
    {
      // As vtkShadowLight::GetSamples.
      glm::dvec2 unit = vtkShadowSampling::ToUnit(bits) + 0.5 / count;
      unit -= glm::floor(unit);
      values.emplace_back(glm::dvec4(2.0 * unit - 1.0, vtkShadowSampling::ConcentricDisk(unit)));
      const glm::dvec3 emission = part.Light.GetEmission(unit);
      sum += emission;
      values.emplace_back(glm::dvec4(emission, 0.0));
    }
    for (std::size_t i = first + 1; i < values.size(); i += 2)
    {
      for (int c = 0; c < 3; ++c)
      {
        values[i][c] = static_cast<float>(sum[c] > 0.0 ? values[i][c] / sum[c] : 1.0 / count);
      }
    }
  }
  this->Samples.Update(frame.Window, this->Current.Prefilter != Filter::Bits);
}

//------------------------------------------------------------------------------
std::string vtkOcclusionTextures::GetGLSL() const
{
  const Filter filter = this->Current.Prefilter;
  const auto define = [](const std::string& name, const std::string& value = "")
  { return "#define " + name + " " + value + "\n"; };
  std::string source = define("SHADOW_SET_VECTORS", std::to_string(Header + 2 * this->MostInSet)) +
                       define("SHADOW_TARGETS", std::to_string(this->Targets)) +
                       define("SHADOW_LEVELS", std::to_string(this->Levels)) +
                       define("SHADOW_CONTACTS", std::to_string(this->GetContacts()));
  if (this->Vectors.AreFew())
  {
    source += define("SHADOW_FEW_SETS", std::to_string(this->Vectors.GetCount()));
  }
  source += this->Current.Skipping ? define("SHADOW_SKIPPING") : "";
  source += this->Current.Twice ? define("SHADOW_TWICE") : "";
  source += this->Current.Combine == "max"   ? define("SHADOW_MAXIMUM")
            : this->Current.Combine == "sum" ? define("SHADOW_SUM")
                                             : define("SHADOW_PRODUCT");
  switch (filter)
  {
    case Filter::Sums:
      source +=
        define("SHADOW_SUMS") + define("SHADOW_REACH", "1.0") + define("SHADOW_BORDER", "1.03");
      break;
    case Filter::Means:
      source +=
        define("SHADOW_MEANS") + define("SHADOW_REACH", "2.0") + define("SHADOW_BORDER", "2.0");
      break;
    case Filter::Mips:
      source +=
        define("SHADOW_MIPS") + define("SHADOW_REACH", "6.0") + define("SHADOW_BORDER", "3.0");
      break;
    case Filter::Bits:
      source += define("SHADOW_BITS") + define("SHADOW_BORDER", "0.53");
  }
  return source + vtkOcclusionLookUpFS +
         (filter == Filter::Bits ? vtkOcclusionBitsFS : vtkOcclusionFilterFS) +
         vtkOcclusionCombineFS;
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::SetParameters(vtkShaderProgram* program)
{
  int first[vtkShadowFrame::MostParts] = {};
  int end[vtkShadowFrame::MostParts] = {};
  const int parts = std::max(1, static_cast<int>(this->First.size()) - 1);
  for (int i = 0; i + 1 < static_cast<int>(this->First.size()); ++i)
  {
    first[i] = this->First[i];
    end[i] = this->First[i + 1];
  }
  program->SetUniform1iv("shadowFirstSet", parts, first);
  program->SetUniform1iv("shadowEndOfSets", parts, end);
  this->Vectors.SetParameter(program, "shadowSets");
  program->SetUniformi("shadowNearest", this->Nearest.GetUnit());
  switch (this->Current.Prefilter)
  {
    case Filter::Sums:
      program->SetUniformi("shadowSums", this->Sums.GetUnit());
      break;
    case Filter::Means:
      program->SetUniformi("shadowEvenLevels", this->Even.GetUnit());
      program->SetUniformi("shadowOddLevels", this->Odd.GetUnit());
      break;
    case Filter::Mips:
      program->SetUniformi("shadowMips", this->Mips.GetUnit());
      break;
    case Filter::Bits:
      program->SetUniformi("shadowBits", this->Bits.GetUnit());
      this->Samples.SetParameter(program, "shadowSamples");
      program->SetUniformi("shadowSampleCount", this->Current.Samples);
  }
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::Activate(vtkShadowFrame& frame)
{
  for (auto* texture :
    { &this->Nearest, &this->Even, &this->Odd, &this->Mips, &this->Sums, &this->Bits })
  {
    if (texture->GetHandle())
    {
      texture->Activate(frame.Window);
    }
  }
  this->Vectors.Activate(frame.Window);
  this->Samples.Activate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::Deactivate(vtkShadowFrame& frame)
{
  this->Samples.Deactivate(frame.Window);
  this->Vectors.Deactivate(frame.Window);
  for (auto* texture :
    { &this->Bits, &this->Sums, &this->Mips, &this->Odd, &this->Even, &this->Nearest })
  {
    texture->Deactivate(frame.Window);
  }
}

//------------------------------------------------------------------------------
double vtkOcclusionTextures::GetMaximumCost() const
{
  const double each = this->Current.Prefilter == Filter::Sums   ? 16.0
                      : this->Current.Prefilter == Filter::Bits ? this->Current.Samples
                                                                : 2.0;
  return this->GetContacts() + each * this->MostInSet;
}

//------------------------------------------------------------------------------
void vtkOcclusionTextures::DrawView(vtkShadowFrame& frame, bool levels)
{
  int viewport[4];
  frame.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const int count = this->Sets.empty() ? 0 : static_cast<int>(this->Sets.front().Slices.size());
  const bool means = levels && this->Current.Prefilter == Filter::Means;
  const int level = means ? this->Levels - 1 : 0;
  for (int target = 0; target < this->Targets; ++target)
  {
    vtkShadowTexture& source = means ? this->GetLevel(level) : this->Slices[target];
    source.Activate(frame.Window);
    frame.Quad->Draw(frame.Window, vtkOcclusionViewFS,
      [&](vtkShaderProgram* program)
      {
        program->SetUniformi("shadowSource", source.GetUnit());
        program->SetUniform2i("shadowViewportOrigin", viewport);
        program->SetUniform2i("shadowViewportSize", viewport + 2);
        program->SetUniformi(
          "shadowColumns", std::max(1, static_cast<int>(std::ceil(std::sqrt(count)))));
        program->SetUniformi("shadowCount", count);
        program->SetUniformi("shadowTarget", target);
        program->SetUniformi("shadowLayer", means ? this->GetLayer(0, target, level) : 0);
        const glm::vec2 share = count > 0 ? glm::vec2(this->Sets.front().Size) /
                                              glm::vec2(source.GetWidth(), source.GetHeight())
                                          : glm::vec2(1.0f);
        program->SetUniform2f("shadowShare", &share.x);
      });
    source.Deactivate(frame.Window);
  }
}
