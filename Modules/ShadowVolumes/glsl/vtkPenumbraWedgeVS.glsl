// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A corner of a wedge's bound, and what its edge is.

in vec4 wedgeBaseSWC; // w: what the corner is, see vtkShadowWedge::Corner
in vec3 wedgeAlongSWC;
in vec3 wedgeFromSWC;
in vec3 wedgeToSWC;
in vec4 wedgePlaneSWC;
in float wedgeTimes;
in vec4 wedgeFirstFaceSWC; // planes of the faces that end there, outwards; 0 where there is none
in vec4 wedgeSecondFaceSWC;

uniform mat4 shadowSWCToClip;
uniform mat4 shadowSWCToVC;
uniform float shadowReach;    // in a parallel view, how far the bound is drawn; else 0
uniform float shadowFarthest; // clip coordinate of the depth of what is farthest

flat out vec3 shadowFromVC;
flat out vec3 shadowToVC;
flat out vec4 shadowPlaneSWC;
flat out float shadowTimes;
flat out vec4 shadowFirstFaceSWC;
flat out vec4 shadowSecondFaceSWC;

void main()
{
  vec4 cornerSWC = wedgeBaseSWC.w > 0.5 ? vec4(wedgeBaseSWC.xyz, 1.0)
    : (shadowReach > 0.0 ? vec4(wedgeBaseSWC.xyz + shadowReach * wedgeAlongSWC, 1.0)
                         : vec4(wedgeAlongSWC, 0.0));
  gl_Position = wedgeBaseSWC.w > 1.5 ? vec4(wedgeBaseSWC.xy, shadowFarthest, 1.0)
                                     : shadowSWCToClip * cornerSWC;
  shadowFromVC = (shadowSWCToVC * vec4(wedgeFromSWC, 1.0)).xyz;
  shadowToVC = (shadowSWCToVC * vec4(wedgeToSWC, 1.0)).xyz;
  shadowPlaneSWC = wedgePlaneSWC;
  shadowTimes = wedgeTimes;
  shadowFirstFaceSWC = wedgeFirstFaceSWC;
  shadowSecondFaceSWC = wedgeSecondFaceSWC;
}
