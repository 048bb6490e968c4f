// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOcclusionTextureTechnique.h"

#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"

//------------------------------------------------------------------------------
bool vtkOcclusionTextureTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  using Filter = vtkOcclusionSettings::Filter;
  constexpr int smallest = 16;
  vtkOcclusionSettings settings;
  // Without a size, what is nearest to the lights tells all: one slice, and none of its means.
  const int asked = this->Settings.GetInteger("resolution");
  settings.Resolution = asked > 0    ? frame.ChooseResolution(asked, smallest, smallest)
                        : frame.Hard ? frame.ChooseResolution(0, smallest, 2048)
                                     : frame.ChooseResolution(512, smallest, smallest);
  settings.Slices = frame.Hard ? 1 : std::stoi(this->Settings.GetChoice("slice-count"));
  settings.Combine = this->Settings.GetChoice("combine");
  if (settings.Combine != "bits")
  {
    frame.Counts["lightsTooLarge"] = frame.CountLargeLights();
  }
  const std::string prefilter = this->Settings.GetChoice("prefilter");
  settings.Prefilter = settings.Combine == "bits"   ? Filter::Bits
                       : prefilter == "summed-area" ? Filter::Sums
                       : prefilter == "mipmap"      ? Filter::Mips
                                                    : Filter::Means;
  settings.Placement = this->Settings.GetChoice("slices") == "adaptive"
                         ? vtkOcclusionSlice::Placement::Adaptive
                         : vtkOcclusionSlice::Placement::Uniform;
  settings.Twice = this->Settings.GetBoolean("double-projection");
  settings.Skipping = this->Settings.GetBoolean("skipping");
  settings.Samples = this->Settings.GetInteger("samples");
  if (!this->Textures.Update(frame, settings))
  {
    const std::string side = std::to_string(settings.Resolution);
    frame.Messages->Error("no memory for occlusion textures of " + side + " x " + side +
                          " for all lights; drawn without shadows.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOcclusionTextureTechnique::PrefersForward(const vtkShadowFrame& frame)
{
  // As vtkFilteredShadowMapTechnique: the code is long.
  return frame.Parts.size() < 2;
}

//------------------------------------------------------------------------------
std::string vtkOcclusionTextureTechnique::GetDebugQuantity(const std::string& view)
{
  return view == "kernel"        ? "shadowKernelTexels"
         : view == "slices-read" ? "shadowSlicesRead"
                                 : vtkShadowTechnique::GetDebugQuantity(view);
}

//------------------------------------------------------------------------------
void vtkOcclusionTextureTechnique::DrawDebugView(vtkShadowFrame& frame, const std::string& view)
{
  this->Textures.DrawView(frame, view == "levels");
}
