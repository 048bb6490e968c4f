// SPDX-License-Identifier: BSD-3-Clause
// Where one look-up finds a receiver in a map, and how much nearer to the light than it is.

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
