// SPDX-License-Identifier: BSD-3-Clause
// Shares of a light that lines cut off: on the light, whose centre is 0 and whose half axes are 1.
// Of a textured light a share each channel.

#ifdef SHADOW_WEDGE_EMISSION
#define SHADOW_SHARES vec3
#else
#define SHADOW_SHARES float
#endif

// The half plane of the light that a surface, from a point of it, hides from itself; xy along the
// light, z in its centre: what is positive is seen.
vec3 shadowHorizon(shadowAreaSeen area, vec3 normalVC)
{
  return vec3(dot(normalVC, area.uVC), dot(normalVC, area.vVC), dot(normalVC, area.towardsVC));
}

// Whether that line meets the light.
bool shadowIsCut(vec3 line)
{
#if SHADOW_WEDGE_SHAPE == 0
  return abs(line.z) < abs(line.x) + abs(line.y);
#else
  return abs(line.z) < length(line.xy);
#endif
}

#if SHADOW_WEDGE_SHAPE == 0
// Where a ray from the square's middle meets its border, counterclockwise: 0 to 8.
float shadowPerimeter(vec2 p)
{
  float most = max(abs(p.x), abs(p.y));
  vec2 q = most > 0.0 ? p / most : vec2(1.0, 0.0);
  return abs(p.x) >= abs(p.y) ? (p.x >= 0.0 ? 1.0 + q.y : 5.0 - q.y)
                              : (p.y >= 0.0 ? 3.0 - q.x : 7.0 + q.x);
}
#endif

float shadowCross(vec2 p, vec2 q)
{
  return p.x * q.y - p.y * q.x;
}

// The light between a line's part within it and its border, seen from its centre: the sector less
// the triangle. Not signed. The turn from p to q is 1 counterclockwise, or -1; where they lie on
// opposite sides of the centre a textured light's share depends on it.
SHADOW_SHARES shadowCoverOfPart(vec2 p, vec2 q, float turn)
{
#ifdef SHADOW_WEDGE_EMISSION
  return max(vec3(0.0), shadowEmissionOfSector(shadowPerimeter(turn < 0.0 ? q : p),
    shadowPerimeter(turn < 0.0 ? p : q)) - shadowEmissionOfTriangle(p, q));
#else
  float twice = abs(shadowCross(p, q));
#if SHADOW_WEDGE_SHAPE == 0
  float d = abs(shadowPerimeter(p) - shadowPerimeter(q));
  return max(0.0, min(d, 8.0 - d) - twice) / 8.0;
#else
  return max(0.0, atan(twice, dot(p, q)) - twice) / 6.283185307;
#endif
#endif
}

float shadowTurn(vec2 p, vec2 q)
{
  return shadowCross(p, q) < 0.0 ? -1.0 : 1.0;
}

#define SHADOW_CLIP(a, b) \
  { \
    float fa = a; \
    float fb = b; \
    float t = fa / (fa - fb); \
    first = fa < 0.0 ? (fb < 0.0 ? 2.0 : max(first, t)) : first; \
    last = fa >= 0.0 && fb < 0.0 ? min(last, t) : last; \
  }

// The part of a line within the light.
vec4 shadowChord(vec3 line)
{
  float slope = max(length(line.xy), 1e-30);
  vec2 foot = -line.xy / slope * (line.z / slope);
  vec2 tangent = vec2(-line.y, line.x) / slope;
#if SHADOW_WEDGE_SHAPE == 0
  vec2 p = foot - 3.0 * tangent;
  vec2 q = foot + 3.0 * tangent;
  float first = 0.0;
  float last = 1.0;
  SHADOW_CLIP(1.0 - p.x, 1.0 - q.x)
  SHADOW_CLIP(1.0 + p.x, 1.0 + q.x)
  SHADOW_CLIP(1.0 - p.y, 1.0 - q.y)
  SHADOW_CLIP(1.0 + p.y, 1.0 + q.y)
  last = max(first, last);
  return vec4(mix(p, q, first), mix(p, q, last));
#else
  float chord = sqrt(max(0.0, 1.0 - dot(foot, foot)));
  return vec4(foot - chord * tangent, foot + chord * tangent);
#endif
}

// What a surface sees of the light beside itself.
SHADOW_SHARES shadowAboveHorizon(vec3 line)
{
  if (!shadowIsCut(line))
  {
    return SHADOW_SHARES(line.z < 0.0 ? 0.0 : 1.0);
  }
  vec4 chord = shadowChord(line);
  SHADOW_SHARES cover =
    shadowCoverOfPart(chord.xy, chord.zw, shadowTurn(chord.xy, chord.zw));
  return line.z < 0.0 ? cover : 1.0 - cover;
}

// The light behind a chord, between the rays from the centre through two points.
SHADOW_SHARES shadowCoverOfSector(vec4 chord, vec2 p, vec2 q)
{
  float turn = shadowTurn(p, q);
  float first = 0.0;
  float last = 1.0;
  SHADOW_CLIP(turn * shadowCross(p, chord.xy), turn * shadowCross(p, chord.zw))
  SHADOW_CLIP(turn * shadowCross(chord.xy, q), turn * shadowCross(chord.zw, q))
  vec2 from = mix(chord.xy, chord.zw, first);
  vec2 to = mix(chord.xy, chord.zw, last);
  return last > first ? shadowCoverOfPart(from, to, shadowTurn(from, to)) : SHADOW_SHARES(0.0);
}

// Of a part within the light, what lies above the horizon of what is behind it.
SHADOW_SHARES shadowCoverAbove(vec2 p, vec2 q, float turn, vec3 line)
{
  float a = dot(line, vec3(p, 1.0));
  float b = dot(line, vec3(q, 1.0));
  vec2 middle = a == b ? p : mix(p, q, clamp(a / (a - b), 0.0, 1.0));
  bool some = a >= 0.0 || b >= 0.0;
  vec2 aboveP = a >= 0.0 ? p : middle;
  vec2 aboveQ = b >= 0.0 ? q : middle;
  vec4 chord = shadowChord(line);
  SHADOW_SHARES none = SHADOW_SHARES(0.0);
  SHADOW_SHARES cover = some ? shadowCoverOfPart(aboveP, aboveQ, turn) : none;
  if (line.z >= 0.0)
  {
    // What lies behind the horizon is not behind the edge's part above it.
    return some ? max(none, cover - shadowCoverOfSector(chord, aboveP, aboveQ)) : none;
  }
  // The centre is below: behind a part below lies what is above.
  bool less = a < 0.0 || b < 0.0;
  return cover + (less ? shadowCoverOfSector(chord, a < 0.0 ? p : middle, b < 0.0 ? q : middle)
                       : none);
}

// The same of an edge, from the images of its ends (x, y, w), and its turn around the centre.
SHADOW_SHARES shadowCover(vec3 from, vec3 to, float turn, bool cut, vec3 horizon)
{
  // The part of the edge between the receiver and the light. Near the receiver the image is far
  // off.
  float least = 1e-6 * max(max(abs(from.z), abs(to.z)), max(length(from.xy), length(to.xy)));
  vec3 along = to - from;
  float first = 0.0;
  float last = 1.0;
  SHADOW_CLIP(from.z - least, to.z - least)
#if SHADOW_WEDGE_SHAPE != 3
  SHADOW_CLIP(1.0 - from.z, 1.0 - to.z)
#endif
#if SHADOW_WEDGE_SHAPE == 0
  SHADOW_CLIP(from.z - from.x, to.z - to.x)
  SHADOW_CLIP(from.z + from.x, to.z + to.x)
  SHADOW_CLIP(from.z - from.y, to.z - to.y)
  SHADOW_CLIP(from.z + from.y, to.z + to.y)
#endif
  if (!(last > first))
  {
    return SHADOW_SHARES(0.0);
  }
  vec3 a = first > 0.0 ? from + first * along : from;
  vec3 b = last < 1.0 ? from + last * along : to;
#if SHADOW_WEDGE_SHAPE == 0
  vec2 p = clamp(a.xy / a.z, -1.0, 1.0);
  vec2 q = clamp(b.xy / b.z, -1.0, 1.0);
#else
  // The image's line: its distance from the centre, and where it lies along it.
  vec3 line = cross(from, to);
  float slope = max(length(line.xy), 1e-30);
  float height = line.z / slope;
  if (!(abs(height) < 1.0))
  {
    return SHADOW_SHARES(0.0);
  }
  vec2 tangent = vec2(-line.y, line.x) / slope;
  float chord = sqrt((1.0 - height) * (1.0 + height));
  vec2 ends = clamp(vec2(dot(tangent, a.xy) / a.z, dot(tangent, b.xy) / b.z), -chord, chord);
  vec2 foot = -height * line.xy / slope;
  vec2 p = foot + ends.x * tangent;
  vec2 q = foot + ends.y * tangent;
#endif
  SHADOW_SHARES cover = shadowCoverOfPart(p, q, turn);
  // A loop, since software jumps over loops, and not over branches.
  for (int i = cut ? 0 : 1; i < 1; ++i)
  {
    cover = shadowCoverAbove(p, q, turn, horizon);
  }
  return cover;
}
