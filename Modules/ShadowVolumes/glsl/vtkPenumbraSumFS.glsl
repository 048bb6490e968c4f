// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_gpu_shader5 : enable

// The share of the light that an edge lets through or hides, beyond what the light's centre tells.

//VTK::Output::Dec

flat in vec3 shadowFromVC;
flat in vec3 shadowToVC;
flat in vec4 shadowPlaneSWC;
flat in float shadowTimes;

uniform sampler2DArray shadowReceivers;
uniform int shadowLight;
uniform float shadowShare;

#if SHADOW_WEDGE_SHAPE == 0
// Where a ray from the square's middle meets its border, counterclockwise: 0 to 8.
float shadowPerimeter(vec2 p)
{
  float most = max(abs(p.x), abs(p.y));
  vec2 q = most > 0.0 ? p / most : vec2(1.0, 0.0);
  return abs(p.x) >= abs(p.y) ? (p.x >= 0.0 ? 1.0 + q.y : 5.0 - q.y)
                              : (p.y >= 0.0 ? 3.0 - q.x : 7.0 + q.x);
}
#endif

// The share of the light between an edge and the light's border, seen from its centre, from the images of
// the edge's ends (x, y, w): the sector less the triangle. Not signed.
float shadowCover(vec3 from, vec3 to)
{
  // The part of the edge between the receiver and the light. Near the receiver the image is far off.
  float least = 1e-6 * max(max(abs(from.z), abs(to.z)), max(length(from.xy), length(to.xy)));
  vec3 along = to - from;
  float first = 0.0;
  float last = 1.0;
#define SHADOW_CLIP(a, b) \
  { \
    float fa = a; \
    float fb = b; \
    float t = fa / (fa - fb); \
    first = fa < 0.0 ? (fb < 0.0 ? 2.0 : max(first, t)) : first; \
    last = fa >= 0.0 && fb < 0.0 ? min(last, t) : last; \
  }
  SHADOW_CLIP(from.z - least, to.z - least)
#if SHADOW_WEDGE_SHAPE != 3
  SHADOW_CLIP(1.0 - from.z, 1.0 - to.z)
#endif
#if SHADOW_WEDGE_SHAPE == 0
  SHADOW_CLIP(from.z - from.x, to.z - to.x)
  SHADOW_CLIP(from.z + from.x, to.z + to.x)
  SHADOW_CLIP(from.z - from.y, to.z - to.y)
  SHADOW_CLIP(from.z + from.y, to.z + to.y)
#endif
  if (!(last > first))
  {
    return 0.0;
  }
  vec3 a = first > 0.0 ? from + first * along : from;
  vec3 b = last < 1.0 ? from + last * along : to;
#if SHADOW_WEDGE_SHAPE == 0
  vec2 p = clamp(a.xy / a.z, -1.0, 1.0);
  vec2 q = clamp(b.xy / b.z, -1.0, 1.0);
  float d = abs(shadowPerimeter(p) - shadowPerimeter(q));
  return max(0.0, (min(d, 8.0 - d) - abs(p.x * q.y - p.y * q.x)) / 8.0);
#else
  // The image's line: its distance from the centre, and where it lies along it.
  vec3 line = cross(from, to);
  float slope = length(line.xy);
  float height = abs(line.z) / max(slope, 1e-30);
  if (!(height < 1.0))
  {
    return 0.0;
  }
  vec2 tangent = vec2(-line.y, line.x) / slope;
  float chord = sqrt((1.0 - height) * (1.0 + height));
  vec2 ends = clamp(vec2(dot(tangent, a.xy) / a.z, dot(tangent, b.xy) / b.z), -chord, chord);
  float twice = height * abs(ends.y - ends.x);
  return max(0.0, atan(twice, height * height + ends.x * ends.y) - twice) / 6.283185307;
#endif
}

void main()
{
  vec4 receiverVC = texelFetch(shadowReceivers, ivec3(gl_FragCoord.xy, 0), 0);
  shadowSelf = receiverVC.w > 0.0;
  if (!shadowIsReceiver(receiverVC) || shadowFacesAway(shadowLight, receiverVC.xyz,
    shadowUnpackReceiver(receiverVC.w).normalVC))
  {
    discard;
  }
#ifdef SHADOW_QUANTITY
  gl_FragData[0] = vec4(1.0);
#else
  mat3 rows = shadowLightRows(receiverVC.xyz);
  float cover = shadowCover((shadowFromVC - receiverVC.xyz) * rows,
    (shadowToVC - receiverVC.xyz) * rows);
  if (cover == 0.0)
  {
    discard;
  }
  bool behind = shadowIsBehind(shadowPlaneSWC, receiverVC.xyz);
#ifdef SHADOW_WEDGE_HALF
  if (behind != (SHADOW_WEDGE_HALF == 1))
  {
    discard;
  }
#endif
  gl_FragData[0] = vec4(vec3(shadowShare * shadowTimes * (behind ? cover : -cover)), 0.0);
#endif
}
