// SPDX-License-Identifier: BSD-3-Clause
// The hard shadow on the floor: crisp at each pixel; the bodies receive none.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestPlanarHardShadow(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "planar-hard");
}
