// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRayTracedShadowTechnique.h"

#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"
#include "vtkVisibilityBuffer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace
{
double GetMilliseconds(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}
}

//------------------------------------------------------------------------------
bool vtkRayTracedShadowTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  if (!this->Tracer)
  {
    this->Tracer = std::make_unique<vtkShadowRayTracer>();
    this->CasterVersion = 0;
  }
  if (!this->Tracer->GetError().empty())
  {
    frame.Messages->Warn(this->Tracer->GetError() + "; drawn without shadows.");
    return false;
  }
  frame.Counts["meshesBuilt"] = 0;
  vtkShadowRayTracer::Options options;
  options.Packet = std::stoi(this->Settings.GetChoice("packet"));
  const std::string structure = this->Settings.GetChoice("structure");
  options.Structure = structure == "flat"   ? vtkShadowRayTracer::Structure::Flat
                      : structure == "auto" ? vtkShadowRayTracer::Structure::Automatic
                                            : vtkShadowRayTracer::Structure::Instanced;
  if (this->CasterVersion != frame.Casters->GetVersion() || !(options == this->Options))
  {
    frame.Counts["meshesBuilt"] = this->Tracer->Update(*frame.Casters, options);
    this->CasterVersion = frame.Casters->GetVersion();
    this->Options = options;
  }
  frame.Counts["flatStructure"] = this->Tracer->IsFlat() ? 1 : 0;
  return true;
}

//------------------------------------------------------------------------------
vtkShadowRayReceiver vtkRayTracedShadowTechnique::MakeReceiver(
  const vtkShadowFrame& frame, const glm::vec4& texel, int pixel)
{
  const glm::dvec3 positionVC(texel);
  const glm::dvec3 position(frame.VCToSWC * glm::dvec4(positionVC, 1.0));
  const vtkShadowReceiver receiver = vtkShadowReceiver::Unpack(texel.w);
  const double rounding =
    vtkShadowView::PositionRounding * (glm::length(positionVC) + glm::length(position));
  return { position, glm::dmat3(frame.VCToSWC) * receiver.Normal, rounding,
    std::max(0.0, receiver.Rounding - rounding), pixel, texel.w > 0.0f };
}

//------------------------------------------------------------------------------
void vtkRayTracedShadowTechnique::FindPositions(
  const vtkShadowFrame& frame, int width, int height, Receivers& receivers) const
{
  const glm::dmat4 clipToSWC = glm::inverse(frame.VCToClip * frame.GetSWCToVC());
  this->Tracer->FindPositions(receivers,
    [&](int pixel)
    {
      // Through the pixel's centre, from the near plane to the far one.
      const glm::dvec2 centre = glm::dvec2(pixel % width, pixel / width) + 0.5;
      const glm::dvec2 place = 2.0 * centre / glm::dvec2(width, height) - 1.0;
      const glm::dvec4 from = clipToSWC * glm::dvec4(place, -1.0, 1.0);
      const glm::dvec4 to = clipToSWC * glm::dvec4(place, 1.0, 1.0);
      const glm::dvec3 front = glm::dvec3(from) / from.w;
      return vtkShadowRayTracer::Ray(front, glm::normalize(glm::dvec3(to) / to.w - front));
    });
}

//------------------------------------------------------------------------------
vtkShadowRayTracer::Target vtkRayTracedShadowTechnique::GetTarget(
  const vtkShadowFrame& frame, std::size_t part, const std::vector<int>& steps) const
{
  return { frame.Parts[part], frame.Casters->GetOrigin(), steps,
    this->Settings.GetInteger("seed") };
}

//------------------------------------------------------------------------------
void vtkRayTracedShadowTechnique::CountRays(vtkShadowFrame& frame, double rays, double milliseconds)
{
  frame.Counts["rays"] += rays;
  frame.Counts["traceMilliseconds"] += milliseconds;
  const double time = frame.Counts["traceMilliseconds"];
  frame.Counts["megaraysPerSecond"] = time > 0.0 ? frame.Counts["rays"] / (1e3 * time) : 0.0;
}

//------------------------------------------------------------------------------
void vtkRayTracedShadowTechnique::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  const auto& texels = buffer.GetReceivers().Read(frame.Window);
  Receivers receivers;
  receivers.reserve(texels.size());
  std::size_t notFinite = 0;
  for (std::size_t i = 0; i < texels.size(); ++i)
  {
    const bool isOne = vtkShadowReceiver::IsOne(texels[i]);
    notFinite += texels[i].w != 0.0f && !isOne ? 1 : 0;
    if (isOne)
    {
      receivers.push_back(MakeReceiver(frame, texels[i], static_cast<int>(i)));
    }
  }
  frame.Counts["receiversNotFinite"] = static_cast<double>(notFinite);
  this->FindPositions(frame, buffer.GetWidth(), buffer.GetHeight(), receivers);
  std::vector<int> all(receivers.size());
  std::iota(all.begin(), all.end(), 0);
  const int samples = this->Settings.GetInteger("samples");
  const bool counts = !buffer.GetQuantity().empty();
  const int components = counts ? 1 : buffer.GetComponents();
  for (std::size_t i = 0; i < frame.Parts.size(); ++i)
  {
    const vtkShadowRayTracer::Target target = this->GetTarget(frame, i, { samples });
    const vtkShadowLight& light = frame.Parts[i].Light;
    std::vector<vtkShadowRaySeen> seen(receivers.size());
    if (!counts)
    {
      const auto start = std::chrono::steady_clock::now();
      const double rays = this->Tracer->Trace(target, receivers, all, samples, seen);
      CountRays(frame, rays, GetMilliseconds(start));
    }
    std::vector<float> values(components * texels.size(), 1.0f);
    const float cost = light.IsPoint() ? 1.0f : static_cast<float>(samples);
    for (std::size_t k = 0; k < receivers.size(); ++k)
    {
      float* value = &values[static_cast<std::size_t>(components) * receivers[k].Pixel];
      if (counts)
      {
        *value = vtkShadowRayTracer::NeedsRays(light, target.Origin, receivers[k]) ? cost : 0.0f;
        continue;
      }
      const glm::vec3 visibility = seen[k].GetVisibility(light.Emission != nullptr);
      for (int c = 0; c < std::min(components, 3); ++c)
      {
        value[c] = visibility[c];
      }
    }
    buffer.GetTarget().UploadLayer(frame.Window, static_cast<int>(i), values.data());
  }
}

//------------------------------------------------------------------------------
double vtkRayTracedShadowTechnique::GetMaximumCost()
{
  return this->Settings.GetInteger("samples");
}

//------------------------------------------------------------------------------
void vtkRayTracedShadowTechnique::Release(vtkOpenGLRenderWindow*)
{
  this->Tracer.reset();
  this->CasterVersion = 0;
}
