// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// As vtkShadowCasterVS.glsl, with the depth of what is drawn.

in vec3 vertexMC;

uniform mat4 MCToClip;
uniform vec4 shadowDepthMC; // a row

out float shadowDepthVSOutput;

//VTK::ShadowHoles::Dec

void main()
{
  gl_Position = MCToClip * vec4(vertexMC, 1.0);
  shadowDepthVSOutput = dot(shadowDepthMC, vec4(vertexMC, 1.0));
  //VTK::ShadowHoles::Impl
}
