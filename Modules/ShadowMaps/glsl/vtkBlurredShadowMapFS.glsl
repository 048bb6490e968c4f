// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// One direction of the blur of map-blur: see vtkBlurredShadowMapPass.

//VTK::Output::Dec

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowMask;
uniform int shadowLight;
uniform vec2 shadowStep;       // (1, 0) or (0, 1)
uniform vec4 shadowEyeVC;   // w 1; or the direction to the viewer, w 0
uniform vec4 shadowWRow;    // of the projection
uniform vec3 shadowPixelVC; // what moves by a pixel along the step, times w
uniform float shadowSeparation; // assumed between blocker and receiver, in world units

const int shadowTaps = 7; // to either side of the middle

// The Gaussian's standard deviation in the light's half axes: that of a square or a disk evenly lit.
const float shadowSquareDeviation = 0.577;
const float shadowDiskDeviation = 0.5;

// The light's half axes as its footprint on a receiver, per world unit: a length in the light's plane
// dotted with one of them gives its place in the footprint.
void shadowFootprint(vec3 positionVC, out mat3 toLight)
{
  vec4 place = shadowLightPlaceVC[shadowLight];
  vec3 towardsVC = place.xyz - place.w * positionVC;
  vec3 directionVC = normalize(towardsVC);
  vec3 uVC = shadowLightUVC[shadowLight].xyz;
  vec3 vVC = shadowLightVVC[shadowLight].xyz;
  // A rectangle of no height is a line, which has no axis of its own.
  float lengthU = length(uVC);
  float lengthV = length(vVC);
  float longer = max(max(lengthU, lengthV), 1e-30);
  vec3 axisVC = cross(uVC / longer, vVC / longer) * (longer / max(min(lengthU, lengthV), 1e-30));
  axisVC = dot(axisVC, axisVC) < 0.5 ? directionVC : normalize(axisVC);
  vVC = lengthV < 1e-3 * longer ? 1e-3 * longer * cross(axisVC, uVC / longer) : vVC;
  uVC = lengthU < 1e-3 * longer ? 1e-3 * longer * cross(vVC / longer, axisVC) : uVC;
  if (shadowLightUVC[shadowLight].w > 0.0)
  {
    // A sphere's disk faces the receiver.
    float radius = shadowLightUVC[shadowLight].w;
    axisVC = directionVC;
    uVC = radius * normalize(abs(axisVC.x) < 0.8 ? cross(axisVC, vec3(1.0, 0.0, 0.0))
                                                : cross(axisVC, vec3(0.0, 1.0, 0.0)));
    vVC = cross(axisVC, uVC);
  }
  float cosine = dot(directionVC, axisVC);
  cosine = abs(cosine) < 0.1 ? (cosine < 0.0 ? -0.1 : 0.1) : cosine;
  float distance =
    place.w > 0.0 ? max(abs(dot(towardsVC, axisVC)), 1e-6 * length(towardsVC)) : 1.0;
  float separation = place.w > 0.0 ? min(shadowSeparation, distance / 3.0) : shadowSeparation;
  float ratio = place.w > 0.0 ? separation / (distance - separation) : separation;
  // Lengths are moved along the direction to the light into its plane.
  vec3 u = uVC / (dot(uVC, uVC) * ratio);
  vec3 v = vVC / (dot(vVC, vVC) * ratio);
  vec3 along = axisVC / cosine;
  toLight = transpose(mat3(u - along * dot(u, directionVC), v - along * dot(v, directionVC),
    vec3(0.0)));
}

// Height of the light's centre above a receiver's plane, and what its half axes add to it at most.
vec3 shadowHorizon(vec3 positionVC, vec3 normalVC)
{
  vec4 place = shadowLightPlaceVC[shadowLight];
  float radius = shadowLightUVC[shadowLight].w;
  vec3 towardsVC = place.xyz - place.w * positionVC;
  float height = dot(normalVC, towardsVC);
  // A sphere's disk faces the receiver.
  float sine = sqrt(max(1.0 - height * height / dot(towardsVC, towardsVC), 0.0));
  return vec3(height, radius > 0.0 ? vec2(radius * sine, 0.0)
    : abs(vec2(dot(normalVC, shadowLightUVC[shadowLight].xyz),
      dot(normalVC, shadowLightVVC[shadowLight].xyz))));
}

float shadowMost(vec3 horizon)
{
  return shadowLightVVC[shadowLight].w > 0.0 ? horizon.y + horizon.z : length(horizon.yz);
}

bool shadowSeesAll(vec3 horizon)
{
  return horizon.x >= shadowMost(horizon);
}

// The share of the light above the horizon: of a disk a segment, of a rectangle the distribution of
// the sum of two even ones.
float shadowAbove(vec3 horizon)
{
  if (shadowLightVVC[shadowLight].w > 0.0)
  {
    float most = max(horizon.y, horizon.z);
    float a = max(most, 1e-30);
    float b = max(min(horizon.y, horizon.z), 1e-3 * a);
    vec4 c = max(horizon.x + vec4(a + b, a - b, b - a, -a - b), 0.0) / a;
    return clamp((c.x * c.x - c.y * c.y - c.z * c.z + c.w * c.w) / (8.0 * b / a), 0.0, 1.0);
  }
  float h = clamp(horizon.x / max(length(horizon.yz), 1e-30), -1.0, 1.0);
  return 0.5 + (h * sqrt(1.0 - h * h) + asin(h)) / 3.14159265;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(shadowMask, 0).xy - 1;
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, pixel);
  float sum = texelFetch(shadowMask, ivec3(pixel, 0), 0).r;
  float total = 1.0;
  float deviation =
    shadowLightVVC[shadowLight].w > 0.0 ? shadowSquareDeviation : shadowDiskDeviation;
  float above = 1.0;
  if (shadowIsReceiver(receiverVC))
  {
#ifndef SHADOW_PLAIN
    vec3 normalVC = shadowUnpackReceiver(receiverVC.w).normalVC;
    mat3 toLight;
    shadowFootprint(receiverVC.xyz, toLight);
    // What a pixel's step is on the receiver, and how many pixels the points are apart to reach two
    // deviations of the Gaussian.
    vec3 viewVC = normalize(shadowEyeVC.w * receiverVC.xyz - shadowEyeVC.xyz);
    float facing = dot(normalVC, viewVC);
    facing = abs(facing) < 0.05 ? -0.05 : facing;
    vec3 stepVC = shadowPixelVC * dot(shadowWRow, vec4(receiverVC.xyz, 1.0));
    stepVC -= viewVC * (dot(normalVC, stepVC) / facing);
    float perPixel = length((toLight * stepVC).xy);
    float spacing = max(1.0, 2.0 * deviation / (float(shadowTaps) * max(perPixel, 1e-6)));
    float thickness = length(stepVC) * spacing;
    vec3 horizon = shadowHorizon(receiverVC.xyz, normalVC);
    bool own = receiverVC.w > 0.0 && !shadowSeesAll(horizon);
    above = own && shadowStep.y > 0.0 ? shadowAbove(horizon) : 1.0; // in the end
#else
    float spacing = 1.0;
#endif
    for (int i = 1; i <= shadowTaps; ++i)
    {
      int apart = int(float(i) * spacing + 0.5);
      for (int side = -1; side <= 1; side += 2)
      {
        ivec2 tap = pixel + side * apart * ivec2(shadowStep);
        bool inside = tap == clamp(tap, ivec2(0), last);
        tap = clamp(tap, ivec2(0), last);
        float mask = texelFetch(shadowMask, ivec3(tap, 0), 0).r;
#ifdef SHADOW_PLAIN
        float weight = exp(-0.5 * float(i * i) / (0.25 * float(shadowTaps * shadowTaps)));
#else
        vec4 tapVC = shadowFetchReceiver(shadowReceivers, tap);
        vec3 apartVC = tapVC.xyz - receiverVC.xyz;
        vec2 st = (toLight * apartVC).xy / deviation;
        float off = dot(normalVC, apartVC) / thickness;
        vec3 tapNormalVC = shadowUnpackReceiver(tapVC.w).normalVC;
        float turn = max(dot(normalVC, tapNormalVC), 0.0);
        float weight = exp(-0.5 * (dot(st, st) + off * off)) * turn * turn;
        // What its own surface hides there is no shadow here.
        vec3 tapHorizon = shadowHorizon(tapVC.xyz, tapNormalVC);
        bool hidden = tapVC.w > 0.0 && (tapHorizon.x < -shadowMost(tapHorizon) ||
          (!own && !shadowSeesAll(tapHorizon)));
        weight = !shadowIsReceiver(tapVC) || hidden ? 0.0 : weight;
#endif
        weight = inside ? weight : 0.0;
        sum += weight * mask;
        total += weight;
      }
    }
  }
  float visibility = sum / total;
#ifndef SHADOW_PLAIN
  visibility *= above;
#endif
  gl_FragData[0] = vec4(vec3(clamp(visibility, 0.0, 1.0)), 1.0); // rounding
}
