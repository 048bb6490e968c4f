// SPDX-License-Identifier: BSD-3-Clause
// The filtered projection: sharp at contacts, wider with the casters' height, without bands.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestPlanarFakeShadow(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "planar-fake");
}
