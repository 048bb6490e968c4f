// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A silhouette edge to the side of its volume, as vtkShadowVolumeSidesGS.glsl does, and the plane
// of it.

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec4 shadowLightDC; // the light, scaled: see vtkShadowVolumes
uniform float shadowKeep;   // of the vertex in its end far from the light
uniform sampler2DArray shadowPlanes; // two texels a line, row by row
uniform int shadowFirstLine;
uniform int shadowWidth;

flat out vec4 shadowPlaneSWC;
flat out vec4 shadowWidthSWC; // half of the penumbra's

void main()
{
  int first = 2 * (shadowFirstLine + gl_PrimitiveIDIn);
  ivec3 texel = ivec3(first % shadowWidth, first / shadowWidth, 0);
  vec4 planeSWC = texelFetch(shadowPlanes, texel, 0);
  vec4 widthSWC = texelFetch(shadowPlanes, texel + ivec3(1, 0, 0), 0);
  for (int i = 0; i < 2; ++i)
  {
    shadowPlaneSWC = planeSWC;
    shadowWidthSWC = widthSWC;
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
    shadowPlaneSWC = planeSWC;
    shadowWidthSWC = widthSWC;
    gl_Position = shadowKeep * gl_in[i].gl_Position - shadowLightDC;
    EmitVertex();
  }
  EndPrimitive();
}
