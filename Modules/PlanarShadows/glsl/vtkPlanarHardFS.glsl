// planar-hard: the mask of this very pixel.
#define SHADOW_COST 1.0

SHADOW_VISIBILITY shadowLookUp(int record, float layer, vec3 positionVC)
{
  return SHADOW_VISIBILITY(texelFetch(shadowPlanarMaps, ivec3(SHADOW_PIXEL, int(layer)), 0).r);
}
