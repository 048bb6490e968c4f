// SPDX-License-Identifier: BSD-3-Clause
// Jittered filtering: penumbrae as wide everywhere, fine noise instead of steps.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestJitteredShadowMap(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "map-jitter");
}
