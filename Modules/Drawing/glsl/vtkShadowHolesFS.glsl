// SPDX-License-Identifier: BSD-3-Clause
// Of casters with holes, in the place of //VTK::ShadowHoles::Dec in their fragment shaders.

in vec3 shadowPlaceVSOutput; // texture coordinates, alpha

uniform sampler2D shadowAlphaMap;
uniform float shadowLeastAlpha;

void shadowDiscardHole()
{
  float alpha = textureLod(shadowAlphaMap, shadowPlaceVSOutput.xy, 0.0).r;
  if (shadowPlaceVSOutput.z * alpha < shadowLeastAlpha)
  {
    discard;
  }
}
