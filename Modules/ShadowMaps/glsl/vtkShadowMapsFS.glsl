// Visibility from depth maps: one for a hard shadow, one for each sample of an accumulated one.
//
// A view (see vtkLightView and vtkShadowMaps) is seven texels of shadowViews: the rows of the matrix
// from WC to the map ([0,1] in x, y and z after division), the world extent at w = 1 of the texels
// that one look-up can read, along the map's x and y, and the weight of the view's sample.

uniform samplerBuffer shadowViews;
uniform sampler2DArrayShadow shadowMaps;
uniform int shadowFirstView[SHADOW_MAX_LIGHTS];
uniform int shadowViewCount[SHADOW_MAX_LIGHTS];
uniform int shadowFirstLayer; // the view that layer 0 holds

// Rounding of a 32-bit depth in the rasterizer.
const float shadowDepthRounding = 1.0 / 1048576.0;

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionWC, vec3 normalWC)
{
  SHADOW_VISIBILITY occluded = SHADOW_VISIBILITY(0.0);
  int last = shadowFirstView[light] + shadowViewCount[light];
  for (int view = shadowFirstView[light]; view < last; ++view)
  {
    int texel = 7 * view;
    vec4 rowX = texelFetch(shadowViews, texel);
    vec4 rowY = texelFetch(shadowViews, texel + 1);
    vec4 rowZ = texelFetch(shadowViews, texel + 2);
    vec4 rowW = texelFetch(shadowViews, texel + 3);

    vec4 texelX = texelFetch(shadowViews, texel + 4);
    vec4 texelY = texelFetch(shadowViews, texel + 5);
    vec4 weight = texelFetch(shadowViews, texel + 6);
    // Where the view looks from; for a directional light, the direction towards it.
    vec3 placeWC = vec3(texelX.w, texelY.w, weight.w);
    vec3 towardsWC = rowW.xyz == vec3(0.0) ? placeWC : placeWC - positionWC;

    // Bias without a knob: a plane that is moved along its normal by what it can rise within the
    // texels of one look-up is in front of its own samples in the map, and not a hair more. A
    // plane's depth over the map's texels grows by |n.x|, |n.y| times their extent at that
    // distance, measured along its normal: so there is no slope to divide by.
    float w = dot(rowW, vec4(positionWC, 1.0));
    float rise = abs(dot(normalWC, texelX.xyz)) + abs(dot(normalWC, texelY.xyz));
    vec4 receiverWC = vec4(positionWC + (rise * w + shadowRounding) * normalWC, 1.0);

    w = dot(rowW, receiverWC);
    vec3 receiverLC =
      vec3(dot(rowX, receiverWC), dot(rowY, receiverWC), dot(rowZ, receiverWC)) / w;
    // Outside of a map there is no caster; behind its far plane, all of them are in front.
    if (w > 0.0 && all(greaterThanEqual(receiverLC.xy, vec2(0.0))) &&
      all(lessThan(receiverLC.xy, vec2(1.0))))
    {
      float depth = min(receiverLC.z, 1.0) - shadowDepthRounding;
      float lit = texture(shadowMaps, vec4(receiverLC.xy, float(view - shadowFirstLayer), depth));
      // Below the receiver's horizon lies its own surface, which the map cannot tell from it.
      lit = shadowSelf && dot(normalWC, towardsWC) <= 0.0 ? 0.0 : lit;
      occluded += SHADOW_VISIBILITY(weight) * (1.0 - lit);
      shadowCost += 1.0;
    }
  }
  return clamp(1.0 - occluded, 0.0, 1.0);
}
