// SPDX-License-Identifier: BSD-3-Clause
// Penumbra wedges: soft shadows from silhouettes, by formula.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestPenumbraWedges(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "wedges");
}
