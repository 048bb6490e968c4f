// SPDX-License-Identifier: BSD-3-Clause
// Rays followed through a map: see vtkTracedShadowMapPass. In LC the ray from a receiver to a point of the
// light is a straight line, along which the depth falls linearly: how far it has run is told in depth.
//
// A texel shows a piece of a plane, and a body behind it down to the slab's end. A ray is hidden where it
// crosses the plane or is within the body. Beneath the body it goes on. Where it comes out from behind, and
// what shows there lies in front of where it went behind, that surface went on there: the ray has crossed it.

uniform sampler2DArray shadowSlabs;
uniform samplerBuffer shadowPattern; // xy: points of the disk, zw: of the square; a block of them a pixel
#ifdef SHADOW_EMISSION
uniform samplerBuffer shadowEmission; // of each light at these points
#endif

const int shadowMostSteps = 512;

// Which block of points a pixel of a tile has: of four that lie together, four that follow each other.
int shadowBlock(ivec2 pixel)
{
  ivec2 low = pixel & 1;
  ivec2 high = pixel >> 1 & 1;
  return (low.x ^ low.y) + 2 * low.y + 4 * (high.x ^ high.y) + 8 * high.y;
}

struct shadowRay
{
  float layer;
  vec2 place;   // where it starts, in texels
  float depth;
  vec2 along;   // texels for one unit of depth
  float first;  // before it has run so far, it is behind all that the map shows
  float last;   // so far it runs
  vec2 slope;   // of the receiver's plane, depth over a texel
  float slack;  // so far above that plane what it shows may still be the receiver
  float wobble; // and so much more a texel away
};

// For folds of the surface: rays start a quarter of a texel off on the average, beyond a fold beneath its other
// side.
float shadowSlack(shadowKernel kernel)
{
  return dot(abs(kernel.rise), vec2(1.0 / 4.0));
}

// The least depth of a box of the map, and the greatest of bodies' ends, negative where there also is nothing.
vec2 shadowSlabRange(float layer, vec2 low, vec2 high)
{
  vec2 end = vec2(SHADOW_MAP_SIDE - 1.0);
  vec2 first = clamp(floor(low * SHADOW_MAP_SIDE - 0.01), vec2(0.0), end);
  vec2 final = clamp(floor(high * SHADOW_MAP_SIDE + 0.01), vec2(0.0), end);
  vec2 extent = final - first;
  int level = max(0, int(ceil(log2(max(max(extent.x, extent.y), 1.0)))) - 1);
  ivec2 from = ivec2(first) >> (level + 1);
  ivec2 to = ivec2(final) >> (level + 1);
  int index = int(layer);
  vec2 a = texelFetch(shadowPyramid, ivec3(from, index), level).rg;
  vec2 b = texelFetch(shadowPyramid, ivec3(to.x, from.y, index), level).rg;
  vec2 c = texelFetch(shadowPyramid, ivec3(from.x, to.y, index), level).rg;
  vec2 d = texelFetch(shadowPyramid, ivec3(to, index), level).rg;
  shadowCost += 4.0;
  float gaps = min(min(a.y, b.y), min(c.y, d.y)) < 0.0 ? -1.0 : 1.0;
  return vec2(min(min(a.x, b.x), min(c.x, d.x)),
    gaps * max(max(abs(a.y), abs(b.y)), max(abs(c.y), abs(d.y))));
}

// Whether what a texel shows is above the receiver's plane: what is not is the receiver itself.
bool shadowBlocks(shadowRay ray, vec4 slab, vec2 middle)
{
  vec2 apart = middle - ray.place;
  return slab.x < ray.depth + dot(ray.slope, apart) - ray.slack -
    ray.wobble * (abs(apart.x) + abs(apart.y));
}

bool shadowIsHidden(shadowRay ray)
{
  vec2 inverse = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(ray.along, vec2(0.0))) /
    max(abs(ray.along), vec2(1e-20));
  vec2 ahead = vec2(greaterThan(ray.along, vec2(0.0)));
  vec2 nudge = sign(ray.along) / 256.0; // past the border that it stands on
  // Outside of the map is light.
  vec2 enter = ((1.0 - ahead) * SHADOW_MAP_SIDE - ray.place) * inverse;
  vec2 leaves = (ahead * SHADOW_MAP_SIDE - ray.place) * inverse;
  float last = min(ray.last, min(leaves.x, leaves.y));
  float run = max(ray.first, max(enter.x, enter.y));
  // The depth where it went behind what shows; 0 in front of it.
  vec2 middle = floor(ray.place) + 0.5;
  bool inside = max(enter.x, enter.y) <= 0.0 && last > 0.0;
  vec4 slab = inside ? texelFetch(shadowSlabs, ivec3(middle, ray.layer), 0) : vec4(1e30);
  float behind = ray.depth > slab.x + dot(slab.zw, ray.place - middle) && shadowBlocks(ray, slab, middle)
    ? ray.depth : 0.0;
  int level = 0; // cells of so many texels, as a power of two
  bool hidden = false;
  for (int i = 0; i < shadowMostSteps && run < last && !hidden; ++i)
  {
    float size = float(1 << level);
    vec2 place = ray.place + run * ray.along;
    vec2 cell = floor((place + nudge) / size);
    vec2 border = ((cell + ahead) * size - ray.place) * inverse;
    float next = clamp(min(border.x, border.y), run, last);
    float near = ray.depth - next;
    float far = ray.depth - run;
    bool leave = true;
    if (level > 0)
    {
      vec2 range = texelFetch(shadowPyramid, ivec3(cell, ray.layer), level - 1).rg;
      bool over = far <= range.x && behind <= range.x;
      bool under = near > abs(range.y);
      behind = over ? 0.0 : (under && behind == 0.0 && range.y > 0.0 ? far : behind);
      leave = over || under;
    }
    else
    {
      slab = texelFetch(shadowSlabs, ivec3(cell, ray.layer), 0);
      middle = cell + 0.5;
      bool blocks = shadowBlocks(ray, slab, middle);
      bool before = far > slab.x + dot(slab.zw, place - middle);
      bool after = near > slab.x + dot(slab.zw, ray.place + next * ray.along - middle);
      // What shows here, where the ray went behind.
      float there =
        slab.x + dot(slab.zw, ray.place + (ray.depth - behind) * ray.along - middle);
      bool goesOn = max(slab.x, there) < behind;
      hidden = blocks && (before != after || (before ? near <= slab.y : goesOn));
      behind = blocks && after ? (behind > 0.0 ? behind : far) : 0.0;
    }
    run = leave ? next : run;
    level = leave ? min(level + 1, SHADOW_MAP_LEVELS) : level - 1;
    shadowCost += 1.0;
  }
  return hidden;
}
