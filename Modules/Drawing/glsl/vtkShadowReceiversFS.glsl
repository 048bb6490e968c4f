// SPDX-License-Identifier: BSD-3-Clause
// Reads the receivers' buffer: what shadowPackReceiver in vtkShadowInjectFS.glsl has packed. Shaders that
// use it enable GL_ARB_shader_bit_encoding.

struct shadowReceiver
{
  vec3 normalVC;
  float rounding; // of its prop's positions: a power of two that is not less
};

// A texel of a receiver. What is not finite counts as lit: it is asked nothing.
bool shadowIsReceiver(vec4 texel)
{
  return texel.w != 0.0 && !any(isnan(texel)) && !any(isinf(texel));
}

// Of a texel's fourth component: the back of a surface is seen.
bool shadowIsBack(float texel)
{
  return texel != 0.0 && ((floatBitsToInt(texel) >> 23 & 255) + 1 & 1) != 0;
}

// The texel of a pixel. Its normal is towards the viewer, but for a back that is seen alone amid fronts: there
// the far side of a body has won the depth test at a silhouette, and what is meant is the body's outside.
vec4 shadowFetchReceiver(sampler2DArray receivers, ivec2 pixel)
{
  vec4 texel = texelFetch(receivers, ivec3(pixel, 0), 0);
  if (shadowIsBack(texel.w))
  {
    ivec2 last = textureSize(receivers, 0).xy - 1;
    bool alone = true;
    bool amidFronts = false;
    for (int i = 0; i < 9 && alone; ++i)
    {
      ivec2 other = clamp(pixel + ivec2(i % 3, i / 3) - 1, ivec2(0), last);
      float w = texelFetch(receivers, ivec3(other, 0), 0).w;
      bool back = shadowIsBack(w);
      alone = !back || other == pixel;
      amidFronts = amidFronts || (w != 0.0 && !back);
    }
    texel.w *= alone && amidFronts ? 1.0 : 0.5;
  }
  return texel;
}

// Of the fourth component of a texel that was fetched so, which is not 0 and whose sign is a flag.
shadowReceiver shadowUnpackReceiver(float texel)
{
  int bits = floatBitsToInt(texel);
  int exponent = (bits >> 23 & 255) - 127;
  int code = bits & 8388607;
  vec2 p = vec2(float(code & 4095), float(code >> 12)) / vec2(4095.0, 2047.0) * 2.0 - 1.0;
  vec3 normal = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  vec2 signs = vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
  normal.xy = normal.z < 0.0 ? (1.0 - abs(p.yx)) * signs : normal.xy;
  return shadowReceiver(
    normalize((exponent & 1) != 0 ? -normal : normal), exp2(float(exponent >> 1)));
}
