// SPDX-License-Identifier: BSD-3-Clause
// The views of depth maps: see vtkShadowMaps.
//
// A view is SHADOW_VIEW_VECTORS vectors: the rows of the matrix from VC to the map ([0,1] in x, y and
// z after division: LC), the extent in VC at w = 1 of a texel along the map's x and y, times the depth
// scale (see vtkLightView), and the weight of the view's sample. The last three have the place that
// the view looks from in their fourth components. Five more follow for look-ups around a point: see
// vtkShadowMapKernelFS.glsl.
//
// SHADOW_FEW_VIEWS is defined to their number where they are few: what loops over them unrolls where the
// light is a constant. A light's views are those from SHADOW_FIRST_VIEW to before SHADOW_END_OF_VIEWS.

uniform sampler2DArrayShadow shadowMaps;
#ifdef SHADOW_FEW_VIEWS
uniform vec4 shadowViews[SHADOW_VIEW_VECTORS * SHADOW_FEW_VIEWS];
const int shadowFirstLayer = 0;
#define SHADOW_VIEW(view, vector) shadowViews[SHADOW_VIEW_VECTORS * (view) + (vector)]
#else
uniform samplerBuffer shadowViews;
uniform int shadowFirstView[SHADOW_LIGHTS];
uniform int shadowViewCount[SHADOW_LIGHTS];
uniform int shadowFirstLayer; // the view that layer 0 holds
#define SHADOW_FIRST_VIEW(light) shadowFirstView[light]
#define SHADOW_END_OF_VIEWS(light) (shadowFirstView[light] + shadowViewCount[light])
#define SHADOW_VIEW(view, vector) texelFetch(shadowViews, SHADOW_VIEW_VECTORS * (view) + (vector))
#endif

// Where the map has the receiver, nearer to the light by as much as takes it above its plane by what its
// position may be off: only its depth changes. Behind the light, w is negative: the quotient of a tiny
// one lies far outside of the map. Maps have a clear border, so outside there is light. `height` is how
// far along the normal the light is.
vec3 shadowProjectReceiver(int view, vec3 positionVC, vec3 normalVC, out float height)
{
  vec4 receiverVC = vec4(positionVC, 1.0);
  vec4 depthRow = SHADOW_VIEW(view, 2);
  vec3 placeVC = vec3(SHADOW_VIEW(view, 4).w, SHADOW_VIEW(view, 5).w, SHADOW_VIEW(view, 6).w);
  float isPoint = SHADOW_VIEW(view, 3).xyz == vec3(0.0) ? 0.0 : 1.0;
  vec3 towardsVC = placeVC - isPoint * positionVC;
  height = dot(normalVC, towardsVC);
  // Lines and points have no plane; a plane that the light grazes is not left without end.
  float step = dot(normalVC, normalVC) * shadowRounding(positionVC) /
    max(abs(height), dot(abs(towardsVC), vec3(1.0 / 2048.0)));
  float depth =
    dot(depthRow, receiverVC) + step * (dot(depthRow.xyz, placeVC) + isPoint * depthRow.w);
  float w = max(dot(SHADOW_VIEW(view, 3), receiverVC), 1e-30);
  return vec3(
    dot(SHADOW_VIEW(view, 0), receiverVC), dot(SHADOW_VIEW(view, 1), receiverVC), depth) / w;
}

// Automatic depth bias: a plane's own samples in the texels that a look-up reads are nearer to the light
// than the receiver by what the plane rises up to them, and by so much less is the depth to compare
// with. How far up that is along x and y, in texels: to the next of the four nearest for a bilinear
// look-up, to the middle of the one texel else. Rise is the plane's depth a texel; only its sign counts.
// `placeLC` is moved clear of where others would be read, or rounding might take them.
vec2 shadowUphill(vec2 rise, inout vec2 placeLC)
{
#ifdef SHADOW_BILINEAR
  const float middle = 0.5;
#else
  const float middle = 0.0;
#endif
  vec2 texel = placeLC * SHADOW_MAP_SIDE - middle;
  vec2 first = floor(texel);
  vec2 beside = clamp(texel - first, vec2(1.0 / 128.0), vec2(127.0 / 128.0));
  placeLC = (first + beside + middle) / SHADOW_MAP_SIDE;
#ifdef SHADOW_BILINEAR
  return mix(1.0 - beside, beside, vec2(greaterThan(rise, vec2(0.0))));
#else
  return abs(beside - 0.5);
#endif
}

// By how much less. A hair of a texel more is for folds of the surface, whose other side rises more.
float shadowBias(vec2 rise, vec2 uphill)
{
  return dot(abs(rise), uphill + 1.0 / 32.0);
}

// Where one look-up finds the receiver in the map, and the depth that it compares with; and how far along
// the normal the light is.
vec3 shadowPlaceReceiver(int view, vec3 positionVC, vec3 normalVC, out float height)
{
  vec3 receiverLC = shadowProjectReceiver(view, positionVC, normalVC, height);
  vec2 rise =
    vec2(dot(normalVC, SHADOW_VIEW(view, 4).xyz), dot(normalVC, SHADOW_VIEW(view, 5).xyz)) /
    (height < 0.0 ? min(height, -1e-30) : max(height, 1e-30));
  vec2 uphill = shadowUphill(rise, receiverLC.xy);
  // Behind the far plane, all casters are in front.
  receiverLC.z = min(receiverLC.z - shadowBias(rise, uphill), 1.0);
  return receiverLC;
}
