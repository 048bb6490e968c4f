//VTK::System::Dec

// A silhouette edge to the side of its volume, seen counterclockwise from outside.

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec4 shadowLightDC;   // the light, scaled: see vtkShadowVolumes
uniform float shadowKeep;     // of the vertex in its end far from the light
uniform vec3 shadowStep;      // of the rasterizer in x and y, and of the depth; the last one negative
                              // under a mirroring camera

void main()
{
  vec4 nearDC[2] = vec4[2](gl_in[0].gl_Position, gl_in[1].gl_Position);
  vec4 farDC[2] = vec4[2](
    shadowKeep * nearDC[0] - shadowLightDC, shadowKeep * nearDC[1] - shadowLightDC);
  // A side that is seen from within stands behind the surface whose edge it stands on. Moved back by
  // a step of the depth and of the rasterizer along its slope, it is not counted before that surface
  // by rounding, which would take a volume too much away.
  vec4 a = nearDC[0];
  vec4 b = farDC[0];
  vec4 c = nearDC[1];
  float turn = dot(a.xyw, cross(b.xyw, c.xyw));
  vec2 slope = vec2(dot(a.zyw, cross(b.zyw, c.zyw)), dot(a.xzw, cross(b.xzw, c.xzw)));
  float back = 0.0;
  if (turn * shadowStep.z < 0.0)
  {
    back = abs(shadowStep.z) + dot(abs(slope), shadowStep.xy) / abs(turn);
  }
  for (int i = 0; i < 2; ++i)
  {
    gl_Position = nearDC[i] + vec4(0.0, 0.0, back * nearDC[i].w, 0.0);
    EmitVertex();
    gl_Position = farDC[i] + vec4(0.0, 0.0, back * farDC[i].w, 0.0);
    EmitVertex();
  }
  EndPrimitive();
}
