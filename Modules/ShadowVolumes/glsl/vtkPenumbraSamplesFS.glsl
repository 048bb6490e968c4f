// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_gpu_shader5 : enable

// Takes away the samples of a light that are hidden: by their own counts, or by the receiver's own
// surface.

//VTK::Output::Dec

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowSums;   // how often the centre is hidden
// How often more samples are: see vtkPenumbraCountFS.glsl.
uniform sampler2DArray shadowCounts0;
uniform sampler2DArray shadowCounts1;
uniform sampler2DArray shadowCounts2;
uniform sampler2DArray shadowCounts3;
uniform sampler2DArray shadowCounts4;
uniform sampler2DArray shadowCounts5;
uniform sampler2DArray shadowCounts6;
uniform sampler2DArray shadowCounts7;
uniform vec4 shadowSampleX[SHADOW_DIGITS * SHADOW_TARGETS];
uniform vec4 shadowSampleY[SHADOW_DIGITS * SHADOW_TARGETS];
uniform vec4 shadowSampleRed[SHADOW_DIGITS * SHADOW_TARGETS]; // weights
#ifdef SHADOW_COLOR
uniform vec4 shadowSampleGreen[SHADOW_DIGITS * SHADOW_TARGETS];
uniform vec4 shadowSampleBlue[SHADOW_DIGITS * SHADOW_TARGETS];
#endif

vec4 shadowCentre = vec4(0.0); // how often the light's centre is hidden
vec3 shadowHorizonLine = vec3(0.0);

// What the samples of a target add that are hidden.
vec3 shadowAddHidden(sampler2DArray counts, int target)
{
  vec3 hidden = vec3(0.0);
  vec4 digits = texelFetch(counts, ivec3(gl_FragCoord.xy, 0), 0);
  for (int k = SHADOW_DIGITS - 1; k >= 0; --k)
  {
    vec4 rest = floor(digits / SHADOW_BASE + 0.5);
    vec4 count = digits - SHADOW_BASE * rest + shadowCentre;
    digits = rest;
    int i = SHADOW_DIGITS * target + k;
    vec4 height = shadowHorizonLine.x * shadowSampleX[i] + shadowHorizonLine.y * shadowSampleY[i]
      + shadowHorizonLine.z;
    vec4 dark = max(vec4(lessThanEqual(height, vec4(0.0))),
      vec4(greaterThan(abs(count), vec4(0.5))));
#ifdef SHADOW_COLOR
    hidden += vec3(dot(dark, shadowSampleRed[i]), dot(dark, shadowSampleGreen[i]),
      dot(dark, shadowSampleBlue[i]));
#else
    hidden += dot(dark, shadowSampleRed[i]);
#endif
  }
  return hidden;
}

void main()
{
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
  if (!shadowIsReceiver(receiverVC))
  {
    discard;
  }
  shadowHorizonLine = receiverVC.w > 0.0 ? shadowHorizon(shadowSeeArea(receiverVC.xyz),
    shadowUnpackReceiver(receiverVC.w).normalVC) : vec3(0.0, 0.0, 1.0);
  shadowCentre = vec4(texelFetch(shadowSums, ivec3(gl_FragCoord.xy, 0), 0).r);
  vec3 hidden = shadowAddHidden(shadowCounts0, 0);
#if SHADOW_TARGETS > 1
  hidden += shadowAddHidden(shadowCounts1, 1);
#endif
#if SHADOW_TARGETS > 2
  hidden += shadowAddHidden(shadowCounts2, 2);
#endif
#if SHADOW_TARGETS > 3
  hidden += shadowAddHidden(shadowCounts3, 3);
#endif
#if SHADOW_TARGETS > 4
  hidden += shadowAddHidden(shadowCounts4, 4);
#endif
#if SHADOW_TARGETS > 5
  hidden += shadowAddHidden(shadowCounts5, 5);
#endif
#if SHADOW_TARGETS > 6
  hidden += shadowAddHidden(shadowCounts6, 6);
#endif
#if SHADOW_TARGETS > 7
  hidden += shadowAddHidden(shadowCounts7, 7);
#endif
  gl_FragData[0] = vec4(-hidden, 0.0);
}
