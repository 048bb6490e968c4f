// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Depth layers of the casters for midpoint maps: which side of a face they show; with SHADOW_SECOND
// the second layer, and whether its faces show the other side than the first's.

//VTK::Output::Dec

//VTK::ShadowHoles::Dec

uniform bool shadowSheet; // the casters are flat: no face of theirs ends a body

#ifdef SHADOW_SECOND
uniform sampler2DArray shadowFirstDepth;
uniform sampler2DArray shadowFirstSide;
#endif

void main()
{
  //VTK::ShadowHoles::Impl
  float side = shadowSheet ? 0.5 : (gl_FrontFacing ? 1.0 : 0.0);
#ifdef SHADOW_SECOND
  ivec3 texel = ivec3(ivec2(gl_FragCoord.xy), 0);
  if (gl_FragCoord.z <= texelFetch(shadowFirstDepth, texel, 0).r)
  {
    discard;
  }
  side = abs(side - texelFetch(shadowFirstSide, texel, 0).r);
#endif
  gl_FragData[0] = vec4(side);
}
