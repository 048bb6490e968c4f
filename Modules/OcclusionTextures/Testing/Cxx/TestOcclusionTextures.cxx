// SPDX-License-Identifier: BSD-3-Clause
// Prefiltered slices: soft shadows of thin branches, with the shadows of some on others.

#include "ShadowRegression.h"

//------------------------------------------------------------------------------
int TestOcclusionTextures(int argc, char* argv[])
{
  return ShadowRegression::Test(argc, argv, "basic", "occlusion-textures");
}
