// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// All texels that a triangle touches, however thin it is: what lies within half a texel's diagonal of its
// edges, and its inside. Small ones are their box. No vertex lies behind the light.

layout(triangles) in;
layout(triangle_strip, max_vertices = 15) out;

uniform float shadowSide; // of the map, in texels

flat out vec4 shadowPlane;   // place in texels, depth there and least depth
flat out vec2 shadowGradient; // of the depth, a texel

// Half a diagonal, and a hair for the rasterizer's own grid.
const float shadowReach = 0.7072 + 1.0 / 16.0;

float shadowWiden; // what the corners may be off by

void shadowEmit(vec2 place)
{
  gl_Position = vec4(2.0 * place / shadowSide - 1.0, 0.0, 1.0);
  EmitVertex();
}

void shadowEmitEdge(vec2 from, vec2 to)
{
  vec2 edge = to - from;
  float size = length(edge);
  vec2 along = (shadowReach + shadowWiden) * (size > 1e-6 ? edge / size : vec2(1.0, 0.0));
  vec2 across = vec2(-along.y, along.x);
  shadowEmit(from - along - across);
  shadowEmit(from - along + across);
  shadowEmit(to + along - across);
  shadowEmit(to + along + across);
  EndPrimitive();
}

void main()
{
  vec3 p[3];
  for (int i = 0; i < 3; ++i)
  {
    vec3 place = 0.5 * gl_in[i].gl_Position.xyz / gl_in[i].gl_Position.w + 0.5;
    p[i] = vec3(place.xy * shadowSide, place.z);
  }
  vec3 low = min(p[0], min(p[1], p[2]));
  vec3 high = max(p[0], max(p[1], p[2]));
  float far = max(max(abs(low.x), abs(low.y)), max(abs(high.x), abs(high.y)));
  shadowWiden = far / 1048576.0;

  // Its plane bounds the depth in a texel from below, where it is not so thin or far out that rounding
  // turns it. The least depth of its corners always does.
  const float rounding = 1.0 / 1048576.0;
  vec3 a = p[1] - p[0];
  vec3 b = p[2] - p[0];
  float area = a.x * b.y - a.y * b.x;
  float longest = max(length(a.xy), max(length(b.xy), length(p[2].xy - p[1].xy)));
  vec4 plane = vec4(p[0], low.z - rounding);
  vec2 gradient = vec2(0.0);
  if (abs(area) > 0.0625 * longest && far < 64.0 * shadowSide)
  {
    gradient = vec2(a.z * b.y - b.z * a.y, b.z * a.x - a.z * b.x) / area;
    plane.z -= 0.6 * (abs(gradient.x) + abs(gradient.y)) + rounding;
  }
  else
  {
    plane.z = plane.w;
  }
  vec2 size = high.xy - low.xy;
  if (max(size.x, size.y) < 4.0)
  {
    low.xy -= 0.5625 + shadowWiden;
    high.xy += 0.5625 + shadowWiden;
    for (int i = 0; i < 4; ++i)
    {
      shadowPlane = plane;
      shadowGradient = gradient;
      shadowEmit(vec2((i & 1) == 0 ? low.x : high.x, i < 2 ? low.y : high.y));
    }
    EndPrimitive();
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    shadowPlane = plane;
    shadowGradient = gradient;
    shadowEmitEdge(p[i].xy, p[(i + 1) % 3].xy);
  }
  for (int i = 0; i < 3; ++i)
  {
    shadowPlane = plane;
    shadowGradient = gradient;
    shadowEmit(p[i].xy);
  }
  EndPrimitive();
}
