// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A midpoint map: Woo, The shadow depth map revisited, Graphics Gems III, 1992; Zapotocky, Soft
// shadows on GPU, 2007, section 4.4.2. The middle of the first two layers where a body ends at the
// second, which shows its other side; where it is open, or a sheet, the first layer.

uniform sampler2DArray shadowFirstDepth;
uniform sampler2DArray shadowSecondDepth;
uniform sampler2DArray shadowSides; // 1 where the second layer shows the other side
uniform vec2 shadowDepthForm;       // depth = x - y / distance; y 0: depth is linear

void main()
{
  ivec3 texel = ivec3(ivec2(gl_FragCoord.xy), 0);
  float first = texelFetch(shadowFirstDepth, texel, 0).r;
  float second = texelFetch(shadowSecondDepth, texel, 0).r;
  float depth = first;
  if (second < 1.0 && texelFetch(shadowSides, texel, 0).r > 0.75)
  {
    // Of distances the middle: a sum of small terms, so that floats hold far from the light too.
    float middle = 0.5 * (first + second);
    float apart = second - first;
    depth = middle + (shadowDepthForm.y > 0.0
      ? 0.25 * apart * apart / (shadowDepthForm.x - middle) : 0.0);
  }
  gl_FragDepth = depth;
}
