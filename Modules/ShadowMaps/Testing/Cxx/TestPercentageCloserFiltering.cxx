// SPDX-License-Identifier: BSD-3-Clause
// Percentage-closer filtering: penumbrae as wide everywhere, smooth over 7 x 7 compares.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestPercentageCloserFiltering(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "map-pcf");
}
