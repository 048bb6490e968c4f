// SPDX-License-Identifier: BSD-3-Clause
// The parameters that all techniques of the family share: each is declared here once.

#ifndef vtkShadowMapParameters_h
#define vtkShadowMapParameters_h

#include "vtkShadowDeclaration.h"

#include <string>
#include <vector>

namespace vtkShadowMapParameters
{
/** Casters are kept off a map's border of two texels: smaller maps have no middle. */
constexpr int LeastResolution = 16;

/** With what else its automatic choice depends on. */
inline vtkShadowParameter Resolution(
  const std::string& more = "", const std::vector<double>& presets = { 512, 1024, 0, 4096 })
{
  return vtkShadowParameter::Integer("resolution", 0, 0, 16384,
    "Side of a depth map, 16 at least (less counts as 16); 0: the power of two next to the "
    "picture's longer side, 1024 to 4096, and at least 2048 where a mesh has more than 65,536 "
    "triangles" +
      more)
    .In("texels")
    .At(presets);
}

inline vtkShadowParameter Filter(const char* value)
{
  return vtkShadowParameter::Choice("filter", value, { "nearest", "bilinear" },
    "Compare with the nearest texel, or interpolate the compares of the four nearest");
}

inline vtkShadowParameter Midpoint(bool value = false)
{
  return vtkShadowParameter::Boolean("midpoint", value,
    "Compare with the middle of the casters' first two layers, where they are a body's two sides, "
    "instead of with the first layer");
}

inline vtkShadowParameter Faces()
{
  return vtkShadowParameter::Choice("faces", "both", { "both", "front", "back" },
    "Which faces of casters the map holds, as they are turned to the light; flat casters count "
    "always. Not with midpoint=on. Of bodies the back ones leave no acne, and light at contacts");
}
}

#endif
