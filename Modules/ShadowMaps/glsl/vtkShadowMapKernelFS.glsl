// SPDX-License-Identifier: BSD-3-Clause
// What the filters of one map a light share: the light as a receiver sees it over the map
// (vtkLightSightFS.glsl), look-ups there, and a conservative test of what is fully lit or in umbra. Of a
// view's free value, separation that filters of constant width assume.

uniform sampler2DArray shadowDepths; // the maps, as they are

struct shadowKernel
{
  vec3 receiverLC; // without its bias
  float layer;
  float w;        // distance along the view's axis; 1 for a directional light
  vec2 axisULC;   // over the map, for one unit of depth
  vec2 axisVLC;
  vec2 tilt;
  vec2 slopeLC;   // of the receiver's plane: depth over the map
  vec2 rise;      // the same over a texel; and where it is read: see shadowUphill
  vec2 uphill;
  float wobble;   // as slopeLC, of what its normal may be off
  vec3 horizon;   // height of the light's point (s, t) above the receiver's plane: x + s y + t z
  bool horizonCuts;
  bool square;    // (s, t) fill a square, else a disk
  vec4 bounds;    // of look-ups, where the map ends and casters go on
  vec2 scale;     // depth times distance; separation that filters of constant width assume
  bool positional;
};

// Told to debug views, in world units.
float shadowBlocker = 0.0;  // distance from light to blocker, along the view's axis
float shadowPenumbra = 0.0; // the penumbra's full width at the receiver, the wider of both axes

// False where the map has nothing in front of the receiver.
bool shadowFindKernel(int light, int view, vec3 positionVC, vec3 normalVC, out shadowKernel kernel)
{
  shadowSight sight;
  bool sees = shadowFindSight(light, view, positionVC, normalVC, sight);
  kernel.receiverLC = sight.receiverLC;
  kernel.layer = float(view - shadowFirstLayer);
  kernel.w = sight.w;
  kernel.axisULC = sight.axisULC;
  kernel.axisVLC = sight.axisVLC;
  kernel.tilt = sight.tilt;
  kernel.slopeLC = sight.slopeLC;
  kernel.wobble = sight.wobble;
  kernel.positional = sight.positional;
  kernel.square = sight.square;
  kernel.bounds = SHADOW_VIEW(view, 11);
  kernel.scale = vec2(SHADOW_VIEW(view, 8).x, SHADOW_VIEW(view, 9).z);
  float centre = sight.centre;
  kernel.rise =
    sight.planeLC / (SHADOW_MAP_SIDE * (centre < 0.0 ? min(centre, -1e-30) : max(centre, 1e-30)));
  vec2 placeLC = kernel.receiverLC.xy;
  kernel.uphill = shadowUphill(kernel.rise, placeLC);
  kernel.horizon = shadowFindHorizon(sight);
  kernel.horizonCuts = kernel.horizon.x < abs(kernel.horizon.y) + abs(kernel.horizon.z);
  return sees;
}

vec2 shadowExtent(shadowKernel kernel, float delta)
{
  return shadowExtent(kernel.axisULC, kernel.axisVLC, kernel.tilt, kernel.square, delta);
}

// `delta` for look-ups. Where a map is cut, it is drawn in to what the map shows: so there is never a
// border of light.
float shadowReach(shadowKernel kernel, float delta)
{
#ifdef SHADOW_CUT_VIEWS
  vec2 extent = max(shadowExtent(kernel, delta), vec2(1e-30));
  vec2 room = max(min(kernel.receiverLC.xy - kernel.bounds.xy,
    kernel.bounds.zw - kernel.receiverLC.xy), 0.0) / extent;
  return delta * min(1.0, min(room.x, room.y));
#else
  return delta;
#endif
}

// The depth that blockers are in front of, for look-ups within an extent: the receiver's, less its bias
// and what its normal may be off there. Look-ups that leave the texels around the receiver uphill may
// read one that is as far from them as can be.
float shadowReference(shadowKernel kernel, vec2 extent)
{
#ifdef SHADOW_BILINEAR
  vec2 border = kernel.uphill;
  const float most = 1.0;
#else
  vec2 border = 0.5 - kernel.uphill;
  const float most = 0.5;
#endif
  vec2 within = vec2(greaterThan(border, extent * SHADOW_MAP_SIDE + 1.0 / 128.0));
  return kernel.receiverLC.z - shadowBias(kernel.rise, mix(vec2(most), kernel.uphill, within)) -
    kernel.wobble * (extent.x + extent.y);
}

// What a look-up at an offset compares with. Blockers lie in front of the receiver, and above its
// plane: what is nearer on the plane is the receiver itself. Behind the far plane, all casters are in
// front.
float shadowReferenceAt(shadowKernel kernel, float reference, vec2 offsetLC)
{
  return min(reference + min(dot(kernel.slopeLC, offsetLC), 0.0), 1.0);
}

vec2 shadowOffset(shadowKernel kernel, float reach, vec2 st)
{
  return reach / max(1.0 - dot(st, kernel.tilt), 0.25) *
    (st.x * kernel.axisULC + st.y * kernel.axisVLC);
}

// Whether the light's point (s, t) is seen past the map: 0 to 1.
float shadowLookUp(shadowKernel kernel, float reference, float reach, vec2 st)
{
  vec2 offsetLC = shadowOffset(kernel, reach, st);
  float lit = texture(shadowMaps, vec4(kernel.receiverLC.xy + offsetLC, kernel.layer,
    shadowReferenceAt(kernel, reference, offsetLC)));
#ifdef SHADOW_HORIZON_LATER
  return lit;
#else
  return kernel.horizon.x + st.x * kernel.horizon.y + st.y * kernel.horizon.z < 0.0 ? 0.0 : lit;
#endif
}

// How many of at most so many look-ups within an extent are worth it: a few a texel, in powers of two.
// Within a texel one is as good as all; but not where the horizon, an edge of the light's own, cuts it.
int shadowCount(shadowKernel kernel, vec2 extent, int most)
{
  vec2 texels = max(2.0 * extent * float(shadowPyramidResolution), 0.5);
  float wanted = 4.0 * texels.x * texels.y;
  int count = wanted <= 1.0 ? 1 : min(most, 1 << int(min(ceil(log2(wanted)), 20.0)));
  return kernel.horizonCuts ? most : count;
}

// 1 where all look-ups within an extent find light, 0 where none does, else -1.
float shadowClassify(shadowKernel kernel, vec2 rangeLC, float reference, vec2 extent)
{
  float lowest = min(reference - dot(abs(kernel.slopeLC), extent), 1.0);
  // Light must hold for the narrower extents too, whose reference is the higher.
  float highest = kernel.receiverLC.z - shadowBias(kernel.rise, kernel.uphill);
  bool lit = rangeLC.x >= min(highest, 1.0) && !kernel.horizonCuts;
  return lit ? 1.0 : (rangeLC.y < lowest ? 0.0 : -1.0);
}

vec2 shadowRange(shadowKernel kernel, vec2 extent)
{
  shadowCost += 4.0;
  return shadowDepthRange(
    kernel.layer, kernel.receiverLC.xy - extent, kernel.receiverLC.xy + extent);
}

// Distance from the light along the view's axis, in world units, of a depth that is less than the
// receiver's by delta.
float shadowDistance(shadowKernel kernel, float delta)
{
  return kernel.positional ? 1.0 / (1.0 / kernel.w + delta / kernel.scale.x)
    : (kernel.receiverLC.z - delta) / kernel.scale.x;
}

// Full width of the penumbra of a blocker at delta, at the receiver, in world units.
float shadowWidth(int view, shadowKernel kernel, float delta)
{
  vec2 size = SHADOW_VIEW(view, 8).yz * kernel.w;
  return 2.0 * delta * max(length(size * kernel.axisULC), length(size * kernel.axisVLC));
}
