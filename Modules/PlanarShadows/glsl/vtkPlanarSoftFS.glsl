// SPDX-License-Identifier: BSD-3-Clause
// planar-soft: what the samples of the light left, interpolated. A record's second and third vectors
// are the rows from VC to the layer. SHADOW_CHANNELS: rrr, or rgb where a light is textured.

SHADOW_VISIBILITY shadowLookUp(int record, float layer, vec3 positionVC)
{
  shadowCost += 1.0;
  vec2 place = vec2(dot(SHADOW_RECORD(record + 1), vec4(positionVC, 1.0)),
    dot(SHADOW_RECORD(record + 2), vec4(positionVC, 1.0)));
  vec3 visibility = texture(shadowPlanarMaps, vec3(place, layer)).SHADOW_CHANNELS;
  // The sum of all weights is 1 but for rounding.
  return SHADOW_VISIBILITY(vec4(visibility * vec3(greaterThan(visibility, vec3(2e-5))), 1.0));
}
