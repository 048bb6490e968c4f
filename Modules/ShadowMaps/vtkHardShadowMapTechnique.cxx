// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHardShadowMapTechnique.h"

//------------------------------------------------------------------------------
bool vtkHardShadowMapTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  constexpr double unlimited = 1048576.0; // megabytes: a few maps are always kept
  return this->UpdateMaps(frame, 1, unlimited);
}
