// SPDX-License-Identifier: BSD-3-Clause
// The blurred mask: smooth edges, no halo along silhouettes.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestBlurredShadowMap(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "map-blur");
}
