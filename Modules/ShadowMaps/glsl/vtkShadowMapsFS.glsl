// SPDX-License-Identifier: BSD-3-Clause
// Visibility from depth maps: one for a hard shadow, one for each sample of an accumulated one.

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  SHADOW_VISIBILITY visibility = SHADOW_VISIBILITY(1.0);
  for (int view = SHADOW_FIRST_VIEW(light); view < SHADOW_END_OF_VIEWS(light); ++view)
  {
    float height; // of the light above the receiver's plane
    vec3 receiverLC = shadowPlaceReceiver(view, positionVC, normalVC, height);
    float lit =
      texture(shadowMaps, vec4(receiverLC.xy, float(view - shadowFirstLayer), receiverLC.z));
#ifdef SHADOW_CLIPPED_VIEWS
    // Other faces of a cube go on there.
    bool inside = all(lessThanEqual(abs(receiverLC.xy - 0.5), vec2(0.5)));
    lit = inside ? lit : 1.0;
#endif
#ifdef SHADOW_HARD
#ifdef SHADOW_TELLS_AWAY
    bool away = shadowSelf && height < 0.0;
    lit = away ? 0.0 : lit;
    shadowCost -= away ? 1.0 : 0.0; // as if it had not been asked
#endif
    visibility = min(visibility, SHADOW_VISIBILITY(lit));
#else
    // Below the receiver's horizon lies its own surface, which the map cannot tell from it.
    bool own = shadowSelf && height < 0.0 &&
      all(lessThan(abs(receiverLC.xy - 0.5), vec2(0.5)));
    visibility -= SHADOW_VISIBILITY(SHADOW_VIEW(view, 6)) * (own ? 1.0 : 1.0 - lit);
#endif
    shadowCost += 1.0;
  }
  return max(visibility, 0.0);
}
