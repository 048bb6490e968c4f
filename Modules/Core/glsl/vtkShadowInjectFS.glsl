// SPDX-License-Identifier: BSD-3-Clause
// Injected into each prop's fragment shader, before its lights.

uniform bool shadowCasts; // this prop casts
uniform float shadowUnit; // about 1 / pixel footprint; negative under a mirroring camera
uniform float shadowRoundingOfProp;

// The geometric normal from the position's derivatives along the picture's x and y: it points to the
// viewer by itself. Scaled, so that the lengths of small units do not underflow. The zero vector
// where there is none, on lines and points.
vec3 shadowGeometricNormal(vec3 dx, vec3 dy)
{
  vec3 normal = cross(shadowUnit * dx, dy);
  return normal * inversesqrt(max(dot(normal, normal), 1e-37));
}

#ifdef SHADOW_RECEIVERS
uniform bool shadowReceives; // this prop receives
uniform float shadowReceiverScale; // the square of the prop's rounding, a power of two

// A receiver's normal, its prop's rounding and which side is seen in one float: octahedral map of the unit
// normal to 12 and 11 bits, the mantissa; the rounding and, its last bit, the back, the exponent. 0 stays free
// for "no receiver", the sign for a flag. vtkShadowReceiversFS.glsl and vtkShadowReceiver::Unpack read it.
float shadowPackReceiver(vec3 normal, bool back)
{
  vec2 p = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
  vec2 signs = vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
  p = normal.z < 0.0 ? (1.0 - abs(p.yx)) * signs : p;
  vec2 bits = floor((0.5 * p + 0.5) * vec2(4095.0, 2047.0) + 0.5);
  return (1.0 + (bits.x + 4096.0 * bits.y) / 8388608.0) * shadowReceiverScale * (back ? 2.0 : 1.0);
}
#ifdef SHADOW_BUFFER
uniform bool shadowWritesReceivers; // this draw fills the receivers' buffer; else it shades
#else
const bool shadowWritesReceivers = true;
#endif
#endif

#ifdef SHADOW_BUFFER
uniform bool shadowTranslucent; // this prop is not in the receivers' buffer
uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowBuffer;

// The buffer's pixel that shows this surface: its own, or at an edge with several samples a pixel
// the neighbour that is nearest to it. False where none is near, for translucent surfaces.
bool shadowFindPixel(vec3 positionVC, float footprint, out ivec2 pixel)
{
  ivec2 own = SHADOW_PIXEL;
  ivec2 last = textureSize(shadowReceivers, 0).xy - 1;
  float nearest = -1.0;
  for (int i = 0; i < 5; ++i)
  {
    ivec2 offset = ivec2(i == 1 ? 1 : (i == 2 ? -1 : 0), i == 3 ? 1 : (i == 4 ? -1 : 0));
    ivec2 candidate = clamp(own + offset, ivec2(0), last);
    vec4 receiverVC = texelFetch(shadowReceivers, ivec3(candidate, 0), 0);
    float separation = distance(receiverVC.xyz, positionVC);
    if (receiverVC.w != 0.0 && (nearest < 0.0 || separation < nearest))
    {
      nearest = separation;
      pixel = candidate;
      if (separation <= footprint)
      {
        return true;
      }
    }
  }
  return nearest >= 0.0 && !shadowTranslucent;
}
#endif

#if defined(SHADOW_BUFFER) || defined(SHADOW_FORWARD)
uniform float shadowAttenuation[SHADOW_LIGHTS]; // times the share; 0 on a prop that does not receive

// Of a loop over the lights, where it stays one.
uniform int shadowLightCount;

// What is seen of a part of a light.
SHADOW_VISIBILITY shadowSee(int light, vec3 positionVC, vec3 normalVC, float footprint)
{
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
#ifdef SHADOW_BUFFER
  ivec2 pixel;
  if (shadowFindPixel(positionVC, footprint, pixel))
  {
    visibility = SHADOW_VISIBILITY(texelFetch(shadowBuffer, ivec3(pixel, light), 0));
  }
#else
  shadowSelf = shadowCasts;
  shadowPropRounding = shadowRoundingOfProp;
#ifdef SHADOW_TELLS_AWAY
  visibility = shadowVisibility(light, positionVC, normalVC);
#else
  // A branch, so that loops within end at once: software rasterizers too run them no further.
  if (shadowFacesAway(light, positionVC, normalVC))
  {
    visibility = SHADOW_VISIBILITY(0.0);
  }
  else
  {
    visibility = shadowVisibility(light, positionVC, normalVC);
  }
#endif
#endif
  return visibility;
}
#endif
