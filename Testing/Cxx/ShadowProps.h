// SPDX-License-Identifier: BSD-3-Clause
// One of each kind of prop that VTK draws, at a place of the scene, about as large as a ball of
// radius 0.6: for tests of what casts and what receives.

#ifndef ShadowProps_h
#define ShadowProps_h

#include "ShadowStage.h"

struct ShadowProp
{
  std::string Name;
  bool Casts;
  std::function<void(ShadowStage&, const glm::dvec3& centre)> Add;
};

/** All of them. */
const std::vector<ShadowProp>& GetShadowProps();

#endif
