// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// One level of a depth pyramid, from the level before; or, with SHADOW_FIRST_LEVEL, from the maps: see
// vtkShadowDepthPyramid.

//VTK::Output::Dec

uniform sampler2DArray shadowSource; // the maps, or the pyramid, whose base level is the one before
uniform int shadowLayer;

vec2 shadowFetch(ivec2 texel)
{
#ifdef SHADOW_FIRST_LEVEL
  // Beyond the border of a map whose side is no power of two nothing is asked for.
  ivec2 last = textureSize(shadowSource, 0).xy - 1;
  vec4 slab = texelFetch(shadowSource, ivec3(min(texel, last), shadowLayer), 0);
#ifdef SHADOW_OF_SLABS
  float rise = 0.5 * (abs(slab.z) + abs(slab.w));
  return slab.x < 1.0e30 ? vec2(slab.x - rise, max(slab.y, slab.x + rise)) : vec2(1.0e30, -1.0e-30);
#else
  return vec2(slab.r);
#endif
#else
  return texelFetch(shadowSource, ivec3(texel, shadowLayer), 0).rg;
#endif
}

void main()
{
  ivec2 from = 2 * ivec2(gl_FragCoord.xy);
  vec2 a = shadowFetch(from);
  vec2 b = shadowFetch(from + ivec2(1, 0));
  vec2 c = shadowFetch(from + ivec2(0, 1));
  vec2 d = shadowFetch(from + ivec2(1, 1));
  float least = min(min(a.x, b.x), min(c.x, d.x));
#ifdef SHADOW_OF_SLABS
  // Negative where there are gaps: see vtkShadowDepthPyramid.
  float gaps = min(min(a.y, b.y), min(c.y, d.y)) < 0.0 ? -1.0 : 1.0;
  float most = gaps * max(max(abs(a.y), abs(b.y)), max(abs(c.y), abs(d.y)));
#else
  float most = max(max(a.y, b.y), max(c.y, d.y));
#endif
  gl_FragData[0] = vec4(least, most, 0.0, 1.0);
}
