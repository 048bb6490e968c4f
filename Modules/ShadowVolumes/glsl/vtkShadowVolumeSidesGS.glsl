//VTK::System::Dec

// A silhouette edge to the side of its volume, seen counterclockwise from outside.

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec4 shadowLightDC; // the light, scaled: see vtkShadowVolumes
uniform float shadowKeep;   // of the vertex in its end far from the light

void main()
{
  for (int i = 0; i < 2; ++i)
  {
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
    gl_Position = shadowKeep * gl_in[i].gl_Position - shadowLightDC;
    EmitVertex();
  }
  EndPrimitive();
}
