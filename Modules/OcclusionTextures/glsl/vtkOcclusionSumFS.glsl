// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_explicit_attrib_location : require

// One step of a summed-area table along an axis (Crow 1984; Hensley et al. 2005): the sum of some
// texels that lie a stride apart, in integers. With SHADOW_FIRST they are those of the slices.

#ifdef SHADOW_FIRST
uniform sampler2DArray shadowSource;
#else
uniform usampler2DArray shadowSource;
#endif
uniform int shadowLayer;
uniform ivec2 shadowStride;
uniform int shadowTaps;

layout(location = 0) out uvec4 shadowSum;

void main()
{
  uvec4 sum = uvec4(0u);
  ivec2 texel = ivec2(gl_FragCoord.xy);
  for (int i = 0; i < shadowTaps && min(texel.x, texel.y) >= 0; ++i)
  {
#ifdef SHADOW_FIRST
    sum += uvec4(greaterThan(texelFetch(shadowSource, ivec3(texel, shadowLayer), 0), vec4(0.5)));
#else
    sum += texelFetch(shadowSource, ivec3(texel, shadowLayer), 0);
#endif
    texel -= shadowStride;
  }
  shadowSum = sum;
}
