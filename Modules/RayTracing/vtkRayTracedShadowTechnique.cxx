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
  if (this->CasterVersion != frame.Casters->GetVersion())
  {
    frame.Counts["meshesBuilt"] = this->Tracer->Update(*frame.Casters);
    this->CasterVersion = frame.Casters->GetVersion();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkRayTracedShadowTechnique::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  const auto start = std::chrono::steady_clock::now();
  const auto& texels = buffer.GetReceivers().Read(frame.Window);
  std::vector<vtkShadowRayTracer::Receiver> receivers;
  receivers.reserve(texels.size());
  const glm::dmat3 turn(frame.VCToSWC);
  std::size_t notFinite = 0;
  for (std::size_t i = 0; i < texels.size(); ++i)
  {
    notFinite += texels[i].w != 0.0f && !vtkShadowReceiver::IsOne(texels[i]) ? 1 : 0;
    if (vtkShadowReceiver::IsOne(texels[i]))
    {
      const glm::dvec3 positionVC(texels[i]);
      const glm::dvec3 position(frame.VCToSWC * glm::dvec4(positionVC, 1.0));
      const vtkShadowReceiver receiver = vtkShadowReceiver::Unpack(texels[i].w);
      const double rounding =
        vtkShadowView::PositionRounding * (glm::length(positionVC) + glm::length(position));
      receivers.push_back({ position, turn * receiver.Normal, rounding,
        std::max(0.0, receiver.Rounding - rounding), static_cast<int>(i), texels[i].w > 0.0f });
    }
  }
  frame.Counts["receiversNotFinite"] = static_cast<double>(notFinite);
  const glm::dmat4 clipToSWC = glm::inverse(frame.VCToClip * frame.GetSWCToVC());
  this->Tracer->FindPositions(receivers,
    [&](int pixel)
    {
      // Through the pixel's centre, from the near plane to the far one.
      const int column = pixel % buffer.GetWidth();
      const int row = pixel / buffer.GetWidth();
      const glm::dvec2 place = 2.0 * glm::dvec2(column + 0.5, row + 0.5) /
                                 glm::dvec2(buffer.GetWidth(), buffer.GetHeight()) -
                               1.0;
      const glm::dvec4 from = clipToSWC * glm::dvec4(place, -1.0, 1.0);
      const glm::dvec4 to = clipToSWC * glm::dvec4(place, 1.0, 1.0);
      const glm::dvec3 front = glm::dvec3(from) / from.w;
      return vtkShadowRayTracer::Ray(front, glm::normalize(glm::dvec3(to) / to.w - front));
    });
  const int samples = this->Settings.GetInteger("samples");
  const int seed = this->Settings.GetInteger("seed");
  const int components = buffer.GetQuantity().empty() ? buffer.GetComponents() : 1;
  double rays = 0.0;
  for (std::size_t i = 0; i < frame.Parts.size(); ++i)
  {
    std::vector<float> values(components * texels.size(), 1.0f);
    if (!buffer.GetQuantity().empty())
    {
      const double cost = frame.Parts[i].Light.IsPoint() ? 1.0 : samples;
      for (const auto& receiver : receivers)
      {
        values[receiver.Pixel] =
          vtkShadowRayTracer::NeedsRays(frame.Parts[i].Light, frame.Casters->GetOrigin(), receiver)
            ? static_cast<float>(cost)
            : 0.0f;
      }
    }
    else
    {
      rays += this->Tracer->Trace(
        frame.Parts[i], frame.Casters->GetOrigin(), receivers, samples, seed, components, values);
    }
    buffer.GetTarget().UploadLayer(frame.Window, static_cast<int>(i), values.data());
  }
  if (buffer.GetQuantity().empty())
  {
    frame.Counts["rays"] = rays;
    frame.Counts["traceMilliseconds"] =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
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
