// SPDX-License-Identifier: BSD-3-Clause
// The virtual map of a light, which is one view of it or up to six: vtkLightViewFS.glsl and
// vtkLightSightFS.glsl. LC is the map, [0,1] in x, y and depth; a texel is the whole map. Of a view's
// free values, layer of the coarse map, and variance of the light's shape against that of its bounding
// square.

const int shadowMostViews = SHADOW_MOST_VIEWS;
uniform vec4 shadowViews[SHADOW_VIEW_VECTORS * shadowMostViews];
uniform int shadowViewCount;
#define SHADOW_VIEW(view, vector) shadowViews[SHADOW_VIEW_VECTORS * (view) + (vector)]

// On which side of the light's plane the map's places lie: x at the receiver's, and how that changes over the
// map; negative beyond the plane. What lies there is on no way from the receiver to any point of the light,
// though a light that is near a blocker, or large, has a kernel that reaches over it.
vec3 shadowFindAhead(int light, int view, vec3 positionVC)
{
  vec4 form = SHADOW_VIEW(view, 9);
  vec3 placeVC = vec3(SHADOW_VIEW(view, 4).w, SHADOW_VIEW(view, 5).w, SHADOW_VIEW(view, 6).w);
  vec3 awayVC = positionVC - placeVC;
  vec3 u = shadowLightUVC[light].xyz;
  vec3 v = shadowLightVVC[light].xyz;
  // A sphere is its disk that faces the receiver; points, lines and directions have no plane.
  vec3 axisVC = form.y > 0.5
    ? awayVC / max(length(awayVC), 1e-30)
    : cross(u / max(length(u), 1e-30), v / max(length(v), 1e-30));
  vec4 row = SHADOW_VIEW(view, 3); // distance along the view's axis
  float side = dot(axisVC, awayVC);
  axisVC *= row.xyz == vec3(0.0) ? 0.0 : (side < 0.0 ? -1.0 : 1.0);
  return vec3(abs(side) / max(dot(row, vec4(positionVC, 1.0)), 1e-30),
    form.w * dot(axisVC, SHADOW_VIEW(view, 4).xyz), form.w * dot(axisVC, SHADOW_VIEW(view, 5).xyz));
}
