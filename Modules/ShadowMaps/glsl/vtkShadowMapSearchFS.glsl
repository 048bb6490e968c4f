// SPDX-License-Identifier: BSD-3-Clause
// Blocker search and penumbra estimate of percentage-closer soft shadows: Fernando, Percentage-closer
// soft shadows, 2005; Zapotocky, Soft shadows on GPU, 2007, section 3.5 and equation 3.3.
//
// The region that is searched is all that can hide the light: it is the light's footprint at the
// nearest depth that the map has there, found by the depth pyramid. A blocker counts where it hides a
// point of the light: if it lies in the pyramid of receiver and light, which at its depth is narrower.
// Penumbrae are linear in the difference of depths, so it is that which is averaged.
//
// With SHADOW_LAYERS points lie the denser the nearer they are to the middle, since what lies near the receiver
// hides the light there alone; where they find nothing, as many as the filter has look all over the region, so that
// what they miss weighs less than a look-up of the filter. The mean, the variance and the skewness of what was found
// are those of two depths, which are taken for it where it varies: the filter's look-ups are past either.

uniform samplerBuffer shadowSearch; // xy: points of the disk, zw: of the square
uniform int shadowSearchCount;
uniform int shadowSearchFurther; // so many follow them, for where nothing was found

// Of points from first to before last: how many blockers there are, and the sums of the first three powers of
// their deltas.
vec4 shadowSearchPoints(shadowKernel kernel, float reference, float reach, int first, int last)
{
  vec4 sums = vec4(0.0);
  for (int i = first; i < last; ++i)
  {
    vec4 both = texelFetch(shadowSearch, i);
    vec2 st = kernel.square ? both.zw : both.xy;
    vec2 offsetLC = shadowOffset(kernel, reach, st);
    float depth = texture(shadowDepths, vec3(kernel.receiverLC.xy + offsetLC, kernel.layer)).r;
    float nearer = kernel.receiverLC.z - depth;
    float tilted = dot(st, kernel.tilt);
    bool blocks = depth < shadowReferenceAt(kernel, reference, offsetLC) &&
      shadowSize(kernel, st) * reach <= nearer * (1.0 - tilted) + reach * tilted;
    sums += blocks ? vec4(1.0, nearer, nearer * nearer, nearer * nearer * nearer) : vec4(0.0);
  }
  shadowCost += float(last - first);
  return sums;
}

// What is found, as shadowClassify gives it, and the layers of the blockers: without any at the receiver, so
// that the filter then is one look-up, as of a light without size.
float shadowFindBlockers(int view, shadowKernel kernel, out shadowLayers layers)
{
  float delta = max(kernel.receiverLC.z, 0.0); // the nearest that a blocker can be
  float found = -1.0;
  float reach = 0.0;
  vec2 extent = vec2(0.0);
  // Twice: what lies nearer to the light than all that the first, wider region has needs no look.
  for (int i = 0; i < 2; ++i)
  {
    reach = shadowReach(kernel, delta);
    extent = shadowExtent(kernel, reach);
    vec2 rangeLC = shadowRange(kernel, extent);
    delta = clamp(kernel.receiverLC.z - rangeLC.x, 0.0, delta);
#if defined(SHADOW_SKIPPING) || defined(SHADOW_LAYERS)
    found = shadowClassify(kernel, rangeLC, shadowReference(kernel, extent), extent);
#endif
#ifdef SHADOW_SKIPPING
    if (found >= 0.0)
    {
      break;
    }
#endif
  }
#ifdef SHADOW_SKIPPING
  bool search = found < 0.0;
#else
  const bool search = true;
#endif
  reach = shadowReach(kernel, delta);
  extent = shadowExtent(kernel, reach);
  float reference = shadowReference(kernel, extent);
  int count = search ? shadowCount(kernel, extent, shadowSearchCount) : 0;
  vec4 sums = shadowSearchPoints(kernel, reference, reach, 0, count);
#ifdef SHADOW_LAYERS
  if (sums.x == 0.0 && count == shadowSearchCount)
  {
    count = shadowCount(kernel, extent, shadowSearchFurther);
    sums = shadowSearchPoints(
      kernel, reference, reach, shadowSearchCount, shadowSearchCount + count);
  }
#endif
  vec3 means = sums.yzw / max(sums.x, 1.0);
  delta = means.x;
  shadowBlocker = sums.x > 0.0 ? shadowDistance(kernel, delta) : 0.0;
  shadowPenumbra = sums.x > 0.0 ? shadowWidth(view, kernel, delta) : 0.0;
#ifdef SHADOW_LAYERS
  // Least spread of what counts as two, and at which a mean's pyramid tells nothing any more.
  const float least = 0.02;
  const float most = 0.2;
  float variance = max(means.y - delta * delta, 0.0);
  float spread = sqrt(variance) / max(delta, 1e-30);
  if (spread > least)
  {
    float skewed = 0.5 * (means.z - delta * (3.0 * variance + delta * delta)) / variance;
    float root = sqrt(skewed * skewed + variance);
    float near = clamp(delta + skewed - root, 0.0, delta);
    float far = clamp(delta + skewed + root, delta, reach);
    layers = shadowOneLayer(kernel, near);
    layers.farReach = shadowReach(kernel, far);
    layers.border = kernel.receiverLC.z - 0.5 * (near + far);
  }
  else
  {
    layers = shadowOneLayer(kernel, delta);
  }
  // Where most of the region is covered, what lies near may be the same surface, which goes on there.
  float share = sums.x / max(float(count), 1.0);
  layers.narrowing =
    clamp((most - spread) / (most - least), 0.0, 1.0) * max(1.0 - 1.5 * share, 0.0);
#else
  layers = shadowOneLayer(kernel, delta);
#endif
  return found;
}
