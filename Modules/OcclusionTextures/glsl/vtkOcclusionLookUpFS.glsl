// SPDX-License-Identifier: BSD-3-Clause
// What all ways to ask slices share: a receiver in a view of them, the light's rectangle as it
// sees it through a plane, and contacts. See vtkOcclusionView for the geometry.
//
// shadowSets: for each view of a light SHADOW_SET_VECTORS vectors:
//
//   0, 1, 2  rows from VC to the view: x, y, depth
//   3        perspective 1, else 0; d; number of slices; face of a cube 1, else 0
//   4        window's low corner at w = 1, texels a unit
//   5        a texel's sides at w = 1, the texture's in texels
//   6, 7     the light's half axes in the view, as a rectangle of equal second moments (bits: its
//            own); radius of a sphere; 1 for a disk, 2 for a rectangle
//   8        without perspective, the farthest depth and 1 / range of what is nearest
//
// and for each slice two: its plane's depth, 1 / fade, 1 / (d + plane) or minus the plane, its
// upper end's depth; where it holds something, in texels.
//
// What is looked up lies above the receiver's own plane, by more than what texels are off: there
// a convex body has nothing of itself. Nothing else tells a surface from what hides it.

#ifdef SHADOW_FEW_SETS
uniform vec4 shadowSets[SHADOW_FEW_SETS];
#define SHADOW_SET(index) shadowSets[index]
#else
uniform samplerBuffer shadowSets;
#define SHADOW_SET(index) texelFetch(shadowSets, index)
#endif
uniform int shadowFirstSet[SHADOW_LIGHTS];
uniform int shadowEndOfSets[SHADOW_LIGHTS];
uniform sampler2DArray shadowNearest;

const int shadowHeader = 9;
const float shadowNormalRounding = 1.0 / 2048.0; // of packed normals, in radians

// Told to debug views.
float shadowKernelTexels = 0.0; // the widest kernel's longer side
float shadowSlicesRead = 0.0;

struct shadowPlace
{
  int light;
  int set;
  int first;         // vector
  vec3 position;     // in the view
  vec3 normal;       // zero where the receiver has no plane of its own
  bool perspective;
  float behind;
  int slices;
  vec2 slope;        // of the ray from the light's centre
  vec2 u;            // the light's half axes along that ray, at the light
  vec2 v;
  float rounding;
  float height;      // of the light's centre over the receiver's plane, as a share of the depth
};

struct shadowKernel
{
  vec2 centre; // in texels
  vec2 u;      // the light's half axes there
  vec2 v;
  float above; // of the centre over the receiver's plane, at the slice's ends: the least
  vec2 rise;   // what a texel along either axis rises over it
};

// False where the view has nothing before the receiver.
bool shadowFindPlace(int light, int set, vec3 positionVC, vec3 normalVC, out shadowPlace place)
{
  place.light = light;
  place.set = set;
  place.first = set * SHADOW_SET_VECTORS;
  vec4 receiverVC = vec4(positionVC, 1.0);
  vec4 row0 = SHADOW_SET(place.first);
  vec4 row1 = SHADOW_SET(place.first + 1);
  vec4 row2 = SHADOW_SET(place.first + 2);
  vec4 form = SHADOW_SET(place.first + 3);
  vec4 axisU = SHADOW_SET(place.first + 6);
  vec4 axisV = SHADOW_SET(place.first + 7);
  place.position = vec3(dot(row0, receiverVC), dot(row1, receiverVC), dot(row2, receiverVC));
  place.normal = vec3(dot(row0.xyz, normalVC), dot(row1.xyz, normalVC), dot(row2.xyz, normalVC));
  place.perspective = form.x > 0.5;
  place.behind = form.y;
  place.slices = int(form.z + 0.5);
  float depth = place.position.z;
  bool before = !place.perspective || depth > 0.0;
  place.slope = place.perspective ? place.position.xy / max(depth, 1e-30) : vec2(0.0);
  before = before && (form.w < 0.5 || max(abs(place.slope.x), abs(place.slope.y)) <= 1.000001);
  place.u = axisU.xy - place.slope * axisU.z;
  place.v = axisV.xy - place.slope * axisV.z;
  if (axisU.w > 0.0)
  {
    // The disk that faces the receiver.
    float out2 = dot(place.slope, place.slope);
    vec2 along = out2 > 0.0 ? place.slope * inversesqrt(out2) : vec2(1.0, 0.0);
    place.u = axisU.w * sqrt(1.0 + out2) * along;
    place.v = axisU.w * vec2(-along.y, along.x);
  }
  place.rounding = shadowRounding(positionVC);
  place.height = -(place.normal.z + dot(place.normal.xy, place.slope));
  if (!shadowSelf || dot(normalVC, normalVC) < 0.5)
  {
    // It has no surface that hides: all that is before the receiver counts.
    place.normal = vec3(0.0);
    place.height = 1.0;
  }
  return before;
}

// The light through a slice's plane.
shadowKernel shadowFindKernel(shadowPlace place, vec4 slice)
{
  vec4 window = SHADOW_SET(place.first + 4);
  vec4 texel = SHADOW_SET(place.first + 5);
  shadowKernel kernel;
  float below = place.position.z - slice.x;
  float w = place.perspective ? place.behind + slice.x : 1.0;
  vec2 centre = place.perspective ? place.slope * (slice.x * slice.z) : place.position.xy;
  float share = place.perspective ? below * slice.z / place.position.z : below;
  kernel.centre = (centre - window.xy) * window.zw;
  kernel.u = place.u * share * window.zw;
  kernel.v = place.v * share * window.zw;
  kernel.rise = w * place.normal.xy * texel.xy;
  // What the slice holds is projected along lines to the centre of projection: they have to be
  // above the plane up to its upper end.
  float climb = (slice.x - slice.w) *
    (place.normal.z + (place.perspective ? dot(place.normal.xy, centre) : 0.0));
  float reach = below * sqrt(1.0 + dot(place.slope, place.slope)) * shadowNormalRounding;
  kernel.above = below * place.height - max(climb, 0.0) - place.rounding - reach;
  return kernel;
}

// The light's share that lies above the receiver's own horizon.
float shadowSeeHorizon(int light, vec3 positionVC, vec3 normalVC)
{
#ifdef SHADOW_HARD
  return 1.0;
#else
  vec4 placeVC = shadowLightPlaceVC[light];
  vec3 towardsVC = placeVC.xyz - placeVC.w * positionVC;
  float height = dot(normalVC, towardsVC);
  vec2 extent = abs(vec2(dot(normalVC, shadowLightUVC[light].xyz),
    dot(normalVC, shadowLightVVC[light].xyz)));
  float radius = shadowLightUVC[light].w;
  if (shadowLightVVC[light].w > 0.0)
  {
    // A rectangle, cut by a line: the distribution of a sum of two even ones.
    float a = max(extent.x, extent.y);
    float b = max(min(extent.x, extent.y), 1e-3 * a);
    vec4 steps = max(height + vec4(a + b, a - b, b - a, -a - b), 0.0);
    steps *= steps;
    return !shadowSelf || height >= a + b ? 1.0
      : clamp((steps.x - steps.y - steps.z + steps.w) / (8.0 * a * b), 0.0, 1.0);
  }
  float cosine = height * inversesqrt(max(dot(towardsVC, towardsVC), 1e-37));
  float reach = radius > 0.0 ? radius * sqrt(max(1.0 - cosine * cosine, 0.0)) : length(extent);
  if (!shadowSelf || height >= reach)
  {
    return 1.0;
  }
  float cut = clamp(height / reach, -1.0, 1.0);
  return 0.5 + (asin(cut) + cut * sqrt(1.0 - cut * cut)) / 3.14159265;
#endif
}

// Contacts: what the slices cannot tell, since the receiver is in them, what is nearest to the
// light as seen from the centre of projection tells; and all, where the light is within a texel.

// What is nearest at a texel's middle, less what the receiver's plane has there: positive above
// it, by more than folds of its surface rise within a texel.
float shadowFindRise(shadowPlace place, vec3 form, ivec2 texel)
{
  vec4 window = SHADOW_SET(place.first + 4);
  vec4 sides = SHADOW_SET(place.first + 5);
  float nearest = texelFetch(shadowNearest, ivec3(texel, place.set), 0).r;
  bool inside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(sides.zw)));
  vec2 at = window.xy + (vec2(texel) + 0.5) * sides.xy;
  float plane = dot(form.xy, at) + form.z;
  float unit = place.perspective ? nearest : SHADOW_SET(place.first + 8).y;
  float fold = 0.5 * unit * max(sides.x, sides.y) + 0.2 * dot(abs(form.xy), sides.xy);
  float rounding = 2e-6 * (place.perspective ? nearest : 1.0);
  return inside && nearest > 0.0 ? nearest - plane - fold - rounding : -1.0;
}

// Depth of what is nearest there.
float shadowFindDepth(shadowPlace place, ivec2 texel)
{
  float nearest = texelFetch(shadowNearest, ivec3(texel, place.set), 0).r;
  vec4 form = SHADOW_SET(place.first + 8);
  return place.perspective ? 1.0 / max(nearest, 1e-30) - place.behind : form.x - nearest / form.y;
}

// The receiver's plane as what is nearest would be on it: of a place at w = 1 a dot product, and
// a constant. False where the centre of projection does not lie above it.
bool shadowFindPlane(shadowPlace place, out vec3 form)
{
  vec3 normal = place.normal;
  vec4 ranges = SHADOW_SET(place.first + 8);
  float above = place.perspective ? -dot(normal, place.position + vec3(0.0, 0.0, place.behind))
    : -normal.z;
  if (dot(normal, normal) < 0.5)
  {
    normal = vec3(0.0, 0.0, -1.0);
    above = place.perspective ? place.position.z + place.behind : 1.0;
  }
  float raised = above - (place.perspective ? place.rounding : 0.0);
  float least = place.perspective ? 1e-6 * (place.position.z + place.behind) : 1e-6;
  float scale = 1.0 / max(raised, least);
  form = place.perspective ? -normal * scale
    : vec3(-normal.xy * scale * ranges.y, (ranges.x - place.position.z +
      (dot(normal.xy, place.position.xy) + place.rounding) * scale) * ranges.y);
  return raised > least;
}
