// SPDX-License-Identifier: BSD-3-Clause
// The shadow terminator of smoothly shaded facets. Facets turn away from the light, and hide each other
// from it, where the normals that shade them still see it: shadows cut the shading along facets. As in
// J. Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, 2021, ch. 4, the receiver rises from
// its facet by the mean height over it of its corners' tangent planes; here by as much of that as takes
// it to the surface that the normals stand for. On a sphere the mean normal is cos(a) long, the mean
// height r sin^2(a), and the sphere lies r (1 - cos(a)) over the facet. It rises along its pixel's ray,
// to what the pixel would show of that surface.

in vec2 shadowTangentVSOutput;
uniform vec4 shadowEyeVC; // where lines of sight meet, w 1; or the direction to the viewer, w 0

// `tangentVC` is the normal as it was interpolated between the corners.
void shadowSmooth(vec3 tangentVC, inout vec3 positionVC, inout vec3 normalVC)
{
  shadowPropRounding = shadowRoundingOfProp;
  float unit = shadowTangentVSOutput.y;
  float rounding = 2.0 * unit * shadowRounding(positionVC);
  // To the side that is seen. Where the surface is hollow, facets stand in front of it: they stay.
  float along = dot(tangentVC, normalVC); // 0 of lines and points
  float side = along < 0.0 ? -1.0 : 1.0;
  float height = side * (shadowTangentVSOutput.x - dot(tangentVC, positionVC));
  // Corners' normals that lie 45 degrees off and more stand for an edge, not for a curve.
  float curved = smoothstep(0.7 * unit, 0.85 * unit, abs(along));
  if (shadowCasts && height > -rounding && curved > 0.0)
  {
    float size2 = dot(tangentVC, tangentVC);
    float scale = inversesqrt(size2);
    normalVC = normalize(mix(normalVC, side * scale * tangentVC, curved));
    // At an outline not without end: the normal need not face the viewer.
    vec3 upVC = shadowEyeVC.xyz - shadowEyeVC.w * positionVC;
    float slant = max(dot(normalVC, upVC), 0.125 * abs(upVC.z));
    positionVC +=
      curved * max(height - rounding, 0.0) / ((unit + scale * size2) * slant) * upVC;
  }
}
