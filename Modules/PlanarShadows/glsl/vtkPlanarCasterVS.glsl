// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Projects a caster onto a plane (thesis equation 2.4, composed on the CPU in double). What is no
// occluder is cut off: what lies below the plane, and what is not below the light.

in vec3 vertexMC;

uniform mat4 MCToClip;
uniform vec4 shadowHeightMC;     // a point's height above the plane, as a share of the light's
uniform vec2 shadowHeightLimits; // x: the least; y: 1 where the light is at a height, else 0

out float shadowHeightVSOutput;

//VTK::ShadowHoles::Dec

void main()
{
  float height = dot(shadowHeightMC, vec4(vertexMC, 1.0));
  shadowHeightVSOutput = height;
  gl_ClipDistance[0] = height - shadowHeightLimits.x;
  gl_ClipDistance[1] = 1.0 - shadowHeightLimits.y * height;
  gl_Position = MCToClip * vec4(vertexMC, 1.0);
  //VTK::ShadowHoles::Impl
}
