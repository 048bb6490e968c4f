// SPDX-License-Identifier: BSD-3-Clause
// Samples of the light, each hidden where one of all slices has something on its ray: united by
// or, so that a wall that spans many slices hides once.

uniform usampler2DArray shadowBits;
// Of each light, two vectors a sample: point of the square, of the disk; weights.
uniform samplerBuffer shadowSamples;
uniform int shadowSampleCount;

// Of at most 64 samples, a bit each: those that are hidden, and those that only the last slice
// hides.
void shadowHideSamples(shadowPlace place, int last, bool partial, int first, int count,
  out uvec2 hidden, out uvec2 partly)
{
  bool square = SHADOW_SET(place.first + 7).w > 1.5;
  vec2 size = SHADOW_SET(place.first + 5).zw;
  uvec2 whole = uvec2(0xffffffffu >> uint(32 - min(count, 32)),
    count > 32 ? 0xffffffffu >> uint(64 - count) : 0u);
  hidden = uvec2(0u);
  partly = uvec2(0u);
  for (int i = last; i >= 0; --i)
  {
    vec4 slice = SHADOW_SET(place.first + shadowHeader + 2 * i);
    shadowKernel kernel = shadowFindKernel(place, slice);
    vec2 reach = abs(kernel.u) + abs(kernel.v);
    shadowKernelTexels = max(shadowKernelTexels, 2.0 * max(reach.x, reach.y));
#ifdef SHADOW_SKIPPING
    vec4 content = SHADOW_SET(place.first + shadowHeader + 1 + 2 * i);
    if (any(greaterThan(kernel.centre - reach - 1.0, content.zw)) ||
      any(lessThan(kernel.centre + reach + 1.0, content.xy)) || hidden == whole)
    {
      continue;
    }
#endif
    shadowSlicesRead += first == place.light * shadowSampleCount ? 1.0 : 0.0;
    float least = dot(abs(kernel.rise), vec2(SHADOW_BORDER));
    for (int k = 0; k < count; ++k)
    {
      vec4 both = texelFetch(shadowSamples, 2 * (first + k));
      vec2 st = square ? both.xy : both.zw;
      vec2 offset = st.x * kernel.u + st.y * kernel.v;
      vec2 at = kernel.centre + offset;
      bool own = kernel.above + dot(kernel.rise, offset) < least;
      if (!own && all(greaterThan(at, vec2(1.0))) && all(lessThan(at, size - 1.0)))
      {
        uint bits = texelFetch(shadowBits, ivec3(ivec2(at), place.set), 0).r;
        uint bit = (bits >> uint(i) & 1u) << uint(k & 31);
        uvec2 found = k < 32 ? uvec2(bit, 0u) : uvec2(0u, bit);
        partly |= i == last && partial ? found : uvec2(0u);
        hidden |= i == last && partial ? uvec2(0u) : found;
      }
    }
    shadowCost += float(count);
  }
}

SHADOW_VISIBILITY shadowSeeSamples(shadowPlace place, int last, float lastWeight)
{
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(0.0);
  for (int first = 0; first < shadowSampleCount; first += 64)
  {
    int count = min(shadowSampleCount - first, 64);
    int base = place.light * shadowSampleCount + first;
    uvec2 hidden;
    uvec2 partly;
    shadowHideSamples(place, last, lastWeight < 1.0, base, count, hidden, partly);
    for (int k = 0; k < count; ++k)
    {
      uint bit = 1u << uint(k & 31);
      bool isHidden = ((k < 32 ? hidden.x : hidden.y) & bit) != 0u;
      bool isPartly = ((k < 32 ? partly.x : partly.y) & bit) != 0u;
      float seen = isHidden ? 0.0 : (isPartly ? 1.0 - lastWeight : 1.0);
      visibility += SHADOW_VISIBILITY(texelFetch(shadowSamples, 2 * (base + k) + 1)) * seen;
    }
  }
  return visibility;
}
