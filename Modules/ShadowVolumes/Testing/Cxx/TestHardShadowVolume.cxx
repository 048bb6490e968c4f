// SPDX-License-Identifier: BSD-3-Clause
// Hard shadow volumes: edges crisp to the pixel, self-shadows, contacts closed. The light is a
// rectangle, taken for its centre.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestHardShadowVolume(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "volume-hard");
}
