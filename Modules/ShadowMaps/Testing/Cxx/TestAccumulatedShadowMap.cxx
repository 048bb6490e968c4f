// SPDX-License-Identifier: BSD-3-Clause
// Accumulated shadow maps of a disk light: the column's and the poles' shadows are crisp where they
// stand and soften with the distance.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestAccumulatedShadowMap(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "cylinder", "map-soft");
}
