// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// The near or the far cap of a volume.

in vec3 vertexMC;

uniform mat4 MCToClip;
uniform vec4 shadowLightDC; // as in vtkShadowVolumeSidesGS.glsl, that both meet
uniform float shadowKeep;
uniform int shadowFar; // 1 for the far cap
uniform vec2 shadowRetreat; // of the near cap: what positions are off by

void main()
{
  vec4 positionDC = MCToClip * vec4(vertexMC, 1.0);
  gl_Position = shadowFar == 1
    ? shadowKeep * positionDC - shadowLightDC
    : positionDC - vec4(0.0, 0.0, dot(shadowRetreat, positionDC.zw), 0.0);
}
