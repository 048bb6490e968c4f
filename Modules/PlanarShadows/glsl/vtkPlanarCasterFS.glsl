// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// What a caster leaves on the plane: see vtkPlanarShadowMaps.

//VTK::Output::Dec

//VTK::ShadowHoles::Dec

#if defined(SHADOW_MASK)
void main()
{
  //VTK::ShadowHoles::Impl
  gl_FragData[0] = vec4(0.0);
}
#elif defined(SHADOW_SHARE)
uniform vec3 shadowWeight; // of the light's sample

void main()
{
  //VTK::ShadowHoles::Impl
  gl_FragData[0] = vec4(-shadowWeight, 0.0);
}
#else
in float shadowHeightVSOutput;

uniform vec2 shadowHeightLimits;
uniform float shadowSpread; // the most

// Coverage, and how little the caster spreads a penumbra: blended by the greatest, that of the caster
// next to the plane stays. It bounds the penumbra: behind it, the others are hidden.
void main()
{
  //VTK::ShadowHoles::Impl
  float share = min(shadowHeightVSOutput, 0.999);
  float spread = max(share, 0.0) / (1.0 - shadowHeightLimits.y * share);
  gl_FragData[0] = vec4(1.0, 1.0 - min(spread / shadowSpread, 1.0), 0.0, 1.0);
}
#endif
