// The casting lights, and the packing of receivers: shared by the injected code and the evaluation
// in screen space. Vectors end in their space: VC view, WC world axes with the casters' origin.
//
// SHADOW_VISIBILITY is float, or vec3 where a light is textured.

uniform vec4 shadowLightPlaceWC[SHADOW_MAX_LIGHTS]; // position, w 1; or direction to it, w 0
uniform vec4 shadowLightUWC[SHADOW_MAX_LIGHTS];     // half axis; w: radius of a sphere, else 0
uniform vec4 shadowLightVWC[SHADOW_MAX_LIGHTS];     // half axis; w: 1 for a rectangle, else 0

// The receiver's prop casts too: then its own surface hides what lies behind it.
bool shadowSelf = true;

// How far the receiver's position may be off: it was transformed and interpolated in 24-bit floats,
// over triangles that may reach far out of the picture.
float shadowRounding = 0.0;

void shadowSetRounding(vec3 positionVC, vec3 positionWC)
{
  shadowRounding = (length(positionVC) + length(positionWC)) / 65536.0;
}

// What has been spent on this pixel: map reads, or rays.
float shadowCost = 0.0;

// The whole light lies behind the receiver's own surface.
bool shadowFacesAway(int light, vec3 positionWC, vec3 normalWC)
{
  if (!shadowSelf)
  {
    return false;
  }
  vec4 placeWC = shadowLightPlaceWC[light];
  vec2 extent = abs(vec2(dot(normalWC, shadowLightUWC[light].xyz),
    dot(normalWC, shadowLightVWC[light].xyz)));
  float reach = shadowLightUWC[light].w > 0.0 ? shadowLightUWC[light].w
    : (shadowLightVWC[light].w > 0.0 ? extent.x + extent.y : length(extent));
  return dot(normalWC, placeWC.xyz - placeWC.w * positionWC) + reach <= 0.0;
}

// Octahedral map of a unit normal to 2 x 12 bits, as an integer that a float holds exactly. 0 stays
// free for "no receiver"; the sign is free for a flag.
float shadowPackNormal(vec3 normal)
{
  vec2 p = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
  vec2 signs = vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
  p = normal.z < 0.0 ? (1.0 - abs(p.yx)) * signs : p;
  vec2 bits = floor((0.5 * p + 0.5) * 4095.0 + 0.5);
  return 1.0 + bits.x + 4096.0 * bits.y;
}

vec3 shadowUnpackNormal(float code)
{
  float bits = code - 1.0;
  vec2 p = vec2(mod(bits, 4096.0), floor(bits / 4096.0)) / 4095.0 * 2.0 - 1.0;
  vec3 normal = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  vec2 signs = vec2(p.x >= 0.0 ? 1.0 : -1.0, p.y >= 0.0 ? 1.0 : -1.0);
  normal.xy = normal.z < 0.0 ? (1.0 - abs(p.yx)) * signs : normal.xy;
  return normalize(normal);
}
