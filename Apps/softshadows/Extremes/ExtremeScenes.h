// SPDX-License-Identifier: BSD-3-Clause
// The scenes of the suite "extremes" by name, each a function of where on its range it is.

#ifndef ExtremeScenes_h
#define ExtremeScenes_h

#include "ExtremePlan.h"
#include "ExtremeScene.h"

#include <map>
#include <string>

using ExtremeBuilder = void (*)(ExtremeScene& scene, const ExtremeValue& at);
using ExtremeBuilders = std::map<std::string, ExtremeBuilder>;

namespace ExtremeScenes
{
/** Failure where there is none of that name. */
ExtremeBuilder Find(const std::string& name);

///@{ Each file adds its own.
void AddPlaces(ExtremeBuilders& builders);
void AddLights(ExtremeBuilders& builders);
void AddCasters(ExtremeBuilders& builders);
void AddViews(ExtremeBuilders& builders);
///@}
}

#endif
