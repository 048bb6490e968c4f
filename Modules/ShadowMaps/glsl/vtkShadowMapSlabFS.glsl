// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// The first layer of the casters for vtkShadowMapSlabs: which side of which caster it shows, and its slope;
// with SHADOW_SECOND the depth where that caster next shows its other side.

//VTK::Output::Dec

//VTK::ShadowHoles::Dec

uniform float shadowCaster; // its number from 1, 0 of a sheet

#ifdef SHADOW_SECOND
uniform sampler2DArray shadowFirstDepth; // the maps
uniform sampler2DArray shadowFirst;
uniform int shadowLayer;
#endif

void main()
{
  vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
  //VTK::ShadowHoles::Impl
  float side = gl_FrontFacing ? shadowCaster : -shadowCaster;
#ifdef SHADOW_SECOND
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float first = texelFetch(shadowFirst, ivec3(texel, 0), 0).r;
  if (side == 0.0 || side != -first ||
    gl_FragCoord.z <= texelFetch(shadowFirstDepth, ivec3(texel, shadowLayer), 0).r)
  {
    discard;
  }
#endif
  gl_FragData[0] = vec4(side, slope, 0.0);
}
