// SPDX-License-Identifier: BSD-3-Clause
// The hard shadow map: crisp edges, no acne, no gap where a caster stands on the floor. The light
// is a rectangle, taken for its centre.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestHardShadowMap(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "map-hard");
}
