// SPDX-License-Identifier: BSD-3-Clause
// The mean of a slice over a rectangle: by SHADOW_SUMS, SHADOW_MEANS (N-buffers) or SHADOW_MIPS.
//
// SHADOW_REACH: how far beyond a rectangle's middle something can count, as a multiple of its
// half side; SHADOW_BORDER: and how many texels more.

#ifdef SHADOW_SUMS
uniform usampler2DArray shadowSums;

uint shadowSum(ivec2 texel, int layer, int channel)
{
  return texelFetch(shadowSums, ivec3(texel, layer), 0)[channel];
}

// The integral of what is constant in each texel: four corners, each interpolated between four.
// What is subtracted first are integers, so that nothing is lost to a table's large sums.
float shadowMean(int set, int slice, vec2 centre, vec2 halfSize, vec2 size)
{
  vec2 halfSide = max(halfSize, vec2(0.5));
  vec2 low = clamp(centre - halfSide, vec2(1.0), size - 1.001);
  vec2 high = clamp(centre + halfSide, vec2(1.0), size - 1.001);
  ivec2 a = ivec2(low);
  ivec2 b = ivec2(high);
  vec2 fa = low - vec2(a);
  vec2 fb = high - vec2(b);
  int layer = set * SHADOW_TARGETS + (slice >> 2);
  int channel = slice & 3;
  ivec4 columns = ivec4(a.x - 1, a.x, b.x - 1, b.x);
  ivec4 rows = ivec4(a.y - 1, a.y, b.y - 1, b.y);
  uvec4 base = uvec4(shadowSum(ivec2(columns.x, rows.x), layer, channel),
    shadowSum(ivec2(columns.y, rows.x), layer, channel),
    shadowSum(ivec2(columns.z, rows.x), layer, channel),
    shadowSum(ivec2(columns.w, rows.x), layer, channel));
  vec4 sums = vec4(0.0);
  for (int i = 1; i < 4; ++i)
  {
    uvec4 row = uvec4(shadowSum(ivec2(columns.x, rows[i]), layer, channel),
      shadowSum(ivec2(columns.y, rows[i]), layer, channel),
      shadowSum(ivec2(columns.z, rows[i]), layer, channel),
      shadowSum(ivec2(columns.w, rows[i]), layer, channel)) - base;
    vec4 from = vec4(row - row.xxxx);
    sums[i] = mix(from.z, from.w, fb.x) - from.y * fa.x;
  }
  shadowCost += 16.0;
  float sum = mix(sums.z, sums.w, fb.y) - sums.y * fa.y;
  return clamp(sum / (4.0 * halfSide.x * halfSide.y), 0.0, 1.0);
}
#endif

#ifdef SHADOW_MEANS
uniform sampler2DArray shadowEvenLevels;
uniform sampler2DArray shadowOddLevels;

float shadowMean(int set, int slice, vec2 centre, vec2 halfSize, vec2 size)
{
  // Between boxes of 2^level and twice that: what is linear in log2 is all but the least error at
  // an edge.
  float side = max(2.0 * sqrt(halfSize.x * halfSize.y), 1.0);
  float level = min(floor(log2(side)), float(SHADOW_LEVELS - 1));
  float share = clamp(log2(side) - level, 0.0, 1.0);
  int lower = int(level);
  int upper = min(lower + 1, SHADOW_LEVELS - 1);
  bool odd = (lower & 1) == 1;
  int target = set * SHADOW_TARGETS + (slice >> 2);
  int evenLayer = target * ((SHADOW_LEVELS + 1) / 2) + (odd ? upper : lower) / 2;
  int oddLayer = target * max(SHADOW_LEVELS / 2, 1) + (odd ? lower : upper) / 2;
  vec2 texels = vec2(textureSize(shadowEvenLevels, 0).xy);
  // A box's middle is its texel's lower corner; in the first level its middle.
  vec2 even = centre + ((odd ? upper : lower) == 0 ? 0.0 : 0.5);
  vec2 odds = centre + 0.5;
  vec3 evenAt = vec3(even / texels, float(evenLayer));
  vec3 oddAt = vec3(odds / texels, float(oddLayer));
  float ofEven = textureLod(shadowEvenLevels, evenAt, 0.0)[slice & 3];
  float ofOdd = textureLod(shadowOddLevels, oddAt, 0.0)[slice & 3];
  shadowCost += 2.0;
  bool inside = all(greaterThan(centre, vec2(0.0))) && all(lessThan(centre, size));
  // A wider one than the widest level holds no more than that.
  float wider = side * exp2(-float(SHADOW_LEVELS - 1));
  float mean = upper == lower ? (odd ? ofOdd : ofEven) / max(wider * wider, 1.0)
    : mix(odd ? ofOdd : ofEven, odd ? ofEven : ofOdd, share);
  return inside ? mean : 0.0;
}
#endif

#ifdef SHADOW_MIPS
uniform sampler2DArray shadowMips;

float shadowMean(int set, int slice, vec2 centre, vec2 halfSize, vec2 size)
{
  float side = max(2.0 * sqrt(halfSize.x * halfSize.y), 1.0);
  vec2 texels = vec2(textureSize(shadowMips, 0).xy);
  shadowCost += 2.0;
  bool inside = all(greaterThan(centre, vec2(0.0))) && all(lessThan(centre, size));
  float mean = textureLod(shadowMips,
    vec3(centre / texels, float(set * SHADOW_TARGETS + (slice >> 2))), log2(side))[slice & 3];
  return inside ? mean : 0.0;
}
#endif

// What of the light a slice hides.
float shadowSeeSlice(shadowPlace place, int slice, vec4 form)
{
  shadowKernel kernel = shadowFindKernel(place, form);
  vec2 halfSize = sqrt(kernel.u * kernel.u + kernel.v * kernel.v);
  shadowKernelTexels = max(shadowKernelTexels, 2.0 * max(halfSize.x, halfSize.y));
  vec4 size = SHADOW_SET(place.first + 5);
  // Where its own plane cuts it off, it is drawn in to the corner that is highest above that.
  vec2 rise = abs(kernel.rise);
  float wide = dot(rise, halfSize);
  float room = kernel.above + wide - dot(rise, vec2(SHADOW_BORDER));
  float share = room >= (1.0 + SHADOW_REACH) * wide ? 1.0
    : max(room, 0.0) / max((1.0 + SHADOW_REACH) * wide, 1e-30);
  vec2 centre = kernel.centre + sign(kernel.rise) * halfSize * (1.0 - share);
  halfSize *= share;
#ifdef SHADOW_SUMS
  vec2 reach = max(halfSize, vec2(0.5)) + 1.0;
#else
  vec2 reach = vec2(SHADOW_REACH * max(max(halfSize.x, halfSize.y), 0.5) + SHADOW_BORDER);
#endif
  vec4 content = SHADOW_SET(place.first + shadowHeader + 1 + 2 * slice);
  bool skip = share <= 0.0 || any(greaterThan(centre - reach, content.zw)) ||
    any(lessThan(centre + reach, content.xy));
#ifndef SHADOW_SKIPPING
  skip = share <= 0.0;
#endif
  float mean = 0.0;
  if (!skip)
  {
    mean = shadowMean(place.set, slice, centre, halfSize, size.zw);
    shadowSlicesRead += 1.0;
  }
  // What is left stands for the whole, as long as there is some.
  return min(4.0 * share, 1.0) * mean;
}
