//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// What volumes need not be asked: 1 where there is no receiver, 0 where the surface hides the whole
// light from itself, which rounding where a volume leaves its own surface must not change.

//VTK::Output::Dec

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;
uniform int shadowLight;

void main()
{
  vec4 receiverVC = texelFetch(shadowReceivers, ivec3(gl_FragCoord.xy, 0), 0);
  bool receives = shadowIsReceiver(receiverVC);
  shadowSelf = receiverVC.w > 0.0;
  vec3 normalVC = shadowUnpackReceiver(receiverVC.w).normalVC;
  if (receives && !shadowFacesAway(shadowLight, receiverVC.xyz, normalVC))
  {
    discard;
  }
  gl_FragData[0] = vec4(receives ? 0.0 : 1.0);
}
