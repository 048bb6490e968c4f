// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// At most the depth that the triangle has anywhere in this texel; less than that of "no caster", 1.

//VTK::Output::Dec

flat in vec4 shadowPlane;
flat in vec2 shadowGradient;

void main()
{
  float depth = shadowPlane.z + dot(shadowGradient, gl_FragCoord.xy - shadowPlane.xy);
  gl_FragDepth = clamp(max(depth, shadowPlane.w), 0.0, 0.9999999);
}
