// SPDX-License-Identifier: BSD-3-Clause
// Rays followed through a map: sharp at contacts, soft far from them, no noise on surfaces that go on.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestTracedShadowMap(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "map-trace");
}
