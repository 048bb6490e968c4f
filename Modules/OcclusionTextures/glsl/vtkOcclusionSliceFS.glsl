// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_explicit_attrib_location : require

// Slices of the casters, each a channel of one of SHADOW_TARGETS targets; and what is nearest to
// the light. Blended by the greatest, so that nothing is hidden: see vtkOcclusionTextures.

//VTK::Output::Dec

//VTK::ShadowHoles::Dec

in float shadowDepthVSOutput;

uniform vec4 shadowForm; // perspective 1, else 0; d; 1 / range of depths, and their end, without it
uniform int shadowSlices;
uniform float shadowCuts[16]; // depth where a slice ends and the next begins
uniform bool shadowTwice;     // into the next slice too

// 1 / (d + h); without perspective 1 at the nearest depth and 0 at the farthest.
layout(location = SHADOW_TARGETS) out float shadowNearest;
layout(location = 0) out vec4 shadowTarget0;
#if SHADOW_TARGETS > 1
layout(location = 1) out vec4 shadowTarget1;
#endif
#if SHADOW_TARGETS > 2
layout(location = 2) out vec4 shadowTarget2;
#endif
#if SHADOW_TARGETS > 3
layout(location = 3) out vec4 shadowTarget3;
#endif

vec4 shadowChannels(int target, int slice, int next)
{
  ivec4 channels = ivec4(0, 1, 2, 3) + 4 * target;
  return max(vec4(equal(channels, ivec4(slice))), vec4(equal(channels, ivec4(next))));
}

void main()
{
  //VTK::ShadowHoles::Impl
  float depth = shadowDepthVSOutput;
  shadowNearest =
    shadowForm.x > 0.5 ? 1.0 / (shadowForm.y + depth) : (shadowForm.w - depth) * shadowForm.z;
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
