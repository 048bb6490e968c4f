// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_explicit_attrib_location : require

// All slices of a texel as bits.

uniform sampler2DArray shadowSource0;
uniform sampler2DArray shadowSource1;
uniform sampler2DArray shadowSource2;
uniform sampler2DArray shadowSource3;
uniform int shadowLayer;

layout(location = 0) out uint shadowBits;

uint shadowPack(vec4 slices, int first)
{
  uvec4 bits = uvec4(greaterThan(slices, vec4(0.5)));
  return (bits.x | bits.y << 1u | bits.z << 2u | bits.w << 3u) << uint(first);
}

void main()
{
  ivec3 texel = ivec3(gl_FragCoord.xy, shadowLayer);
  shadowBits = shadowPack(texelFetch(shadowSource0, texel, 0), 0);
#if SHADOW_TARGETS > 1
  shadowBits |= shadowPack(texelFetch(shadowSource1, texel, 0), 4);
#endif
#if SHADOW_TARGETS > 2
  shadowBits |= shadowPack(texelFetch(shadowSource2, texel, 0), 8);
#endif
#if SHADOW_TARGETS > 3
  shadowBits |= shadowPack(texelFetch(shadowSource3, texel, 0), 12);
#endif
}
