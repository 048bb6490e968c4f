// Injected into each prop's fragment shader, before its lights: the factor of a light's colour.

uniform int shadowMode;                          // 0 off, 1 shade, 2 write the receiver
uniform bool shadowReceives;                     // this prop receives
uniform bool shadowCasts;                        // this prop casts
uniform bool shadowTranslucent;                  // this prop is not in the receivers' buffer
uniform bool shadowParallel;                     // the camera's projection
uniform int shadowLightOfSlot[SHADOW_MAX_SLOTS]; // of VTK's switched-on lights; -1 casts no shadow
uniform float shadowAttenuation[SHADOW_MAX_LIGHTS];
uniform mat4 shadowVCToWC;

#ifdef SHADOW_BUFFER
uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowBuffer;
uniform ivec2 shadowOrigin; // of the viewport

// The buffer's pixel that shows this surface: its own, or at an edge with several samples a pixel
// the neighbour that is nearest to it. False where none is near, for translucent surfaces.
bool shadowFindPixel(vec3 positionVC, float footprint, out ivec2 pixel)
{
  ivec2 own = ivec2(gl_FragCoord.xy) - shadowOrigin;
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

SHADOW_VISIBILITY shadowFactor(int slot, vec3 positionVC, vec3 normalVC, float footprint)
{
  int light = shadowLightOfSlot[slot];
  if (shadowMode != 1 || light < 0 || !shadowReceives)
  {
    return SHADOW_VISIBILITY(1.0);
  }
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
#ifdef SHADOW_BUFFER
  ivec2 pixel;
  if (shadowFindPixel(positionVC, footprint, pixel))
  {
    visibility = SHADOW_VISIBILITY(texelFetch(shadowBuffer, ivec3(pixel, light), 0));
  }
#endif
#ifdef SHADOW_FORWARD
  vec3 positionWC = (shadowVCToWC * vec4(positionVC, 1.0)).xyz;
  vec3 normalWC = mat3(shadowVCToWC) * normalVC;
  shadowSelf = shadowCasts;
  shadowSetRounding(positionVC, positionWC);
  if (shadowFacesAway(light, positionWC, normalWC))
  {
    visibility = SHADOW_VISIBILITY(0.0);
  }
  else
  {
    visibility = shadowVisibility(light, positionWC, normalWC);
  }
#endif
  return 1.0 - shadowAttenuation[light] * (1.0 - visibility);
}

// The geometric normal, towards the viewer, from the position's derivatives; scaled first, so that
// small units do not underflow. The fallback serves lines and points.
vec3 shadowGeometricNormal(vec3 positionVC, vec3 dx, vec3 dy, vec3 fallback)
{
  float scale = max(length(dx), length(dy));
  vec3 normal = scale > 0.0 ? cross(dx / scale, dy / scale) : vec3(0.0);
  float size = length(normal);
  normal = size > 0.0 ? normal / size : fallback;
  float towards = shadowParallel ? normal.z : -dot(normal, positionVC);
  return towards < 0.0 ? -normal : normal;
}
