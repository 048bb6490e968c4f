// SPDX-License-Identifier: BSD-3-Clause
// Finds the tiles of a pixel. A kernel's code is 1 + view + 8 x + 256 y, of its level's halvings of
// the map along x and y, + 8192 u + 262144 v, of the even parts of its trapezoids, in 31sts.
//
// SHADOW_PAGES: pages of SHADOW_PAGE_SIDE squared texels on the pixel's own level, in a table by
// open addressing (vtkVirtualShadowRequests). Else the nodes of kd-trees in the order of a walk,
// three vectors each (vtkVirtualShadowTree).

uniform samplerBuffer shadowNodes;

int shadowGetView(float code)
{
  return (int(code) & 7) - 1;
}

float shadowPackEven(vec2 even)
{
  return dot(round(31.0 * clamp(even, 0.0, 1.0)), vec2(8192.0, 262144.0));
}

vec2 shadowGetEven(float code)
{
  return vec2(int(code) >> 13 & 31, int(code) >> 18) / 31.0;
}

#ifdef SHADOW_PAGES
uniform int shadowTableSize; // a power of two
uniform int shadowCoarser;   // halvings that all levels go without

ivec2 shadowGetLevel(float code)
{
  return max(ivec2(int(code) >> 3 & 31, int(code) >> 8 & 31) - shadowCoarser, 0);
}

// Layer of a page, and whether it was kept; -1 where there is none.
vec2 shadowFindPage(int view, ivec2 level, ivec2 number)
{
  int place = number.x + 4096 * number.y;
  int code = view + 1 + 8 * level.x + 256 * level.y;
  uint hash = uint(place) * 73856093u ^ uint(code) * 19349663u;
  hash ^= hash >> 15u;
  int slot = int(hash * 2654435761u >> 8u) & (shadowTableSize - 1);
  for (int i = 0; i < shadowTableSize; ++i)
  {
    vec4 entry = texelFetch(shadowNodes, slot);
    if (entry.x == float(place) && entry.y == float(code))
    {
      return entry.zw;
    }
    if (entry.y == 0.0)
    {
      break;
    }
    slot = (slot + 1) & (shadowTableSize - 1);
  }
  return vec2(-1.0, 0.0);
}

// The tile at a place, for debug views: a number that neighbours do not share; whether it was kept.
vec2 shadowTellTile(float code, vec2 placeLC)
{
  ivec2 level = shadowGetLevel(code);
  ivec2 number = ivec2(floor(placeLC * exp2(vec2(level))));
  vec2 page = shadowFindPage(shadowGetView(code), level, number);
  return vec2(0.2 + 0.8 * fract(0.618034 * float(number.x) + 0.381966 * float(number.y) +
    0.29 * float(level.x) + 0.13 * float(level.y)), page.y);
}
#else
uniform int shadowFirstNode[shadowMostViews + 1];

vec2 shadowTellTile(float code, vec2 placeLC)
{
  int view = shadowGetView(code);
  int node = shadowFirstNode[view];
  vec2 told = vec2(0.0);
  while (node < shadowFirstNode[view + 1])
  {
    vec4 rectangleLC = texelFetch(shadowNodes, 3 * node);
    vec4 kind = texelFetch(shadowNodes, 3 * node + 1);
    bool apart = any(greaterThan(rectangleLC.xy, placeLC)) ||
      any(lessThanEqual(rectangleLC.zw, placeLC));
    if (!apart && kind.y > 1.5)
    {
      told = vec2(0.2 + 0.8 * fract(0.618034 * float(node)), 0.0);
    }
    node = apart || kind.y > 0.5 ? int(kind.x) : node + 1;
  }
  return told;
}
#endif
