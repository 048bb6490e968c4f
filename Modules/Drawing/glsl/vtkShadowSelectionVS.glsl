// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// A vertex each pixel: whether its receiver is chosen. See vtkShadowSelection.

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;
uniform int shadowWidth;

out vec4 chosenTexel;
flat out int chosenPixel; // its number, or -1

void main()
{
  chosenTexel =
    texelFetch(shadowReceivers, ivec3(gl_VertexID % shadowWidth, gl_VertexID / shadowWidth, 0), 0);
  chosenPixel = -1;
  if (shadowIsReceiver(chosenTexel) && shadowSelect(chosenTexel))
  {
    chosenPixel = gl_VertexID;
  }
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
