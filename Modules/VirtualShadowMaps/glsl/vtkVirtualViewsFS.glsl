// SPDX-License-Identifier: BSD-3-Clause
// A receiver over the virtual map of a light, which is one view of it or up to six: what the
// kernels, the sums and the visibility need of it. LC is the map, [0,1] in x, y and depth.
//
// The point (s, t) of the light, in its half axes, is hidden by a blocker whose depth is less than
// the receiver's by `delta` where the map shows the blocker at
//
//   receiver.xy + delta * (s * axisU + t * axisV) / (1 - s * tiltU - t * tiltV)
//
// since depth is linear in the reciprocal distance (of a directional light, in the distance). No
// texel and no unit is in that.
//
// A view's vectors: 0 to 3: rows of the matrix from VC to LC, before division; 4, 5: axes of the
// view as unit vectors, w: x and y of the light's place; 6: depth times distance, lengths of the
// window's sides at distance 1, z of the place; 7: the light's half axes over the map for one unit
// of depth, straight along the view; 8: their lengths along the view's axis, layer of the coarse
// map, face of a cube; 9: radius of a sphere, variance of the light's shape against that of its
// bounding square; 10: low x, y, high x, y where the map is cut and casters go on.

#define SHADOW_VIEW_VECTORS 11
const int shadowMostViews = 6;
uniform vec4 shadowViews[SHADOW_VIEW_VECTORS * shadowMostViews];
uniform int shadowViewCount;
#define SHADOW_VIEW(view, vector) shadowViews[SHADOW_VIEW_VECTORS * (view) + (vector)]

// How far a normal that was packed or derived may be off, in radians.
const float shadowNormalRounding = 1.0 / 2048.0;

struct shadowPlace
{
  vec3 placeLC;  // nearer to the light by what the position may be off
  float w;       // distance along the view's axis; 1 for a directional light
  vec2 axisULC;  // half axes of the light over the map, for one unit of depth
  vec2 axisVLC;
  vec3 variance; // xx, xy, yy of the box that stands for it, for one unit of depth
  float nearest; // 1 less the most that a point of the light is nearer to the receiver, as a share
  float centre;  // how far the light's centre is above the receiver's plane
  vec2 planeLC;  // the plane's depth over the map, times that
  vec2 slopeLC;  // the plane's depth over the map
  float wobble;  // the same, of what its normal may be off
};

// False where the view has nothing in front of the receiver.
bool shadowFindPlace(int view, vec3 positionVC, vec3 normalVC, out shadowPlace place)
{
  vec4 receiverVC = vec4(positionVC, 1.0);
  vec4 measures = SHADOW_VIEW(view, 6);
  vec4 along = SHADOW_VIEW(view, 8);
  vec4 form = SHADOW_VIEW(view, 9);
  vec4 depthRow = SHADOW_VIEW(view, 2);
  vec3 placeVC = vec3(SHADOW_VIEW(view, 4).w, SHADOW_VIEW(view, 5).w, measures.w);
  vec3 xVC = SHADOW_VIEW(view, 4).xyz;
  vec3 yVC = SHADOW_VIEW(view, 5).xyz;
  float isPoint = SHADOW_VIEW(view, 3).xyz == vec3(0.0) ? 0.0 : 1.0;
  vec3 towardsVC = placeVC - isPoint * positionVC;
  place.centre = dot(normalVC, towardsVC);
  // Lines and points have no plane; a plane that the light grazes is not left without end.
  float step = dot(normalVC, normalVC) * shadowRounding(positionVC) /
    max(abs(place.centre), dot(abs(towardsVC), vec3(1.0 / 2048.0)));
  float depth =
    dot(depthRow, receiverVC) + step * (dot(depthRow.xyz, placeVC) + isPoint * depthRow.w);
  float w = dot(SHADOW_VIEW(view, 3), receiverVC);
  place.w = max(w, 1e-30);
  place.placeLC = vec3(dot(SHADOW_VIEW(view, 0), receiverVC), dot(SHADOW_VIEW(view, 1), receiverVC),
    depth) / place.w;

  vec2 tangent = isPoint * -vec2(dot(xVC, towardsVC), dot(yVC, towardsVC)) / place.w;
  vec2 scaleLC = 1.0 / (measures.yz * measures.x);
  if (form.x > 0.0)
  {
    // The sphere's disk that faces the receiver, whose axis is seen as a point.
    vec2 u = form.x * sqrt(1.0 + tangent * tangent) * scaleLC;
    float shear = form.x * form.x * tangent.x * tangent.y * scaleLC.x * scaleLC.y;
    place.axisULC = vec2(u.x, shear / u.x);
    place.axisVLC = vec2(0.0, sqrt(max(u.y * u.y - place.axisULC.y * place.axisULC.y, 0.0)));
    place.nearest = 1.0 - form.x * length(tangent) / (length(vec3(tangent, 1.0)) * place.w);
  }
  else
  {
    place.axisULC = SHADOW_VIEW(view, 7).xy - along.x * tangent * scaleLC;
    place.axisVLC = SHADOW_VIEW(view, 7).zw - along.y * tangent * scaleLC;
    place.nearest = 1.0 - isPoint * (abs(along.x) + abs(along.y)) / place.w;
  }
  place.nearest = max(place.nearest, 0.25);
  place.variance = form.y * vec3(
    place.axisULC.x * place.axisULC.x + place.axisVLC.x * place.axisVLC.x,
    place.axisULC.x * place.axisULC.y + place.axisVLC.x * place.axisVLC.y,
    place.axisULC.y * place.axisULC.y + place.axisVLC.y * place.axisVLC.y);

  // The receiver's plane over the map. Its slope ends where the light's centre grazes it.
  vec2 planeLC = measures.x * measures.yz * vec2(dot(normalVC, xVC), dot(normalVC, yVC));
  float height = max(place.centre, 1e-4 * place.w);
  float self = shadowSelf ? 1.0 : 0.0;
  place.planeLC = planeLC;
  place.slopeLC = self * planeLC / height;
  place.wobble = self * shadowNormalRounding * measures.x * max(measures.y, measures.z) / height *
    dot(normalVC, normalVC);
  bool inside = along.w < 0.5 || max(abs(tangent.x), abs(tangent.y)) <= 1.000001;
  return w > 0.0 && place.placeLC.z > 0.0 && inside;
}

// Half sides of the box over the map that the light fills past a blocker at `delta`.
vec2 shadowExtent(shadowPlace place, bool square, float delta)
{
  vec2 u = abs(place.axisULC);
  vec2 v = abs(place.axisVLC);
  return delta / place.nearest * (square ? u + v : sqrt(u * u + v * v));
}
