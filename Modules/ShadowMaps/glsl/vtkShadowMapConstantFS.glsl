// SPDX-License-Identifier: BSD-3-Clause
// The width of filters that do not look for blockers: that of a blocker which lies in front of the
// receiver by a share of the casters' extent.

float shadowAssumedDelta(shadowKernel kernel)
{
  float separation = kernel.scale.y;
  // Never nearer to the light than two thirds of the way: the footprint then is half the light.
  separation = kernel.positional ? min(separation, kernel.w / 3.0) : separation;
  float delta = kernel.positional ? kernel.scale.x * separation / (kernel.w * (kernel.w - separation))
    : kernel.scale.x * separation;
  return min(delta, max(kernel.receiverLC.z, 0.0));
}

// As shadowClassify, of the look-ups around the receiver at delta.
float shadowFindConstant(int view, shadowKernel kernel, float delta)
{
  shadowPenumbra = shadowWidth(view, kernel, delta);
#ifdef SHADOW_SKIPPING
  vec2 extent = shadowExtent(kernel, shadowReach(kernel, delta));
  return shadowClassify(
    kernel, shadowRange(kernel, extent), shadowReference(kernel, extent), extent);
#else
  return -1.0;
#endif
}
