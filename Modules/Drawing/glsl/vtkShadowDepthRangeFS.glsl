// SPDX-License-Identifier: BSD-3-Clause
// Asks a depth pyramid (see vtkShadowDepthPyramid).

uniform sampler2DArray shadowPyramid;
uniform int shadowPyramidResolution; // of the maps

// At most the least and at least the greatest depth of the texels that look-ups within a box of the
// map, [0,1] in x and y, can read; the four nearest of each are counted.
vec2 shadowDepthRange(float layer, vec2 low, vec2 high)
{
  vec2 last = vec2(float(shadowPyramidResolution - 1));
  // Half a texel for the four nearest, and a hair for rounding.
  vec2 first = clamp(floor(low * (last + 1.0) - 0.51), vec2(0.0), last);
  vec2 final = clamp(floor(high * (last + 1.0) + 0.51), vec2(0.0), last);
  // The finest level on which two cells a side hold them.
  vec2 extent = final - first;
  int level = max(0, int(ceil(log2(max(max(extent.x, extent.y), 1.0)))) - 1);
  ivec2 from = ivec2(first) >> (level + 1);
  ivec2 to = ivec2(final) >> (level + 1);
  int index = int(layer);
  vec2 a = texelFetch(shadowPyramid, ivec3(from, index), level).rg;
  vec2 b = texelFetch(shadowPyramid, ivec3(to.x, from.y, index), level).rg;
  vec2 c = texelFetch(shadowPyramid, ivec3(from.x, to.y, index), level).rg;
  vec2 d = texelFetch(shadowPyramid, ivec3(to, index), level).rg;
  return vec2(min(min(a.x, b.x), min(c.x, d.x)), max(max(a.y, b.y), max(c.y, d.y)));
}
