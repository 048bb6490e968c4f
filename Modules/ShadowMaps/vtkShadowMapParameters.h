// The parameters that all techniques of the family share: each is declared here once.

#ifndef vtkShadowMapParameters_h
#define vtkShadowMapParameters_h

#include "vtkShadowTechnique.h"

#include <string>
#include <utility>
#include <vector>

namespace vtkShadowMapParameters
{
/** Casters are kept off a map's border of two texels: smaller maps have no middle. */
constexpr int LeastResolution = 16;

/** With what else its automatic choice depends on. */
inline vtkShadowParameter Resolution(
  const std::string& more = "", std::vector<std::string> presets = { "512", "1024", "0", "4096" })
{
  return { "resolution", vtkShadowParameter::Type::Integer, "0", 0, 16384, {}, "texels",
    "Side of a depth map, 16 at least (less counts as 16); 0: the power of two next to the "
    "picture's longer side, 1024 to 4096, and at least 2048 where a mesh has more than 65,536 "
    "triangles" +
      more,
    std::move(presets) };
}

inline vtkShadowParameter Filter(const char* value)
{
  return { "filter", vtkShadowParameter::Type::Choice, value, 0, 0, { "nearest", "bilinear" }, "",
    "Compare with the nearest texel, or interpolate the compares of the four nearest", {} };
}

inline vtkShadowParameter Midpoint(const char* value = "off")
{
  return { "midpoint", vtkShadowParameter::Type::Boolean, value, 0, 0, {}, "",
    "Compare with the middle of the casters' first two layers, where they are a body's two sides, "
    "instead of with the first layer",
    {} };
}
}

#endif
