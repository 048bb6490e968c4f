// SPDX-License-Identifier: BSD-3-Clause
// Visibility on planes: finds the plane that the receiver lies in, and asks shadowLookUp for that
// plane's shadow from a light. Anything else sees all of the light.
//
// shadowRecords: SHADOW_PLANES equations in VC; then SHADOW_RECORD_VECTORS for each light, plane, side of
// it, and group of casters. Their first: what of the light's emission is on that side, and the layer that
// holds the shadow, -1 where nothing falls onto the plane.

uniform sampler2DArray shadowPlanarMaps;
#ifdef SHADOW_FEW_RECORDS
uniform vec4 shadowRecords[SHADOW_FEW_RECORDS];
#define SHADOW_RECORD(index) shadowRecords[index]
#else
uniform samplerBuffer shadowRecords;
#define SHADOW_RECORD(index) texelFetch(shadowRecords, index)
#endif

//SHADOW::LookUp

// The nearest plane within what positions are off; -1 where the receiver lies in none. A surface that
// only crosses a plane does not lie in it.
int shadowFindPlane(vec3 positionVC, vec3 normalVC)
{
  int found = -1;
  float nearest = 2.0 * shadowRounding(positionVC);
  for (int plane = 0; plane < SHADOW_PLANES; ++plane)
  {
    vec4 planeVC = SHADOW_RECORD(plane);
    float separation = abs(dot(planeVC, vec4(positionVC, 1.0)));
    bool lies = separation <= nearest && abs(dot(planeVC.xyz, normalVC)) > 0.9;
    found = lies ? plane : found;
    nearest = lies ? separation : nearest;
  }
  return found;
}

// Past all groups of casters on a side, whose first record is given. Their windows lie apart.
SHADOW_VISIBILITY shadowLookUpSide(int first, vec3 positionVC)
{
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
  for (int group = 0; group < SHADOW_GROUPS; ++group)
  {
    int record = first + group * SHADOW_RECORD_VECTORS;
    float layer = SHADOW_RECORD(record).w;
    if (layer >= 0.0)
    {
      visibility = min(visibility, shadowLookUp(record, layer, positionVC));
    }
  }
  return visibility;
}

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
  int plane = shadowFindPlane(positionVC, normalVC);
  if (plane >= 0)
  {
    // With one plane all indices are constant, which software rasterizers are glad of.
    plane = SHADOW_PLANES == 1 ? 0 : plane;
    const int side = SHADOW_GROUPS * SHADOW_RECORD_VECTORS;
    int first = SHADOW_PLANES + (light * SHADOW_PLANES + plane) * SHADOW_SIDES * side;
    visibility = shadowLookUpSide(first, positionVC);
#if SHADOW_SIDES > 1
    // The light reaches through the plane: the receiver's own surface hides what is behind it.
    float facing = dot(SHADOW_RECORD(plane).xyz, normalVC);
    SHADOW_VISIBILITY above = SHADOW_VISIBILITY(SHADOW_RECORD(first));
    SHADOW_VISIBILITY below = SHADOW_VISIBILITY(SHADOW_RECORD(first + side));
    SHADOW_VISIBILITY belowVisibility = shadowLookUpSide(first + side, positionVC);
    visibility = shadowSelf && facing < 0.0 ? 1.0 - above : visibility;
    belowVisibility = shadowSelf && facing >= 0.0 ? 1.0 - below : belowVisibility;
    visibility = max(visibility + belowVisibility - 1.0, 0.0);
#endif
  }
  return visibility;
}
