// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Debug views that every technique has: see vtkShadowPass::SetDebugView.

//VTK::Output::Dec

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowBuffer;
uniform ivec2 shadowOrigin;
uniform int shadowParts;
uniform int shadowSlots[SHADOW_LIGHTS]; // parts of one light have the same, and come one after another
uniform float shadowShares[SHADOW_LIGHTS];
uniform int shadowView; // 0 visibility, 1 penumbra, 2 a quantity, such as the cost
uniform float shadowScale; // of the quantity: its white is 1

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - shadowOrigin;
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
  SHADOW_VISIBILITY ofLight = visibility;
  float most = 0.0;
  for (int i = 0; i < shadowParts; ++i)
  {
    vec4 texel = texelFetch(shadowBuffer, ivec3(pixel, i), 0);
    ofLight = i > 0 && shadowSlots[i] == shadowSlots[i - 1] ? ofLight : SHADOW_VISIBILITY(1.0);
    ofLight = shadowAddPart(ofLight, shadowShares[i], SHADOW_VISIBILITY(texel));
    visibility = min(visibility, ofLight);
    most = max(most, texel.r);
  }
  bool receiver = texelFetch(shadowReceivers, ivec3(pixel, 0), 0).w != 0.0;
  vec3 color = vec3(visibility);
  if (shadowView == 1)
  {
    float v = dot(color, vec3(1.0 / 3.0));
    color = v > 0.02 && v < 0.98 ? mix(vec3(0.1, 0.3, 1.0), vec3(1.0, 0.8, 0.1), v) : vec3(0.15 + 0.6 * v);
  }
  else if (shadowView == 2)
  {
    color = vec3(most * shadowScale);
  }
  gl_FragData[0] = vec4(receiver ? color : vec3(0.25, 0.2, 0.3), 1.0);
}
