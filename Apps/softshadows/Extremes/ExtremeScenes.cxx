// SPDX-License-Identifier: BSD-3-Clause
#include "ExtremeScenes.h"

#include "Errors.h"

namespace ExtremeScenes
{
//------------------------------------------------------------------------------
ExtremeBuilder Find(const std::string& name)
{
  static const ExtremeBuilders builders = []
  {
    ExtremeBuilders all;
    AddPlaces(all);
    AddLights(all);
    AddCasters(all);
    AddViews(all);
    return all;
  }();
  const auto found = builders.find(name);
  if (found == builders.end())
  {
    std::string known;
    for (const auto& builder : builders)
    {
      known += (known.empty() ? "" : ", ") + builder.first;
    }
    throw Failure("there is no scene \"" + name + "\" to sweep. Known: " + known + ".");
  }
  return found->second;
}
}
