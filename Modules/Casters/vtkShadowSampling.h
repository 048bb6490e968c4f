// SPDX-License-Identifier: BSD-3-Clause
// Sampling patterns that all techniques share.
//
// Sobol's first two dimensions: every power-of-two prefix is a (0,2)-net in base 2, that is,
// stratified over all elementary intervals at once, and any other count is nearly so.

#ifndef vtkShadowSampling_h
#define vtkShadowSampling_h

#include "vtkSoftShadowsCastersModule.h" // For export macro

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace vtkShadowSampling
{
/** A point of the pattern as two 32-bit fractions; XOR with a word a dimension scrambles it. */
struct Bits
{
  std::uint32_t X;
  std::uint32_t Y;
};

/** `count` points, from one of them on. */
VTKSOFTSHADOWSCASTERS_EXPORT std::vector<Bits> Sobol(int count, int first = 0);

/** A well-mixed hash of a word, for scrambling by pixel. */
VTKSOFTSHADOWSCASTERS_EXPORT std::uint32_t Hash(std::uint32_t value);

/** To [0,1)^2: the centre of the fraction's cell, so that no sample lies on the border. */
inline glm::dvec2 ToUnit(Bits bits)
{
  constexpr double scale = 1.0 / 4294967296.0;
  return { (bits.X + 0.5) * scale, (bits.Y + 0.5) * scale };
}

/** Shirley and Chiu's area-preserving map of the unit square to the unit disk. */
VTKSOFTSHADOWSCASTERS_EXPORT glm::dvec2 ConcentricDisk(const glm::dvec2& unit);
}

#endif
