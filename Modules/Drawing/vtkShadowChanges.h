// SPDX-License-Identifier: BSD-3-Clause
// What changed since the last frame for light data that is kept by parts of lights: the rule by which
// they are kept or rebuilt.

#ifndef vtkShadowChanges_h
#define vtkShadowChanges_h

#include "vtkShadowLight.h"              // For parts of lights
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <vector>

struct vtkShadowFrame;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowChanges
{
public:
  /**
   * Compare a frame with the last one. `all` tells that light data is to be built anew, whatever the frame
   * says: a setting has changed.
   */
  void Update(const vtkShadowFrame& frame, bool all);
  /** Everything is to be built anew, also in the next frame: light data was released. */
  void Reset() { this->Parts.clear(); }

  /** Casters, the number of parts, or a setting: nothing of the last frame holds. */
  bool IsAll() const { return this->All; }
  /** The boxes of what receives: what is kept depends on it where it hugs receivers. */
  bool HaveReceiversMoved() const { return this->ReceiversMoved; }
  /** Whether a part of a light casts as it did. */
  bool IsSame(int part) const { return !this->All && this->Same[part]; }
  /** Whether anything but receivers has changed. */
  bool IsAny() const;

private:
  std::vector<vtkShadowLightPart> Parts;
  std::vector<bool> Same;
  unsigned long CasterVersion = 0;
  unsigned long ReceiverVersion = 0;
  bool All = true;
  bool ReceiversMoved = true;
};

#endif
