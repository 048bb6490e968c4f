// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// One triangle that covers the viewport, without a vertex buffer.

void main()
{
  vec2 corner = vec2(float((gl_VertexID & 1) << 2), float((gl_VertexID & 2) << 1));
  gl_Position = vec4(corner - 1.0, 0.0, 1.0);
}
