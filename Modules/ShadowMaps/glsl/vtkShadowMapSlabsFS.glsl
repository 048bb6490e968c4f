// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A layer of slabs: see vtkShadowMapSlabs.

//VTK::Output::Dec

uniform sampler2DArray shadowFirstDepth; // the maps
uniform sampler2DArray shadowFirst;
uniform sampler2DArray shadowSecondDepth;
uniform int shadowLayer;

// How far a plane may rise within a texel along an axis: no further than to the neighbours that are covered,
// since a face that the light grazes ends long before it has crossed the texel.
float shadowLimit(float depth, ivec2 texel, ivec2 along)
{
  ivec2 last = textureSize(shadowFirstDepth, 0).xy - 1;
  float low = texelFetch(shadowFirstDepth, ivec3(max(texel - along, 0), shadowLayer), 0).r;
  float high = texelFetch(shadowFirstDepth, ivec3(min(texel + along, last), shadowLayer), 0).r;
  return max(low < 1.0 ? abs(low - depth) : 0.0, high < 1.0 ? abs(high - depth) : 0.0);
}

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(shadowFirstDepth, ivec3(texel, shadowLayer), 0).r;
  vec4 slab = vec4(1e30, 1e30, 0.0, 0.0); // nothing, however far a receiver is
  if (depth < 1.0)
  {
    vec2 limit = vec2(shadowLimit(depth, texel, ivec2(1, 0)), shadowLimit(depth, texel, ivec2(0, 1)));
    vec2 slope = clamp(texelFetch(shadowFirst, ivec3(texel, 0), 0).gb, -limit, limit);
    float second = texelFetch(shadowSecondDepth, ivec3(texel, 0), 0).r;
    float open = depth + abs(slope.x) + abs(slope.y);
    slab = vec4(depth, second < 1.0 ? second : open, slope);
  }
  gl_FragData[0] = slab;
}
