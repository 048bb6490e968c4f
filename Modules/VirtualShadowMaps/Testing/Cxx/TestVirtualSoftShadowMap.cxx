// SPDX-License-Identifier: BSD-3-Clause
// Tiles of a virtual map: sharp where the column stands, soft away from it.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestVirtualSoftShadowMap(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "cylinder", "virtual-maps");
}
