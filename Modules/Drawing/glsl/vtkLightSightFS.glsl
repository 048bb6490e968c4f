// SPDX-License-Identifier: BSD-3-Clause
// The light as a receiver sees it over a map. A map's depth is linear in the reciprocal distance, so that
// straight lines are straight in LC. The point (s, t) of the light, in its half axes, is hidden by a
// blocker whose depth is less than the receiver's by `delta` where the map shows the blocker at
//
//   receiver.xy + delta * (s * axisU + t * axisV) / (1 - s * tiltU - t * tiltV)
//
// with the axes as they are seen along the receiver's direction, and the tilt how much nearer to the
// receiver they end, as a share of its distance. This is exact for every light and view; no texel and no
// unit is in it. It is equation 3.3 of Zapotocky, Soft shadows on GPU, 2007, with the light's width a
// vector, and takes the place of his equations 4.1 to 4.3. A sphere is its disk that faces the receiver.
//
// A view's further vectors: 7: axisU, axisV, straight along the view; 8: depth times distance, lengths
// of the window's sides at w = 1; 9: face of a cube, sphere (each 0 or 1), a value of whoever reads it,
// window over texels and depth scale of 4 and 5; 10: lengths of the half axes along the view's axis,
// radius of a sphere; 11: low x, low y, high x, high y where the map is cut and casters go on.

// How far a normal that was packed or derived may be off, in radians.
const float shadowNormalRounding = 1.0 / 2048.0;

struct shadowSight
{
  vec3 receiverLC; // without any bias
  float w;         // distance along the view's axis; 1 for a directional light
  float centre;    // how far along the normal the light's centre is
  vec2 axisULC;    // over the map, for one unit of depth
  vec2 axisVLC;
  vec2 tilt;
  vec2 planeLC;    // the receiver's plane: its depth over the map, times `centre`
  vec2 slopeLC;    // the same, at most so steep as where the light grazes it
  float wobble;    // as slopeLC, of what its normal may be off
  float steeper;   // so many times as steep the plane may be, by what that takes of a light's height
  bool square;     // (s, t) fill a square, else a disk
  bool positional;
};

// False where the map has nothing in front of the receiver.
bool shadowFindSight(int light, int view, vec3 positionVC, vec3 normalVC, out shadowSight sight)
{
  vec4 axesLC = SHADOW_VIEW(view, 7);
  vec4 measures = SHADOW_VIEW(view, 8);
  vec4 form = SHADOW_VIEW(view, 9);
  vec3 windowX = SHADOW_VIEW(view, 4).xyz * form.w;
  vec3 windowY = SHADOW_VIEW(view, 5).xyz * form.w;
  vec3 placeVC = vec3(SHADOW_VIEW(view, 4).w, SHADOW_VIEW(view, 5).w, SHADOW_VIEW(view, 6).w);
  float centre;
  sight.receiverLC = shadowProjectReceiver(view, positionVC, normalVC, centre);
  sight.centre = centre;
  float w = dot(SHADOW_VIEW(view, 3), vec4(positionVC, 1.0));
  sight.w = max(w, 1e-30);
  sight.positional = SHADOW_VIEW(view, 3).xyz != vec3(0.0);
  sight.square = shadowLightVVC[light].w > 0.0;

  // Where it is, not where it is moved to: faces of a cube must not disagree.
  vec3 awayVC = sight.positional ? positionVC - placeVC : -placeVC;
  vec2 tangent = vec2(dot(windowX, awayVC), dot(windowY, awayVC)) /
    (measures.yz * max(w, 1e-30));
  vec4 along = SHADOW_VIEW(view, 10);
  float ray = sqrt(1.0 + dot(tangent, tangent));
  vec2 alongUV = form.y > 0.5 ? -along.z * tangent / ray : along.xy;
  float stretch = form.y / (1.0 + ray);
  vec2 scaleLC = 1.0 / (measures.yz * measures.x);
  vec2 seenLC = tangent * scaleLC * (1.0 - form.y);
  sight.axisULC = axesLC.xy + stretch * tangent.x * tangent * axesLC.xw - alongUV.x * seenLC;
  sight.axisVLC = axesLC.zw + stretch * tangent.y * tangent * axesLC.xw - alongUV.y * seenLC;
  sight.tilt = sight.positional ? alongUV / sight.w : vec2(0.0);

  // The receiver's plane over the map. Its slope ends where the light's centre grazes it: the light's
  // points above the horizon then decide.
  sight.planeLC = measures.x * vec2(dot(normalVC, windowX), dot(normalVC, windowY));
  float height = max(centre, 1e-4 * sight.w);
  float self = shadowSelf ? 1.0 : 0.0;
  sight.slopeLC = self * sight.planeLC / height;
  sight.wobble = self * shadowNormalRounding * measures.x * max(measures.y, measures.z) / height *
    dot(normalVC, normalVC); // lines and points have none
  // Packing is at its coarsest 3.25 times as far off, where the normal is a diagonal.
  float off = 3.25 * shadowNormalRounding * length(awayVC);
  sight.steeper = 1.0 / max(1.0 - off / height, 1.0 / 64.0);
  bool inside = form.x < 0.5 || max(abs(tangent.x), abs(tangent.y)) <= 1.000001;
  return w > 0.0 && sight.receiverLC.z > 0.0 && inside;
}

// The height of the light's point (s, t) above the receiver's plane: x + s y + t z. The axes are seen along
// the receiver's direction: the tilt takes that back.
vec3 shadowFindHorizon(shadowSight sight)
{
  return shadowSelf ? vec3(sight.centre,
    dot(sight.planeLC, sight.axisULC) - sight.tilt.x * sight.centre,
    dot(sight.planeLC, sight.axisVLC) - sight.tilt.y * sight.centre) : vec3(1.0, 0.0, 0.0);
}

// Half sides of the box over the map that the light fills past a blocker at `delta`.
vec2 shadowExtent(vec2 axisULC, vec2 axisVLC, vec2 tilt, bool square, float delta)
{
  vec2 u = abs(axisULC);
  vec2 v = abs(axisVLC);
  float nearest = max(1.0 - abs(tilt.x) - abs(tilt.y), 0.25);
  return delta / nearest * (square ? u + v : sqrt(u * u + v * v));
}

vec2 shadowExtent(shadowSight sight, float delta)
{
  return shadowExtent(sight.axisULC, sight.axisVLC, sight.tilt, sight.square, delta);
}
