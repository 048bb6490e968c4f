// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Draws one caster's depth: see vtkShadowCasterDrawing.

in vec3 vertexMC;

uniform mat4 MCToClip;

//VTK::ShadowHoles::Dec

void main()
{
  gl_Position = MCToClip * vec4(vertexMC, 1.0);
  //VTK::ShadowHoles::Impl
}
