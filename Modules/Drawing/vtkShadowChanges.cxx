// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowChanges.h"

#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkShadowChanges::Update(const vtkShadowFrame& frame, bool all)
{
  const vtkShadowCasters& casters = *frame.Casters;
  this->All =
    all || casters.GetVersion() != this->CasterVersion || frame.Parts.size() != this->Parts.size();
  this->ReceiversMoved = casters.GetReceiverVersion() != this->ReceiverVersion;
  this->Same.assign(frame.Parts.size(), false);
  for (std::size_t i = 0; !this->All && i < frame.Parts.size(); ++i)
  {
    this->Same[i] = frame.Parts[i].SameGeometry(this->Parts[i]);
  }
  this->Parts = frame.Parts;
  this->CasterVersion = casters.GetVersion();
  this->ReceiverVersion = casters.GetReceiverVersion();
}

//------------------------------------------------------------------------------
bool vtkShadowChanges::IsAny() const
{
  return this->All || std::find(this->Same.begin(), this->Same.end(), false) != this->Same.end();
}
