// SPDX-License-Identifier: BSD-3-Clause
// The reference: a rectangular light over things at different heights, on them and on the floor. So
// many rays that the noise is under the comparison's tolerance.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestRayTracedShadows(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "ray-traced", { { "samples", "256" } });
}
