// SPDX-License-Identifier: BSD-3-Clause
// Accumulated shadow volumes: penumbrae that widen with the distance from the caster.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestSoftShadowVolume(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "volume-soft");
}
