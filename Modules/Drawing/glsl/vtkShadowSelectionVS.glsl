// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A vertex for some pixels one after another: see vtkShadowSelection.

flat out int firstPixel;

void main()
{
  firstPixel = gl_VertexID * SHADOW_PIXELS;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
