// SPDX-License-Identifier: BSD-3-Clause
// Visibility by a filter of one map a light, which each technique defines as shadowFilter.

float shadowFilter(int view, shadowKernel kernel);

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  float visibility = 1.0;
  vec2 found = vec2(0.0); // by the view that found something
  for (int view = SHADOW_FIRST_VIEW(light); view < SHADOW_END_OF_VIEWS(light); ++view)
  {
    shadowKernel kernel;
    if (shadowFindKernel(light, view, positionVC, normalVC, kernel))
    {
      visibility = min(visibility, shadowFilter(view, kernel));
      found = max(found, vec2(shadowBlocker, shadowPenumbra));
    }
  }
  shadowBlocker = found.x;
  shadowPenumbra = found.y;
  return SHADOW_VISIBILITY(visibility);
}
