// SPDX-License-Identifier: BSD-3-Clause
// What the filters of one map a light share: the light as a receiver sees it over the map, look-ups
// there, and a conservative test of what is fully lit or in umbra.
//
// A map's depth is linear in the reciprocal distance, so that straight lines are straight in LC. The
// point (s, t) of the light, in its half axes, is hidden by a blocker whose depth is less than the
// receiver's by `delta` where the map shows the blocker at
//
//   receiver.xy + delta * (s * axisU + t * axisV) / (1 - s * tiltU - t * tiltV)
//
// with the axes as they are seen along the receiver's direction, and the tilt how much nearer to the
// receiver they end, as a share of its distance. This is exact for every light and view; it is equation
// 3.3 of Zapotocky, Soft shadows on GPU, 2007, with the light's width a vector, and takes the place of
// his equations 4.1 to 4.3. A sphere is its disk that faces the receiver.
//
// A view's further vectors: 7: axisU, axisV, straight along the view; 8: depth times distance, lengths
// of the window's sides at w = 1; 9: face of a cube, sphere (each 0 or 1), separation that filters of
// constant width assume, window over texels and depth scale of 4 and 5; 10: lengths of the half axes along the
// view's axis, radius of a sphere; 11: low x, low y, high x, high y that look-ups have to keep within.

uniform sampler2DArray shadowDepths; // the maps, as they are

// How far a normal that was packed or derived may be off, in radians.
const float shadowNormalRounding = 1.0 / 2048.0;

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
  vec4 axesLC = SHADOW_VIEW(view, 7);
  vec4 measures = SHADOW_VIEW(view, 8);
  vec4 form = SHADOW_VIEW(view, 9);
  vec3 windowX = SHADOW_VIEW(view, 4).xyz * form.w;
  vec3 windowY = SHADOW_VIEW(view, 5).xyz * form.w;
  vec3 placeVC = vec3(SHADOW_VIEW(view, 4).w, SHADOW_VIEW(view, 5).w, SHADOW_VIEW(view, 6).w);
  float centre;
  kernel.receiverLC = shadowProjectReceiver(view, positionVC, normalVC, centre);
  float w = dot(SHADOW_VIEW(view, 3), vec4(positionVC, 1.0));
  kernel.layer = float(view - shadowFirstLayer);
  kernel.w = max(w, 1e-30);
  kernel.positional = SHADOW_VIEW(view, 3).xyz != vec3(0.0);
  kernel.square = shadowLightVVC[light].w > 0.0;
  kernel.bounds = SHADOW_VIEW(view, 11);
  kernel.scale = vec2(measures.x, form.z);

  // Where it is, not where it is moved to: faces of a cube must not disagree.
  vec3 awayVC = kernel.positional ? positionVC - placeVC : -placeVC;
  vec2 tangent = vec2(dot(windowX, awayVC), dot(windowY, awayVC)) /
    (measures.yz * max(w, 1e-30));
  vec4 along = SHADOW_VIEW(view, 10);
  float ray = sqrt(1.0 + dot(tangent, tangent));
  vec2 alongUV = form.y > 0.5 ? -along.z * tangent / ray : along.xy;
  float stretch = form.y / (1.0 + ray);
  vec2 scaleLC = 1.0 / (measures.yz * measures.x);
  vec2 seenLC = tangent * scaleLC * (1.0 - form.y);
  kernel.axisULC = axesLC.xy + stretch * tangent.x * tangent * axesLC.xw - alongUV.x * seenLC;
  kernel.axisVLC = axesLC.zw + stretch * tangent.y * tangent * axesLC.xw - alongUV.y * seenLC;
  kernel.tilt = kernel.positional ? alongUV / kernel.w : vec2(0.0);

  // The receiver's plane over the map. Its slope ends where the light's centre grazes it: the light's
  // points above the horizon then decide.
  vec2 planeLC = measures.x * vec2(dot(normalVC, windowX), dot(normalVC, windowY));
  float height = max(centre, 1e-4 * kernel.w);
  float self = shadowSelf ? 1.0 : 0.0;
  kernel.slopeLC = self * planeLC / height;
  kernel.rise =
    planeLC / (SHADOW_MAP_SIDE * (centre < 0.0 ? min(centre, -1e-30) : max(centre, 1e-30)));
  vec2 placeLC = kernel.receiverLC.xy;
  kernel.uphill = shadowUphill(kernel.rise, placeLC);
  kernel.wobble = self * shadowNormalRounding * measures.x * max(measures.y, measures.z) / height *
    dot(normalVC, normalVC); // lines and points have none
  // The axes are seen along the receiver's direction: the tilt takes that back.
  kernel.horizon = shadowSelf ? vec3(centre, dot(planeLC, kernel.axisULC) - kernel.tilt.x * centre,
    dot(planeLC, kernel.axisVLC) - kernel.tilt.y * centre) : vec3(1.0, 0.0, 0.0);
  kernel.horizonCuts = kernel.horizon.x < abs(kernel.horizon.y) + abs(kernel.horizon.z);

  bool inside = form.x < 0.5 || max(abs(tangent.x), abs(tangent.y)) <= 1.000001;
  return w > 0.0 && kernel.receiverLC.z > 0.0 && inside;
}

// Half sides of the box over the map that the light fills past a blocker at `delta`.
vec2 shadowExtent(shadowKernel kernel, float delta)
{
  vec2 u = abs(kernel.axisULC);
  vec2 v = abs(kernel.axisVLC);
  float nearest = max(1.0 - abs(kernel.tilt.x) - abs(kernel.tilt.y), 0.25);
  return delta / nearest * (kernel.square ? u + v : sqrt(u * u + v * v));
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
