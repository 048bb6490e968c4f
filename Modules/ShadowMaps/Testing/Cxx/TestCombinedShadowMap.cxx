// SPDX-License-Identifier: BSD-3-Clause
// The combined method: sharp at contacts, soft far from them, with fine noise.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestCombinedShadowMap(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "map-combined");
}
