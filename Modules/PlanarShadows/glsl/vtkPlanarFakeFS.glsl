// SPDX-License-Identifier: BSD-3-Clause
// planar-fake: the mask of the light's centre, filtered as widely as the light's size and the height
// of the casters spread it. Vectors of a record, in units of the layer (place: [0,1] in x and y):
//
//   1, 2  rows from VC to the place
//   3     the light's half axes seen through the receiver onto the plane, at place 0
//   4     what they grow by with the place; the largest spread; 0 rectangle, 1 disk, 2 sphere
//   5     of a sphere: the foot of its centre, its height, its radius
//   6     the layer's size along the plane, in world units

// The light's half axes at a place: those of its parallel projection onto the plane along the ray.
void shadowGetAxes(int record, vec2 place, out vec2 u, out vec2 v)
{
  vec4 axes = SHADOW_RECORD(record + 3);
  vec4 growth = SHADOW_RECORD(record + 4);
  u = axes.xy + growth.x * place;
  v = axes.zw + growth.y * place;
  if (growth.w > 1.5)
  {
    // The disk through the sphere's centre that faces the receiver.
    vec4 sphere = SHADOW_RECORD(record + 5);
    vec2 size = SHADOW_RECORD(record + 6).xy;
    vec2 along = (sphere.xy - place) * size;
    float aside = length(along);
    along = aside > 0.0 ? along / aside : vec2(1.0, 0.0);
    u = along * (sphere.w * length(vec2(aside, sphere.z)) / sphere.z) / size;
    v = vec2(-along.y, along.x) * sphere.w / size;
  }
}

// The level whose texels are as wide as taps lie apart; along the axes it is not the same.
float shadowGetLevel(vec2 u, vec2 v)
{
  vec2 side = vec2(textureSize(shadowPlanarMaps, 0).xy);
  float a = length(u * side);
  float b = length(v * side);
  float apart = max(sqrt(a * b), 0.5 * max(a, b)) * (2.0 / float(SHADOW_KERNEL));
  return log2(max(apart, 1.0));
}

// The coverage of the place that is filtered over the light's shape.
float shadowFilter(float layer, vec2 place, vec2 u, vec2 v, float most, bool disk)
{
  shadowCost += float(2 * SHADOW_KERNEL * SHADOW_KERNEL);
  const float cell = 2.0 / float(SHADOW_KERNEL);

  // The mean spread of what can hide the light: a blocker that is seen this far off centre must
  // spread at least that far. It is looked for no further than the layer is wide.
  float reach = min(most, 0.5 / max(max(length(u), length(v)), 1e-30));
  float share = reach / most;
  float level = shadowGetLevel(reach * u, reach * v);
  vec2 blockers = vec2(0.0);
  for (int y = 0; y < SHADOW_KERNEL; ++y)
  {
    for (int x = 0; x < SHADOW_KERNEL; ++x)
    {
      vec2 tap = (vec2(x, y) + 0.5) * cell - 1.0;
      vec2 texel = textureLod(
        shadowPlanarMaps, vec3(place + reach * (tap.x * u + tap.y * v), layer), level).rg;
      float spread = 1.0 - texel.g / max(texel.r, 1e-6);
      float off = disk ? length(tap) : max(abs(tap.x), abs(tap.y));
      float counts = texel.r > 1e-6 && share * off <= spread + share * 0.5 * cell ? texel.r : 0.0;
      blockers += counts * vec2(1.0, spread);
    }
  }
  float spread = most * blockers.y / max(blockers.x, 1e-6);

  u *= spread;
  v *= spread;
  level = shadowGetLevel(u, v);
  vec2 sum = vec2(0.0);
  for (int y = 0; y < SHADOW_KERNEL; ++y)
  {
    for (int x = 0; x < SHADOW_KERNEL; ++x)
    {
      vec2 tap = (vec2(x, y) + 0.5) * cell - 1.0;
      // A disk's rim crosses the taps' cells.
      float weight = disk ? clamp((1.0 - length(tap)) / cell + 0.5, 0.0, 1.0) : 1.0;
      float covered =
        textureLod(shadowPlanarMaps, vec3(place + tap.x * u + tap.y * v, layer), level).r;
      sum += weight * vec2(covered, 1.0);
    }
  }
  float coverage = blockers.x > 0.0 ? sum.x / sum.y : 0.0;
  return 1.0 - coverage > 2e-5 ? coverage : 1.0;
}

SHADOW_VISIBILITY shadowLookUp(int record, float layer, vec3 positionVC)
{
  vec2 place = vec2(dot(SHADOW_RECORD(record + 1), vec4(positionVC, 1.0)),
    dot(SHADOW_RECORD(record + 2), vec4(positionVC, 1.0)));
  shadowCost += 1.0;
  float coverage = 0.0;
  // Penumbrae end within the layer. A branch, so that loops within end at once: software rasterizers
  // too.
  if (all(lessThan(abs(place - 0.5), vec2(0.5))))
  {
#ifdef SHADOW_HARD
    coverage = textureLod(shadowPlanarMaps, vec3(place, layer), 0.0).r;
#else
    vec2 u, v;
    shadowGetAxes(record, place, u, v);
    vec4 form = SHADOW_RECORD(record + 4);
    if (form.z > 0.0)
    {
      coverage = shadowFilter(layer, place, u, v, form.z, form.w > 0.5);
    }
    else // a light without size beside others
    {
      coverage = textureLod(shadowPlanarMaps, vec3(place, layer), 0.0).r;
    }
#endif
  }
  return SHADOW_VISIBILITY(1.0 - coverage);
}
