// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_gpu_shader5 : enable

// What a side of a volume adds to the count: whether it lies between the eye and the receiver, or
// behind it, is told by which sides of its plane both are on.

//VTK::Output::Dec

flat in vec4 shadowPlaneSWC;
flat in vec4 shadowWidthSWC;

uniform sampler2DArray shadowReceivers;
uniform bool shadowPassing; // what is entered before the receiver counts; else what is left behind it

void main()
{
  vec4 receiverVC = texelFetch(shadowReceivers, ivec3(gl_FragCoord.xy, 0), 0);
  if (!shadowIsReceiver(receiverVC))
  {
    discard;
  }
  float inside = shadowIsBehind(shadowPlaneSWC, shadowWidthSWC, receiverVC) ? 1.0 : 0.0;
  float start = gl_FrontFacing == shadowPassing ? 0.0 : 1.0; // inside where counting begins
  if (inside == start)
  {
    discard;
  }
  gl_FragData[0] = vec4(inside - start);
}
