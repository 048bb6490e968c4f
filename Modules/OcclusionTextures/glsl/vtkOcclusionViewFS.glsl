// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Debug view: slices, or one of their levels, side by side: the nearest to the light first.

//VTK::Output::Dec

uniform sampler2DArray shadowSource; // a target: four slices
uniform ivec2 shadowViewportOrigin;
uniform ivec2 shadowViewportSize;
uniform int shadowColumns;
uniform int shadowCount;
uniform int shadowTarget;
uniform int shadowLayer;
uniform vec2 shadowShare; // of the texture that is in use

void main()
{
  vec2 place = (gl_FragCoord.xy - vec2(shadowViewportOrigin)) / vec2(shadowViewportSize);
  vec2 cell = floor(vec2(place.x, 1.0 - place.y) * float(shadowColumns));
  int slice = int(cell.x) + shadowColumns * int(cell.y);
  vec2 within = fract(place * float(shadowColumns));
  bool shown = slice < shadowCount && slice >> 2 == shadowTarget;
  if (!shown && shadowTarget > 0)
  {
    discard;
  }
  bool border = any(lessThan(within, vec2(0.01))) || any(greaterThan(within, vec2(0.99)));
  vec3 at = vec3(within * shadowShare, float(shadowLayer));
  float covered = textureLod(shadowSource, at, 0.0)[slice & 3];
  // Darker, the farther from the light.
  vec3 color = vec3(0.7, 0.35, 0.1) * (1.0 - float(slice) / float(max(shadowCount, 1)));
  gl_FragData[0] =
    vec4(shown && !border ? mix(vec3(1.0), color, covered) : vec3(0.1, 0.15, 0.4), 1.0);
}
