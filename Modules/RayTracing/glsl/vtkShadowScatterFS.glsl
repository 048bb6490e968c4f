// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

//VTK::Output::Dec

in vec3 valueVSOutput;

void main()
{
  gl_FragData[0] = vec4(valueVSOutput, 1.0);
}
