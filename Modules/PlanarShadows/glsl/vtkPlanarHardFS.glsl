// SPDX-License-Identifier: BSD-3-Clause
// planar-hard: the mask of this very pixel.

SHADOW_VISIBILITY shadowLookUp(int record, float layer, vec3 positionVC)
{
  shadowCost += 1.0;
  return SHADOW_VISIBILITY(texelFetch(shadowPlanarMaps, ivec3(SHADOW_PIXEL, int(layer)), 0).r);
}
