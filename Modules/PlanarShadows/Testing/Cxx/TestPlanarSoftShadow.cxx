// SPDX-License-Identifier: BSD-3-Clause
// Accumulated projections: crisp where the column stands, soft away from it; only the floor receives.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestPlanarSoftShadow(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "cylinder", "planar-soft");
}
