// Visibility from depth maps: one for a hard shadow, one for each sample of an accumulated one.

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
  for (int view = SHADOW_FIRST_VIEW(light); view < SHADOW_END_OF_VIEWS(light); ++view)
  {
    // Behind the far plane, all casters are in front.
    vec3 receiverLC = shadowProject(view, shadowMoveReceiver(view, positionVC, normalVC));
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
    vec4 weight = SHADOW_VIEW(view, 6);
    vec3 placeVC = vec3(SHADOW_VIEW(view, 4).w, SHADOW_VIEW(view, 5).w, weight.w);
    vec3 towardsVC =
      SHADOW_VIEW(view, 3).xyz == vec3(0.0) ? placeVC : placeVC - positionVC;
    bool own = shadowSelf && dot(normalVC, towardsVC) < 0.0 &&
      all(lessThan(abs(receiverLC.xy - 0.5), vec2(0.5)));
    visibility -= SHADOW_VISIBILITY(weight) * (own ? 1.0 : 1.0 - lit);
#endif
    shadowCost += 1.0;
  }
  return max(visibility, 0.0);
}
