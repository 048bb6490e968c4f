// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A corner of a wedge's bound, and what its edge is.

in vec4 wedgeCornerSWC; // w: 1 for a corner of the picture
in vec3 wedgeFromSWC;
in vec3 wedgeToSWC;
in vec4 wedgePlaneSWC;
in vec4 wedgeWidthSWC;
in float wedgeTimes;
in vec4 wedgeFirstFaceSWC; // planes of the faces that end there, outwards; 0 where there is none
in vec4 wedgeSecondFaceSWC;

uniform mat4 shadowSWCToClip;
uniform mat4 shadowSWCToVC;
uniform vec2 shadowRetreat;   // what it is moved back, so that what lies in its faces is before them
uniform float shadowFarthest; // clip coordinate of the depth of what is farthest

flat out vec3 shadowFromVC;
flat out vec3 shadowToVC;
flat out vec4 shadowPlaneSWC;
flat out vec4 shadowWidthSWC;
flat out float shadowTimes;
flat out vec4 shadowFirstFaceSWC;
flat out vec4 shadowSecondFaceSWC;

void main()
{
  vec4 cornerDC = shadowSWCToClip * vec4(wedgeCornerSWC.xyz, 1.0);
  cornerDC.z -= dot(shadowRetreat, cornerDC.zw);
  gl_Position = wedgeCornerSWC.w > 0.5 ? vec4(wedgeCornerSWC.xy, shadowFarthest, 1.0) : cornerDC;
  shadowFromVC = (shadowSWCToVC * vec4(wedgeFromSWC, 1.0)).xyz;
  shadowToVC = (shadowSWCToVC * vec4(wedgeToSWC, 1.0)).xyz;
  shadowPlaneSWC = wedgePlaneSWC;
  shadowWidthSWC = wedgeWidthSWC;
  shadowTimes = wedgeTimes;
  shadowFirstFaceSWC = wedgeFirstFaceSWC;
  shadowSecondFaceSWC = wedgeSecondFaceSWC;
}
