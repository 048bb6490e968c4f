// SPDX-License-Identifier: BSD-3-Clause
// What the closed-form tests share: how near a technique must come to the truth.

#ifndef ClosedForms_h
#define ClosedForms_h

#include "ShadowOracle.h"

/**
 * Compare V with the truth at the points of one actor that a pixel shows, away from its silhouette.
 *
 * A technique that is exact for this kind of light, and whose convergence is declared, is held to it
 * at each number of samples; any other soft one must be nearer to the truth than no penumbra at all, and a hard one must be the
 * truth of the light's centre but for 1.5 % of the pixels (a texel along the shadow's edges).
 */
void CheckClosedForm(const std::string& technique, LightKind kind, ShadowStage& stage,
  vtkActor* receiver, const std::function<double(const glm::dvec3& point)>& soft,
  const std::function<double(const glm::dvec3& point)>& hard, double slack = 0.0);

#endif
