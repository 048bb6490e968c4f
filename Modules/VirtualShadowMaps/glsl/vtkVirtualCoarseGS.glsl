// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Conservative rasterization: the rectangle around a triangle, with what tells which texels it
// touches, and how deep it is there. Hasselgren, Akenine-Moeller and Ohlsson, Conservative
// rasterization, GPU Gems 2, 2005, second algorithm, by its bounding rectangle alone: that of a
// sliver needs no corners far away. Where the GPU does that itself the triangle is enough, but for those
// that are so thin that its grid may leave nothing of them.

layout(triangles) in;
layout(triangle_strip, max_vertices = 4) out;

uniform float shadowSide; // of the map, in texels
uniform bool shadowOwn;   // the GPU's own conservative rasterization is on
uniform float shadowTurn; // which way triangles are turned that are drawn: 1 or -1

flat out vec3 shadowEdge0; // not negative in the middle of a texel that the triangle touches
flat out vec3 shadowEdge1;
flat out vec3 shadowEdge2;
flat out vec3 shadowPlane; // depth in [0,1] over the map in [-1,1], the least of the texel
flat out vec2 shadowRange; // of the triangle's depth; empty: of one that reaches behind the light

vec3 shadowEdge(vec2 a, vec2 b, float side)
{
  vec2 across = side * vec2(a.y - b.y, b.x - a.x);
  return vec3(across, -dot(across, a) + (abs(across.x) + abs(across.y)) / shadowSide);
}

void shadowEmit(vec4 positionDC)
{
  gl_Position = positionDC;
  EmitVertex();
}

void main()
{
  shadowEdge0 = shadowEdge1 = shadowEdge2 = shadowPlane = vec3(0.0);
  shadowRange = vec2(1.0, 0.0);
  vec4 p[3] = vec4[3](gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position);
  // The sign of the area in the picture, also of what reaches behind the light.
  float turn = dot(p[0].xyw, cross(p[1].xyw, p[2].xyw));
  if ((turn < 0.0 ? -1.0 : 1.0) != shadowTurn)
  {
    return;
  }
  if (min(p[0].w, min(p[1].w, p[2].w)) <= 0.0)
  {
    for (int i = 0; i < 3; ++i)
    {
      shadowEmit(p[i]);
    }
    EndPrimitive();
    return;
  }
  vec3 a = p[0].xyz / p[0].w;
  vec3 b = p[1].xyz / p[1].w;
  vec3 c = p[2].xyz / p[2].w;
  vec3 depths = 0.5 * vec3(a.z, b.z, c.z) + 0.5;
  shadowRange =
    vec2(min(depths.x, min(depths.y, depths.z)), max(depths.x, max(depths.y, depths.z)));
  vec2 ab = b.xy - a.xy;
  vec2 ac = c.xy - a.xy;
  float area = ab.x * ac.y - ab.y * ac.x;
  float side = area < 0.0 ? -1.0 : 1.0;
  shadowEdge0 = shadowEdge(a.xy, b.xy, side);
  shadowEdge1 = shadowEdge(b.xy, c.xy, side);
  shadowEdge2 = shadowEdge(c.xy, a.xy, side);
  // Of a sliver the slope is anything: the triangle's range bounds what it gives.
  vec2 slope = (depths.y - depths.x) * vec2(ac.y, -ac.x) +
    (depths.z - depths.x) * vec2(-ab.y, ab.x);
  slope /= abs(area) > 1e-30 ? area : 1e-30;
  float least = (abs(slope.x) + abs(slope.y)) / shadowSide;
  shadowPlane = vec3(slope, depths.x - dot(slope, a.xy) - least);
  vec2 low = min(a.xy, min(b.xy, c.xy)) - 1.0 / shadowSide;
  vec2 high = max(a.xy, max(b.xy, c.xy)) + 1.0 / shadowSide;
  low = max(low, vec2(-1.0));
  high = min(high, vec2(1.0));
  if (any(greaterThanEqual(low, high)) || shadowRange.x > 1.0)
  {
    return;
  }
  float longest = max(length(ab), max(length(ac), length(c.xy - b.xy)));
  if (shadowOwn && abs(area) > longest / (8.0 * shadowSide))
  {
    shadowEmit(vec4(a.xy, 0.0, 1.0));
    shadowEmit(vec4(b.xy, 0.0, 1.0));
    shadowEmit(vec4(c.xy, 0.0, 1.0));
    EndPrimitive();
    return;
  }
  shadowEmit(vec4(low, 0.0, 1.0));
  shadowEmit(vec4(high.x, low.y, 0.0, 1.0));
  shadowEmit(vec4(low.x, high.y, 0.0, 1.0));
  shadowEmit(vec4(high, 0.0, 1.0));
  EndPrimitive();
}
