// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// Bounds of visibility at each pixel of the receivers, for vtkVisibilityBuffer::Resolve: 1 at least where
// nothing receives; 0 at most where a surface hides the whole light from itself.

//VTK::Output::Dec

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;
uniform int shadowLight;
uniform bool shadowMost; // the upper bound; else the lower one

void main()
{
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
  bool receives = shadowIsReceiver(receiverVC);
  shadowSelf = receiverVC.w > 0.0;
  bool away = receives && shadowFacesAway(shadowLight, receiverVC.xyz,
    shadowUnpackReceiver(receiverVC.w).normalVC);
  gl_FragData[0] = vec4(shadowMost ? (away ? 0.0 : 1.0) : (receives ? 0.0 : 1.0));
}
