// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// The mean over a tile of pixels that have taken different samples: see vtkTracedShadowMapPass. Weights are
// those of a box of 4 x 4 that is centred, so that each sample of a tile counts once; less for what lies on
// another surface, or differs by more than noise, such as the other side of an edge. What is sure stays as it is.

//VTK::Output::Dec

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowMask;
uniform float shadowNoise;
uniform int shadowLight;

// The mask tells by 2 more what is no mean of samples.
vec3 shadowFetchMask(ivec2 pixel, out bool sure)
{
  vec3 mask = texelFetch(shadowMask, ivec3(pixel, 0), 0).rgb;
  sure = mask.r > 1.5;
  return sure ? mask - 2.0 : mask;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(shadowMask, 0).xy - 1;
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, pixel);
  bool sure;
  vec3 own = shadowFetchMask(pixel, sure);
  vec3 sum = own;
  float total = 1.0;
  vec3 normalVC = shadowUnpackReceiver(receiverVC.w).normalVC;
  shadowSelf = receiverVC.w > 0.0;
  if (!sure && shadowIsReceiver(receiverVC) && !shadowFacesAway(shadowLight, receiverVC.xyz, normalVC))
  {
    for (int y = -2; y <= 2; ++y)
    {
      for (int x = -2; x <= 2; ++x)
      {
        ivec2 at = pixel + ivec2(x, y);
        vec4 otherVC = shadowFetchReceiver(shadowReceivers, clamp(at, ivec2(0), last));
        bool otherIsSure;
        vec3 other = shadowFetchMask(clamp(at, ivec2(0), last), otherIsSure);
        vec3 otherNormalVC = shadowUnpackReceiver(otherVC.w).normalVC;
        vec3 apartVC = otherVC.xyz - receiverVC.xyz;
        float apart = dot(apartVC, apartVC);
        // Its direction's sine off the plane, how far its normal is turned, its difference beside noise.
        float off = dot(normalVC, apartVC);
        vec3 differs = abs(other - own) / (2.0 * shadowNoise);
        float difference = max(differs.x, max(differs.y, differs.z));
        float turn = 1.0 - max(dot(normalVC, otherNormalVC), 0.0);
        float weight = (abs(x) == 2 ? 0.5 : 1.0) * (abs(y) == 2 ? 0.5 : 1.0) *
          max(1.0 - 100.0 * off * off / max(apart, 1e-30), 0.0) * max(1.0 - 200.0 * turn, 0.0) *
          exp(-difference * difference);
        bool counts = at == clamp(at, ivec2(0), last) && shadowIsReceiver(otherVC) &&
          (otherVC.w > 0.0) == (receiverVC.w > 0.0) && (x != 0 || y != 0);
        weight = counts ? weight : 0.0;
        sum += counts ? weight * other : vec3(0.0);
        total += weight;
      }
    }
  }
  gl_FragData[0] = vec4(min(sum / total, 1.0), 1.0); // rounding
}
