// SPDX-License-Identifier: BSD-3-Clause
// A texture's alpha on the CPU: where a surface that it lies on has holes.

#ifndef vtkShadowAlphaMap_h
#define vtkShadowAlphaMap_h

#include "vtkSoftShadowsCastersModule.h" // For export macro

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

struct VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowAlphaMap
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Texels; // 0 to 255, the row of t = 0 first
  bool Linear = false;               // interpolated between texels, or the nearest one
  int Wrap = 0;                      // as vtkTexture::GetWrap()
  unsigned char Border = 0;          // outside of it, where it is clamped to its border
  float Minimum = 0.0f;              // of its alpha, 0 to 1

  /** Alpha at texture coordinates, 0 to 1, as OpenGL looks it up. */
  float Get(float s, float t) const;
  /** Whether it is below a bound all over a triangle of texture coordinates, or perhaps is not. */
  bool IsBelow(float bound, const std::array<const float*, 3>& corners) const;

  bool operator==(const vtkShadowAlphaMap& other) const;

private:
  float GetTexel(std::int64_t i, std::int64_t j) const;
};

/** The holes in triangles of a vtkShadowMesh: where vertices' alpha times the map's is too low. */
struct VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowHoles
{
  std::vector<float> Places;                    // s, t, alpha: three a vertex
  std::shared_ptr<const vtkShadowAlphaMap> Map; // nullptr: 1 everywhere
  float Threshold = 0.0f;

  /** Whether a triangle of vertices has a hole at shares u of the second and v of the third. */
  bool IsHole(const std::uint32_t* corners, float u, float v) const;

  bool operator==(const vtkShadowHoles& other) const;
};

#endif
