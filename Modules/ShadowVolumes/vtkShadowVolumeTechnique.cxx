// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolumeTechnique.h"

#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"
#include "vtkVisibilityBuffer.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkShadowVolumeTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  using Counting = vtkShadowVolumeSettings::Counting;
  vtkShadowVolumeSettings settings;
  const std::string counting = this->Settings.GetChoice("counting");
  settings.Method = counting == "z-pass"   ? Counting::ZPass
                    : counting == "z-fail" ? Counting::ZFail
                    : counting == "xor"    ? Counting::Xor
                                           : Counting::Auto;
  if (this->Settings.Has("samples"))
  {
    settings.Silhouettes.Samples = this->Settings.GetInteger("samples");
    settings.Silhouettes.MemoryLimit = std::size_t(1048576) * this->Settings.GetInteger("memory");
  }
  this->Volumes.Update(frame, settings);
  if (const std::size_t count = frame.Casters->GetNumberWithHoles())
  {
    frame.Messages->Warn(
      std::to_string(count) +
      " casters have holes by alpha within their triangles, which silhouettes do not "
      "know: only triangles that are clear all over cast nothing.");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowVolumeTechnique::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  const bool cost = !buffer.GetQuantity().empty();
  this->MostFaces = 0.0;
  const bool counts = this->Volumes.UpdateDepth(frame, buffer);
  bool whole = true;
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    const int samples = counts ? static_cast<int>(this->Volumes.GetSamples(i).size()) : 0;
    for (int sample = 0; sample < samples; ++sample)
    {
      if (cost)
      {
        this->Volumes.AddFaces(frame, buffer, i, sample);
      }
      else
      {
        whole = this->Volumes.Subtract(frame, buffer, i, sample) && whole;
      }
    }
    if (cost)
    {
      const auto faces = buffer.ReadTarget(frame.Window, i);
      this->MostFaces =
        std::max<double>(this->MostFaces, *std::max_element(faces.begin(), faces.end()));
    }
  }
  const std::string size =
    std::to_string(buffer.GetWidth()) + " x " + std::to_string(buffer.GetHeight()) + " pixels";
  if (!counts)
  {
    frame.Messages->Error("no memory for the depth of " + size + "; drawn without shadows.");
  }
  else if (!whole)
  {
    frame.Messages->Error("no memory for wide counts of " + size +
                          "; where a multiple of 256 volumes nest, they are drawn as light.");
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumeTechnique::DrawDebugView(vtkShadowFrame& frame, const std::string&)
{
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    if (!this->Volumes.GetSamples(i).empty())
    {
      this->Volumes.DrawView(frame, i, 0);
    }
  }
}
