// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Debug view: the layers side by side, dark where there is shadow; blue where there is no layer.

//VTK::Output::Dec

uniform sampler2DArray shadowPlanarMaps;
uniform ivec2 shadowViewportOrigin;
uniform ivec2 shadowViewportSize;
uniform int shadowColumns;
uniform int shadowLayers;
uniform bool shadowCoverage; // the layers hold coverage, not visibility

void main()
{
  vec2 place = (gl_FragCoord.xy - vec2(shadowViewportOrigin)) / vec2(shadowViewportSize);
  vec2 cell = floor(place * float(shadowColumns));
  int layer = int(cell.x) + shadowColumns * int(cell.y);
  vec3 color = vec3(0.1, 0.15, 0.4);
  vec2 within = fract(place * float(shadowColumns));
  if (layer < shadowLayers)
  {
    vec4 texel = textureLod(shadowPlanarMaps, vec3(within, float(layer)), 0.0);
    color = shadowCoverage ? vec3(1.0 - texel.r) : SHADOW_VIEW_SWIZZLE;
    color = mix(vec3(0.1, 0.15, 0.4), color,
      float(all(greaterThan(within, vec2(0.004))) && all(lessThan(within, vec2(0.996)))));
  }
  gl_FragData[0] = vec4(color, 1.0);
}
