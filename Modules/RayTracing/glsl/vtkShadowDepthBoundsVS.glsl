// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A caster's triangles, as a light sees them: see vtkShadowDepthBounds. Holes by alpha are filled.

in vec3 vertexMC;

uniform mat4 MCToClip;

void main()
{
  gl_Position = MCToClip * vec4(vertexMC, 1.0);
}
