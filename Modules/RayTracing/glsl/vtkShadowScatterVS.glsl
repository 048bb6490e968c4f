// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A value to a pixel.

in vec2 placeDC;
in vec3 value;

out vec3 valueVSOutput;

void main()
{
  valueVSOutput = value;
  gl_PointSize = 1.0;
  gl_Position = vec4(placeDC, 0.0, 1.0);
}
