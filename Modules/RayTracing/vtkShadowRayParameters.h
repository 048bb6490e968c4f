// SPDX-License-Identifier: BSD-3-Clause
// Parameters that ray-traced techniques share.

#ifndef vtkShadowRayParameters_h
#define vtkShadowRayParameters_h

#include "vtkShadowParameter.h"

#include <vector>

namespace vtkShadowRayParameters
{
inline std::vector<vtkShadowParameter> Get()
{
  return { vtkShadowParameter::Integer(
             "samples", 64, 1, 16384, "Rays from each pixel to each light")
             .In("rays")
             .At({ 4, 16, 64, 1024 })
             .AtPreview(1),
    vtkShadowParameter::Integer("seed", 0, 0, 65535,
      "Another seed gives other rays: how two pictures differ tells their noise"),
    vtkShadowParameter::Choice("packet", "16", { "1", "4", "8", "16" },
      "Rays that are traced together: it changes the time alone"),
    vtkShadowParameter::Choice("structure", "auto", { "auto", "instanced", "flat" },
      "What rays are traced through: one structure a mesh, or one over all casters; auto is flat "
      "until something changes, where no two casters share a mesh") };
}
}

#endif
