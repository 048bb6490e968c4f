// Visibility on planes: finds the plane that the receiver lies in, and asks shadowLookUp for that
// plane's shadow from a light. Anything else sees all of the light.
//
// shadowRecords: SHADOW_PLANES equations in VC; then SHADOW_RECORD_VECTORS for each light, plane and
// side of it. Their first: what of the light's emission is on that side, and the layer that holds its
// shadow, -1 where nothing falls onto the plane.

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

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
  int plane = shadowFindPlane(positionVC, normalVC);
  if (plane >= 0)
  {
    // With one plane all indices are constant, which software rasterizers are glad of.
    plane = SHADOW_PLANES == 1 ? 0 : plane;
    int first =
      SHADOW_PLANES + (light * SHADOW_PLANES + plane) * SHADOW_SIDES * SHADOW_RECORD_VECTORS;
    vec4 record = SHADOW_RECORD(first);
    if (record.w >= 0.0)
    {
      visibility = shadowLookUp(first, record.w, positionVC);
    }
#if SHADOW_SIDES > 1
    // The light reaches through the plane: the receiver's own surface hides what is behind it.
    float facing = dot(SHADOW_RECORD(plane).xyz, normalVC);
    vec4 below = SHADOW_RECORD(first + SHADOW_RECORD_VECTORS);
    SHADOW_VISIBILITY belowVisibility = SHADOW_VISIBILITY(1.0);
    if (below.w >= 0.0)
    {
      belowVisibility = shadowLookUp(first + SHADOW_RECORD_VECTORS, below.w, positionVC);
    }
    visibility = shadowSelf && facing < 0.0 ? 1.0 - SHADOW_VISIBILITY(record) : visibility;
    belowVisibility = shadowSelf && facing >= 0.0 ? 1.0 - SHADOW_VISIBILITY(below) : belowVisibility;
    visibility = max(visibility + belowVisibility - 1.0, 0.0);
#endif
  }
  return visibility;
}
