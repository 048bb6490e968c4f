// SPDX-License-Identifier: BSD-3-Clause
// Percentage-closer soft shadows: sharp at contacts, soft far from them.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestPercentageCloserSoftShadow(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "map-pcss");
}
