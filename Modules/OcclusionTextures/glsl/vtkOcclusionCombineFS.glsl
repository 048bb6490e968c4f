// SPDX-License-Identifier: BSD-3-Clause
// Visibility from all slices between a receiver and a light, as if each hid another part of it
// (SHADOW_PRODUCT: equation 5 of the paper), another one as long as there is any (SHADOW_SUM), or
// the same (SHADOW_MAXIMUM); or by SHADOW_BITS, sample by sample.

// A light's rectangle of so many texels is a point; from so many on slices begin to tell, whose
// cracks are a texel wide, and from so many on they tell all.
const float shadowPointTexels = 1.0;
const float shadowFirstTexels = 2.0;
const float shadowWholeTexels = 4.0;

float shadowSide(shadowPlace place, float depth)
{
  vec4 window = SHADOW_SET(place.first + 4);
  float below = place.position.z - depth;
  float share = place.perspective ? below / (place.position.z * (place.behind + depth)) : below;
  vec2 halfSize = sqrt(place.u * place.u + place.v * place.v) * window.zw * share;
  return 2.0 * max(halfSize.x, halfSize.y);
}

float shadowTellShare(float side)
{
  return clamp((side - shadowFirstTexels) / (shadowWholeTexels - shadowFirstTexels), 0.0, 1.0);
}

// How much of what is nearest at a texel the slices do not tell: 1 in the receiver's own slice.
float shadowContactShare(shadowPlace place, ivec2 texel, vec4 partial, float partialWeight)
{
  float depth = shadowFindDepth(place, texel);
  float weight = depth > partial.x ? 0.0 : (depth >= partial.w ? partialWeight : 1.0);
  return 1.0 - weight * shadowTellShare(shadowSide(place, depth));
}

// What the slices leave out: in the receiver's own slice, in the one above it, whose weight is
// not 1, and of a light within a texel.
float shadowSeeContacts(shadowPlace place, vec4 partial, float partialWeight)
{
  vec3 form;
  if (!shadowFindPlane(place, form))
  {
    return 0.0;
  }
  vec4 window = SHADOW_SET(place.first + 4);
  vec4 size = SHADOW_SET(place.first + 5);
  // Through the slice's plane, or where the receiver is.
  float depth = min(partial.x, place.position.z);
  float side = shadowSide(place, depth);
  float w = place.perspective ? place.behind + depth : 1.0;
  vec2 centre = place.perspective ? place.slope * depth / w : place.position.xy;
  vec2 at = (centre - window.xy) * window.zw;
  if (side <= shadowPointTexels)
  {
    vec2 corner = at - 0.5;
    ivec2 first = ivec2(floor(corner));
    vec2 beside = corner - vec2(first);
    vec4 hidden;
    for (int i = 0; i < 4; ++i)
    {
      ivec2 texel = first + ivec2(i & 1, i >> 1);
      hidden[i] = shadowFindRise(place, form, texel) > 0.0
        ? shadowContactShare(place, texel, partial, partialWeight) : 0.0;
    }
    shadowCost += 4.0;
    return mix(mix(hidden.x, hidden.y, beside.x), mix(hidden.z, hidden.w, beside.x), beside.y);
  }
  float below = place.position.z - depth;
  float share = place.perspective ? below / (place.position.z * w) : below;
  float hidden = 0.0;
  for (int i = 0; i < SHADOW_CONTACTS; ++i)
  {
    // Roberts's sequence: even in either axis and in the square.
    vec2 st = fract((float(i) + 0.5) * vec2(0.7548776662, 0.5698402910)) * 2.0 - 1.0;
    ivec2 texel = ivec2(floor(at + (st.x * place.u + st.y * place.v) * share * window.zw));
    // It hides the light's point if it is within the pyramid of receiver and light.
    if (shadowFindRise(place, form, texel) > 0.0 &&
      shadowSide(place, shadowFindDepth(place, texel)) >= max(abs(st.x), abs(st.y)) * side)
    {
      hidden += shadowContactShare(place, texel, partial, partialWeight);
    }
  }
  shadowCost += float(SHADOW_CONTACTS);
  return hidden / float(SHADOW_CONTACTS);
}

// Where the receiver is: the last slice above it, or -1, and its weight.
int shadowFindLast(shadowPlace place, out float weight)
{
  int last = place.slices - 1;
  weight = 0.0;
  for (; last >= 0; --last)
  {
    vec4 form = SHADOW_SET(place.first + shadowHeader + 2 * last);
    weight = clamp((place.position.z - form.x) * form.y, 0.0, 1.0);
    if (weight > 0.0)
    {
      break;
    }
  }
  return last;
}

#ifndef SHADOW_BITS
void shadowCombine(inout float hidden, float more)
{
#if defined(SHADOW_PRODUCT)
  hidden = 1.0 - (1.0 - hidden) * (1.0 - more);
#elif defined(SHADOW_SUM)
  hidden = min(hidden + more, 1.0);
#else
  hidden = max(hidden, more);
#endif
}

float shadowSeeAll(shadowPlace place, int last, float lastWeight)
{
#ifdef SHADOW_TWICE
  // Each slice holds the one above it too: every other one holds all. Which of them, changes as
  // the receiver passes through a slice.
  vec2 hidden = vec2(0.0);
  for (int i = last; i >= 0; --i)
  {
    vec4 form = SHADOW_SET(place.first + shadowHeader + 2 * i);
    float more =
      shadowTellShare(shadowSide(place, form.x)) * shadowSeeSlice(place, i, form);
    if (((last - i) & 1) == 0)
    {
      shadowCombine(hidden.x, more);
    }
    else
    {
      shadowCombine(hidden.y, more);
    }
  }
  return mix(hidden.y, hidden.x, lastWeight);
#else
  float hidden = 0.0;
  for (int i = last; i >= 0; --i)
  {
    vec4 form = SHADOW_SET(place.first + shadowHeader + 2 * i);
    float share = shadowTellShare(shadowSide(place, form.x)) * (i == last ? lastWeight : 1.0);
    if (share > 0.0)
    {
      shadowCombine(hidden, share * shadowSeeSlice(place, i, form));
    }
#ifdef SHADOW_SKIPPING
    if (hidden >= 1.0)
    {
      break;
    }
#endif
  }
  return hidden;
#endif
}
#endif

SHADOW_VISIBILITY shadowSeeSet(shadowPlace place)
{
  float lastWeight;
  int last = shadowFindLast(place, lastWeight);
  vec4 first = SHADOW_SET(place.first + shadowHeader);
  vec4 partial = last >= 0 ? SHADOW_SET(place.first + shadowHeader + 2 * last) : first.wwww;
  vec4 lowest = SHADOW_SET(place.first + shadowHeader + 2 * (place.slices - 1));
  // Nothing is left out for a receiver that is below all slices, and sees a light of some texels.
  bool contacts = place.position.z > first.w && (last < place.slices - 1 || lastWeight < 1.0 ||
    shadowSide(place, lowest.x) < shadowWholeTexels);
#ifdef SHADOW_BITS
  SHADOW_VISIBILITY visibility = shadowSeeSamples(place, last, lastWeight);
#else
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0 - shadowSeeAll(place, last, lastWeight));
#endif
  if (contacts)
  {
    float hidden = shadowSeeContacts(place, partial, lastWeight);
    // Another part of the light: of what is nearest, these are the rays that the slices leave.
    visibility = max(visibility - SHADOW_VISIBILITY(hidden), SHADOW_VISIBILITY(0.0));
  }
  return visibility;
}

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
  for (int set = shadowFirstSet[light]; set < shadowEndOfSets[light]; ++set)
  {
    shadowPlace place;
    if (shadowFindPlace(light, set, positionVC, normalVC, place))
    {
      visibility = min(visibility, shadowSeeSet(place));
    }
  }
  if (shadowFirstSet[light] < shadowEndOfSets[light])
  {
    visibility *= shadowSeeHorizon(light, positionVC, normalVC);
  }
  return visibility;
}
