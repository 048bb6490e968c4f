// SPDX-License-Identifier: BSD-3-Clause
// map-trace: see vtkTracedShadowMapPass.

uniform int shadowSamples;

// How deep rays have to be followed, as a difference of depth: to the nearest that the map has over the
// light's footprint, which narrows that, twice; and where the first can be hidden. `found` is 1 where all rays
// find light, 0 where none does, else -1.
float shadowFindNearest(shadowKernel kernel, out float found, out float first)
{
  const float start = 0.5 / SHADOW_MAP_SIDE; // so far from the receiver do they start
  float delta = max(kernel.receiverLC.z, 0.0);
  found = -1.0;
  for (int i = 0; i < 2; ++i)
  {
    vec2 extent = shadowExtent(kernel, delta) + start;
    vec2 rangeLC = shadowSlabRange(
      kernel.layer, kernel.receiverLC.xy - extent, kernel.receiverLC.xy + extent);
    float rise = dot(abs(kernel.slopeLC), vec2(start));
    float highest = kernel.receiverLC.z + rise;
    // A hair more, or what is nearest would be reached or not as rounding goes.
    delta = clamp((highest - rangeLC.x) * (1.0 + 1.0 / 256.0), 0.0, delta);
    first = max(kernel.receiverLC.z - rise - abs(rangeLC.y), 0.0) * (1.0 - 1.0 / 256.0);
    float lowest = kernel.receiverLC.z - dot(abs(kernel.slopeLC) + kernel.wobble, extent) -
      shadowSlack(kernel);
    bool lit = rangeLC.x >= highest && !kernel.horizonCuts;
    found = lit ? 1.0 : (rangeLC.y > 0.0 && rangeLC.y < lowest ? 0.0 : -1.0);
#ifdef SHADOW_SKIPPING
    if (found >= 0.0)
    {
      break;
    }
#endif
  }
  return delta;
}

// Some rays were followed: there is noise.
bool shadowNoisy = false;

// Which samples of a block a view hides, a bit each.
uint shadowTraceView(int view, shadowKernel kernel, int first, int count)
{
  float found;
  float least;
  float delta = shadowFindNearest(kernel, found, least);
  bool sure = found >= 0.0;
#ifndef SHADOW_SKIPPING
  found = -1.0;
#endif
  shadowPenumbra = shadowWidth(view, kernel, delta);
  shadowBlocker = delta > 0.0 ? shadowDistance(kernel, delta) : 0.0;
  vec2 extent = shadowExtent(kernel, delta) * SHADOW_MAP_SIDE;
  uint hidden = found == 0.0 ? 0xffffffffu : 0u;
  if (found < 0.0 && max(extent.x, extent.y) < 0.5)
  {
    // Within a texel a map knows nothing of the light's size.
    float lit = shadowLookUp(kernel, shadowReference(kernel, vec2(0.0)), 0.0, vec2(0.0));
    shadowCost += 1.0;
    for (int i = 0; i < count; ++i)
    {
      hidden |= (float(i) + 0.5) / float(count) > lit ? 1u << uint(i) : 0u;
    }
    count = 0;
  }
  count = found < 0.0 ? count : 0;
  shadowNoisy = shadowNoisy || (count > 0 && !sure);
  // Where a map is cut, the light is drawn in to what it shows, as for filters.
  float drawn = shadowReach(kernel, delta) / max(delta, 1e-30);
  for (int i = 0; i < count; ++i)
  {
    vec4 both = texelFetch(shadowPattern, first + i);
    vec2 st = kernel.square ? both.zw : both.xy;
    // They start all over a texel, so that its border is no edge.
    vec2 spread = fract(vec2(0.75487766, 0.56984029) * float(first + i) + 0.5) - 0.5;
    shadowRay ray;
    ray.layer = kernel.layer;
    ray.place = kernel.receiverLC.xy * SHADOW_MAP_SIDE + spread;
    ray.slope = kernel.slopeLC / SHADOW_MAP_SIDE;
    ray.depth = kernel.receiverLC.z + dot(ray.slope, spread);
    ray.along = shadowOffset(kernel, drawn, st) * SHADOW_MAP_SIDE;
    ray.first = least;
    ray.last = delta;
    ray.slack = shadowSlack(kernel);
    ray.wobble = kernel.wobble / SHADOW_MAP_SIDE;
    bool below = kernel.horizon.x + st.x * kernel.horizon.y + st.y * kernel.horizon.z < 0.0;
    hidden |= below || shadowIsHidden(ray) ? 1u << uint(i) : 0u;
  }
  return hidden;
}

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  SHADOW_VISIBILITY lit = SHADOW_VISIBILITY(0.0);
  SHADOW_VISIBILITY all = SHADOW_VISIBILITY(0.0);
  float seen = 0.0;
  vec2 told = vec2(0.0); // to debug views, by the view that found something
  int block = shadowBlock(SHADOW_PIXEL) * shadowSamples;
  for (int done = 0; done < shadowSamples; done += 32)
  {
    int first = block + done;
    int count = min(32, shadowSamples - done);
    uint hidden = 0u;
    for (int view = SHADOW_FIRST_VIEW(light); view < SHADOW_END_OF_VIEWS(light); ++view)
    {
      shadowKernel kernel;
      if (shadowFindKernel(light, view, positionVC, normalVC, kernel))
      {
        hidden |= shadowTraceView(view, kernel, first, count);
        told = max(told, vec2(shadowBlocker, shadowPenumbra));
      }
    }
    for (int i = 0; i < count; ++i)
    {
#ifdef SHADOW_EMISSION
      SHADOW_VISIBILITY weight =
        texelFetch(shadowEmission, light * SHADOW_TILE * SHADOW_TILE * shadowSamples + first + i).rgb;
#else
      const SHADOW_VISIBILITY weight = SHADOW_VISIBILITY(1.0);
#endif
      bool sees = (hidden >> uint(i) & 1u) == 0u;
      lit += sees ? weight : SHADOW_VISIBILITY(0.0);
      all += weight;
      seen += sees ? 1.0 : 0.0;
    }
  }
  shadowBlocker = told.x;
  shadowPenumbra = told.y;
  // Told to vtkShadowMapDenoiseFS.glsl.
#ifdef SHADOW_TELLS_NOISE
  float sure = shadowNoisy ? 0.0 : 2.0;
#else
  const float sure = 0.0;
#endif
#ifdef SHADOW_EMISSION
  // Where none of a pixel's points glows in a channel, their geometry decides.
  vec3 byEmission = lit / max(all, vec3(1e-30));
  vec3 glows = vec3(greaterThan(all, vec3(0.0)));
  return sure + mix(vec3(seen / float(shadowSamples)), byEmission, glows);
#else
  return sure + lit / all;
#endif
}
