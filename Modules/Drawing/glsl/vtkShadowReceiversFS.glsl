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

// Of the texel's fourth component, which is not 0 and whose sign is a flag.
shadowReceiver shadowUnpackReceiver(float texel)
{
  int bits = floatBitsToInt(texel);
  int exponent = (bits >> 23 & 255) - 127;
  int code = (bits & 8388607) + 8388608 * (exponent & 1);
  vec2 p = vec2(float(code & 4095), float(code >> 12)) / 4095.0 * 2.0 - 1.0;
  vec3 normal = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  vec2 signs = vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
  normal.xy = normal.z < 0.0 ? (1.0 - abs(p.yx)) * signs : normal.xy;
  return shadowReceiver(normalize(normal), exp2(float(exponent >> 1)));
}
