// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A silhouette edge to the side of its volume, as vtkShadowVolumeSidesGS.glsl does, and the plane
// of it.

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec4 shadowLightDC; // the light, scaled: see vtkShadowVolumes
uniform float shadowKeep;   // of the vertex in its end far from the light
uniform sampler2DArray shadowPlanes; // a plane a line, row by row
uniform int shadowFirstLine;
uniform int shadowWidth;

flat out vec4 shadowPlaneSWC;

void main()
{
  int line = shadowFirstLine + gl_PrimitiveIDIn;
  vec4 planeSWC = texelFetch(shadowPlanes, ivec3(line % shadowWidth, line / shadowWidth, 0), 0);
  for (int i = 0; i < 2; ++i)
  {
    shadowPlaneSWC = planeSWC;
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
    shadowPlaneSWC = planeSWC;
    gl_Position = shadowKeep * gl_in[i].gl_Position - shadowLightDC;
    EmitVertex();
  }
  EndPrimitive();
}
