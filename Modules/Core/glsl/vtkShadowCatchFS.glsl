// SPDX-License-Identifier: BSD-3-Clause
// Injected into a shadow catcher's fragment shader: its lights' brightness with shadow in red, without
// in green.

vec3 shadowBrightness(vec3 color, vec3 factor)
{
  const vec3 luminance = vec3(0.2126, 0.7152, 0.0722); // of linear sRGB, ITU-R BT.709
  return vec3(dot(color * factor, luminance), dot(color, luminance), 0.0);
}

// Black, as opaque as the share of light that is missing.
vec4 shadowCatch(vec4 shaded)
{
  float missing = shaded.g > 0.0 ? clamp(1.0 - shaded.r / shaded.g, 0.0, 1.0) : 0.0;
  return vec4(0.0, 0.0, 0.0, missing * shaded.a);
}
