// SPDX-License-Identifier: BSD-3-Clause
// Blocker search and penumbra estimate of percentage-closer soft shadows: Fernando, Percentage-closer
// soft shadows, 2005; Zapotocky, Soft shadows on GPU, 2007, section 3.5 and equation 3.3.
//
// The region that is searched is all that can hide the light: it is the light's footprint at the
// nearest depth that the map has there, found by the depth pyramid. A blocker counts where it hides a
// point of the light: if it lies in the pyramid of receiver and light, which at its depth is narrower.
// Penumbrae are linear in the difference of depths, so it is that which is averaged.

uniform samplerBuffer shadowSearch; // xy: points of the disk, zw: of the square
uniform int shadowSearchCount;

// What is found, as shadowClassify gives it, and the mean delta of the blockers: 0 without any, so that
// the filter then is one look-up, as of a light without size.
float shadowFindBlockers(int view, shadowKernel kernel, out float delta)
{
  delta = max(kernel.receiverLC.z, 0.0); // the nearest that a blocker can be
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
#ifdef SHADOW_SKIPPING
    found = shadowClassify(kernel, rangeLC, shadowReference(kernel, extent), extent);
    if (found >= 0.0)
    {
      break;
    }
#endif
  }
  reach = shadowReach(kernel, delta);
  extent = shadowExtent(kernel, reach);
  float reference = shadowReference(kernel, extent);
  float count = 0.0;
  float sum = 0.0;
  int most = found < 0.0 ? shadowCount(kernel, extent, shadowSearchCount) : 0;
  for (int i = 0; i < most; ++i)
  {
    vec4 both = texelFetch(shadowSearch, i);
    vec2 st = kernel.square ? both.zw : both.xy;
    float size = kernel.square ? max(abs(st.x), abs(st.y)) : length(st);
    vec2 offsetLC = shadowOffset(kernel, reach, st);
    float depth = texture(shadowDepths, vec3(kernel.receiverLC.xy + offsetLC, kernel.layer)).r;
    float nearer = kernel.receiverLC.z - depth;
    float tilted = dot(st, kernel.tilt);
    bool blocks = depth < shadowReferenceAt(kernel, reference, offsetLC) &&
      size * reach <= nearer * (1.0 - tilted) + reach * tilted;
    count += blocks ? 1.0 : 0.0;
    sum += blocks ? nearer : 0.0;
  }
  shadowCost += float(most);
  delta = sum / max(count, 1.0);
  shadowBlocker = count > 0.0 ? shadowDistance(kernel, delta) : 0.0;
  shadowPenumbra = count > 0.0 ? shadowWidth(view, kernel, delta) : 0.0;
  return found;
}
