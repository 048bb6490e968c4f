// SPDX-License-Identifier: BSD-3-Clause
// What a textured rectangle emits: see vtkPenumbraEmission.h. Between texels by formula, since
// hardware may take 8 bits for that and differences of near places need more.

uniform sampler2DArray shadowEmission;

vec3 shadowFetchBorder(int i)
{
  return texelFetch(
    shadowEmission, ivec3(i % SHADOW_PLACES, i / SHADOW_PLACES, SHADOW_ANGLES), 0).rgb;
}

vec3 shadowEmissionToBorder(float perimeter)
{
  float place = perimeter * float(SHADOW_OF_BORDER);
  int i = min(int(place), 8 * SHADOW_OF_BORDER - 1);
  return mix(shadowFetchBorder(i), shadowFetchBorder(i + 1), place - float(i));
}

// Of the sector between two perimeter coordinates, counterclockwise. More than half of the light is
// none, by rounding.
vec3 shadowEmissionOfSector(float from, float to)
{
  float length = to - from + (to < from ? 8.0 : 0.0);
  vec3 sector = shadowEmissionToBorder(to) - shadowEmissionToBorder(from)
    + (to < from ? 1.0 : 0.0);
  return length > 6.0 ? vec3(0.0) : sector;
}

// Of the thin triangles along a line at an angle, between two places of it, at a height.
vec3 shadowEmissionAlong(int angle, float height, vec2 places)
{
  float row = clamp(height, 0.0, 1.0) * float(SHADOW_HEIGHTS - 1);
  int j = min(int(row), SHADOW_HEIGHTS - 2);
  vec3 ends[2];
  for (int k = 0; k < 2; ++k)
  {
    float column = clamp(0.5 + 0.5 * places[k], 0.0, 1.0) * float(SHADOW_PLACES - 1);
    int i = min(int(column), SHADOW_PLACES - 2);
    vec3 low = mix(texelFetch(shadowEmission, ivec3(i, j, angle), 0).rgb,
      texelFetch(shadowEmission, ivec3(i + 1, j, angle), 0).rgb, column - float(i));
    vec3 high = mix(texelFetch(shadowEmission, ivec3(i, j + 1, angle), 0).rgb,
      texelFetch(shadowEmission, ivec3(i + 1, j + 1, angle), 0).rgb, column - float(i));
    ends[k] = mix(low, high, row - float(j));
  }
  return ends[1] - ends[0];
}

// Of the triangle of the light's centre and two points.
vec3 shadowEmissionOfTriangle(vec2 p, vec2 q)
{
  const float farthest = 1.414213562;
  vec2 along = (p.x * q.y - p.y * q.x < 0.0 ? -1.0 : 1.0) * (q - p);
  vec2 tangent = along / max(length(along), 1e-30);
  vec2 normal = vec2(tangent.y, -tangent.x);
  float height = max(0.0, dot(normal, p));
  vec2 places = vec2(dot(tangent, p), dot(tangent, q)) / farthest;
  places = vec2(min(places.x, places.y), max(places.x, places.y));
  float turn = atan(normal.y, normal.x) / 6.283185307;
  float angle = (turn < 0.0 ? turn + 1.0 : turn) * float(SHADOW_ANGLES);
  int i = int(angle);
  vec3 first = shadowEmissionAlong(i % SHADOW_ANGLES, height / farthest, places);
  vec3 second = shadowEmissionAlong((i + 1) % SHADOW_ANGLES, height / farthest, places);
  return height * mix(first, second, angle - float(i));
}
