// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A silhouette edge to the side of its volume, seen counterclockwise from outside.

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform vec4 shadowLightDC; // the light, scaled: see vtkShadowVolumes
uniform float shadowKeep;   // of the vertex in its end far from the light
uniform float shadowFacing; // 1, or -1 under a mirroring camera
uniform vec2 shadowRetreat;    // what a side seen from within is moved back: a share of its depth, a depth

void main()
{
  vec4 nearDC[2] = vec4[2](gl_in[0].gl_Position, gl_in[1].gl_Position);
  vec4 farDC[2] = vec4[2](
    shadowKeep * nearDC[0] - shadowLightDC, shadowKeep * nearDC[1] - shadowLightDC);
  // A side that is seen from within stands behind the surface whose edge it stands on. Moved back by
  // a little, it is not counted before that surface by rounding, which would take away a volume.
  float turn = dot(nearDC[0].xyw, cross(farDC[0].xyw, nearDC[1].xyw));
  vec2 back = turn * shadowFacing < 0.0 ? shadowRetreat : vec2(0.0);
  for (int i = 0; i < 2; ++i)
  {
    gl_Position = nearDC[i] - vec4(0.0, 0.0, dot(back, nearDC[i].zw), 0.0);
    EmitVertex();
    gl_Position = farDC[i] - vec4(0.0, 0.0, dot(back, farDC[i].zw), 0.0);
    EmitVertex();
  }
  EndPrimitive();
}
