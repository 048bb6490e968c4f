// Visibility from depth maps: one for a hard shadow, one for each sample of an accumulated one.
//
// A view (see vtkLightView and vtkShadowMaps) is seven vectors: the rows of the matrix from VC to the
// map ([0,1] in x, y and z after division), the extent in VC at w = 1 of the texels that one look-up
// can read, along the map's x and y, and the weight of the view's sample. The last three have the
// place that the view looks from in their fourth components.
//
// SHADOW_FEW_VIEWS is defined to their number where they are few: what loops over them unrolls.

uniform sampler2DArrayShadow shadowMaps;
#ifdef SHADOW_FEW_VIEWS
uniform vec4 shadowViews[7 * SHADOW_FEW_VIEWS];
const int shadowFirstView[SHADOW_LIGHTS] = int[SHADOW_LIGHTS](SHADOW_FIRST_VIEWS);
const int shadowViewCount[SHADOW_LIGHTS] = int[SHADOW_LIGHTS](SHADOW_VIEW_COUNTS);
const int shadowFirstLayer = 0;
#define SHADOW_VIEW(i) shadowViews[i]
#else
uniform samplerBuffer shadowViews;
uniform int shadowFirstView[SHADOW_LIGHTS];
uniform int shadowViewCount[SHADOW_LIGHTS];
uniform int shadowFirstLayer; // the view that layer 0 holds
#define SHADOW_VIEW(i) texelFetch(shadowViews, i)
#endif

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
  float rounding = shadowRounding(positionVC);
  int last = shadowFirstView[light] + shadowViewCount[light];
  for (int view = shadowFirstView[light]; view < last; ++view)
  {
    vec4 rowW = SHADOW_VIEW(7 * view + 3);
    vec4 texelX = SHADOW_VIEW(7 * view + 4);
    vec4 texelY = SHADOW_VIEW(7 * view + 5);
    vec4 weight = SHADOW_VIEW(7 * view + 6);

    // Bias without a knob: a plane that is moved along its normal by what it can rise within the
    // texels of one look-up is in front of its own samples in the map, and not a hair more. A
    // plane's depth over the map's texels grows by |n.x|, |n.y| times their extent at that
    // distance, measured along its normal: so there is no slope to divide by.
    float w = dot(rowW, vec4(positionVC, 1.0));
    float rise = abs(dot(normalVC, texelX.xyz)) + abs(dot(normalVC, texelY.xyz));
    vec4 receiverVC = vec4(positionVC + (rise * w + rounding) * normalVC, 1.0);

    // Behind the light, w is negative: the quotient of a tiny one lies far outside of the map. Maps
    // have a clear border, so outside there is light. Behind the far plane, all casters are in front.
    w = max(dot(rowW, receiverVC), 1e-30);
    vec3 receiverLC = vec3(dot(SHADOW_VIEW(7 * view), receiverVC),
      dot(SHADOW_VIEW(7 * view + 1), receiverVC), dot(SHADOW_VIEW(7 * view + 2), receiverVC)) / w;
    float lit = texture(shadowMaps,
      vec4(receiverLC.xy, float(view - shadowFirstLayer), min(receiverLC.z, 1.0)));
#ifdef SHADOW_CLIPPED_VIEWS
    // Other faces of a cube go on there.
    bool inside = all(lessThanEqual(abs(receiverLC.xy - 0.5), vec2(0.5)));
    lit = inside ? lit : 1.0;
#endif
#ifdef SHADOW_HARD
    visibility = min(visibility, SHADOW_VISIBILITY(lit));
#else
    // Below the receiver's horizon lies its own surface, which the map cannot tell from it.
    vec3 placeVC = vec3(texelX.w, texelY.w, weight.w);
    vec3 towardsVC = rowW.xyz == vec3(0.0) ? placeVC : placeVC - positionVC;
    bool own = shadowSelf && dot(normalVC, towardsVC) < 0.0 &&
      all(lessThan(abs(receiverLC.xy - 0.5), vec2(0.5)));
    visibility -= SHADOW_VISIBILITY(weight) * (own ? 1.0 : 1.0 - lit);
#endif
    shadowCost += 1.0;
  }
  return max(visibility, 0.0);
}
