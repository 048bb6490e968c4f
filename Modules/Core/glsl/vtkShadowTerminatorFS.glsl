// The shadow terminator of smoothly shaded facets. Facets turn away from the light, and hide each other
// from it, where the normals that shade them still see it: shadows cut the shading along facets. As in
// J. Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, 2021, ch. 4, the receiver rises from
// its facet by the mean height over it of its corners' tangent planes; here by as much of that as takes
// it to the surface that the normals stand for. On a sphere the mean normal is cos(a) long, the mean
// height r sin^2(a), and the sphere lies r (1 - cos(a)) over the facet.

in vec4 shadowTangentVCVSOutput;

void shadowSmooth(inout vec3 positionVC, inout vec3 normalVC)
{
  // To the side that is seen. Where the surface is hollow, facets stand in front of it: they stay.
  float side = dot(shadowTangentVCVSOutput.xyz, normalVC) < 0.0 ? -1.0 : 1.0;
  vec4 tangentVC = side * shadowTangentVCVSOutput;
  float size = length(tangentVC.xyz);
  shadowPropRounding = shadowRoundingOfProp;
  float rounding = 2.0 * shadowRounding(positionVC);
  float height = tangentVC.w - dot(tangentVC.xyz, positionVC);
  if (shadowCasts && height > -rounding && size > 0.0)
  {
    normalVC = tangentVC.xyz / size;
    positionVC += max(height - rounding, 0.0) / (1.0 + size) * normalVC;
  }
}
