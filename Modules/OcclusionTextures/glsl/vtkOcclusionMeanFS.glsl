// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// One level of N-buffers (Decoret 2005) from the level before: means over boxes of twice the
// side. A box's middle is a texel's lower corner; outside there is nothing.

//VTK::Output::Dec

uniform sampler2DArray shadowSource;
uniform int shadowLayer;
uniform ivec2 shadowOffsets; // of the boxes' middles, to the low and the high side

vec4 shadowFetch(ivec2 texel)
{
  bool inside = all(greaterThanEqual(texel, ivec2(0))) &&
    all(lessThan(texel, textureSize(shadowSource, 0).xy));
  return inside ? texelFetch(shadowSource, ivec3(texel, shadowLayer), 0) : vec4(0.0);
}

void main()
{
  ivec2 low = ivec2(gl_FragCoord.xy) + shadowOffsets.x;
  ivec2 high = ivec2(gl_FragCoord.xy) + shadowOffsets.y;
  gl_FragData[0] = 0.25 * (shadowFetch(low) + shadowFetch(ivec2(high.x, low.y)) +
    shadowFetch(ivec2(low.x, high.y)) + shadowFetch(high));
}
