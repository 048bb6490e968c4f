// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Debug view: the depth maps side by side, near white, far black, empty blue.

//VTK::Output::Dec

uniform sampler2DArray shadowMaps;
uniform ivec2 shadowViewportOrigin;
uniform ivec2 shadowViewportSize;
uniform int shadowColumns;

void main()
{
  vec2 place = (gl_FragCoord.xy - vec2(shadowViewportOrigin)) / vec2(shadowViewportSize);
  vec2 cell = floor(place * float(shadowColumns));
  int layer = int(cell.x) + shadowColumns * int(cell.y);
  vec3 color = vec3(0.2);
  if (layer < textureSize(shadowMaps, 0).z)
  {
    float depth = texture(shadowMaps, vec3(fract(place * float(shadowColumns)), float(layer))).r;
    color = depth < 1.0 ? vec3(1.0 - depth) : vec3(0.1, 0.15, 0.4);
  }
  gl_FragData[0] = vec4(color, 1.0);
}
