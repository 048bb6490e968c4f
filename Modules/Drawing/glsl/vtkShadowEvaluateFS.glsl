// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// Visibility of one light at each pixel of the receivers' buffer.

//VTK::Output::Dec

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers; // position in VC; w: packed, negative if not casting
uniform int shadowLight;
#ifdef SHADOW_OUTPUT_CHANGE
uniform float shadowShare; // of the light that this part stands for
#else
const float shadowShare = 1.0;
#endif

void main()
{
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
  if (shadowIsReceiver(receiverVC))
  {
    shadowReceiver receiver = shadowUnpackReceiver(receiverVC.w);
    vec3 normalVC = receiver.normalVC;
    shadowPropRounding = receiver.rounding;
    shadowSelf = receiverVC.w > 0.0;
#ifdef SHADOW_TELLS_AWAY
    visibility = shadowVisibility(shadowLight, receiverVC.xyz, normalVC);
#else
    if (shadowFacesAway(shadowLight, receiverVC.xyz, normalVC))
    {
      visibility = SHADOW_VISIBILITY(1.0 - shadowShare);
    }
    else
    {
      visibility = shadowVisibility(shadowLight, receiverVC.xyz, normalVC);
    }
#endif
  }
#ifdef SHADOW_QUANTITY
  gl_FragData[0] = vec4(SHADOW_QUANTITY);
#elif defined(SHADOW_OUTPUT_CHANGE)
  gl_FragData[0] = vec4(vec3(visibility) - 1.0, 0.0);
#else
  gl_FragData[0] = vec4(vec3(visibility), 1.0);
#endif
}
