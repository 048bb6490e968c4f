// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_explicit_attrib_location : require

// Slices of the casters, each a channel of one of SHADOW_TARGETS targets; and what is nearest to the light.
// Blended by the greatest, so that nothing is hidden: see vtkOcclusionTextures.

//VTK::ShadowHoles::Dec

uniform vec4 shadowDepths;   // perspective 1, else 0; d; nearest and farthest depth without perspective
uniform int shadowSlices;
uniform float shadowCuts[16]; // depth where a slice ends and the next begins
uniform bool shadowTwice;     // into the next slice too

layout(location = 0) out float shadowNearest; // 1 / (d + h), or 1 at the nearest depth and 0 at the farthest
layout(location = 1) out vec4 shadowTarget0;
#if SHADOW_TARGETS > 1
layout(location = 2) out vec4 shadowTarget1;
#endif
#if SHADOW_TARGETS > 2
layout(location = 3) out vec4 shadowTarget2;
#endif
#if SHADOW_TARGETS > 3
layout(location = 4) out vec4 shadowTarget3;
#endif

vec4 shadowChannels(int target, int slice, int next)
{
  ivec4 channels = ivec4(0, 1, 2, 3) + 4 * target;
  return max(vec4(equal(channels, ivec4(slice))), vec4(equal(channels, ivec4(next))));
}

void main()
{
  //VTK::ShadowHoles::Impl
  bool perspective = shadowDepths.x > 0.5;
  float depth = perspective ? 1.0 / gl_FragCoord.w - shadowDepths.y
    : mix(shadowDepths.z, shadowDepths.w, gl_FragCoord.z);
  shadowNearest = perspective ? gl_FragCoord.w : 1.0 - gl_FragCoord.z;
  int slice = 0;
  for (int i = 0; i < shadowSlices - 1; ++i)
  {
    slice += depth > shadowCuts[i] ? 1 : 0;
  }
  int next = shadowTwice && slice + 1 < shadowSlices ? slice + 1 : slice;
  shadowTarget0 = shadowChannels(0, slice, next);
#if SHADOW_TARGETS > 1
  shadowTarget1 = shadowChannels(1, slice, next);
#endif
#if SHADOW_TARGETS > 2
  shadowTarget2 = shadowChannels(2, slice, next);
#endif
#if SHADOW_TARGETS > 3
  shadowTarget3 = shadowChannels(3, slice, next);
#endif
}
