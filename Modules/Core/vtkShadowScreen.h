// SPDX-License-Identifier: BSD-3-Clause
// A picture's receivers and their visibility: of its opaque surfaces, or of the nearest translucent ones.

#ifndef vtkShadowScreen_h
#define vtkShadowScreen_h

#include "vtkShadowReceivers.h"
#include "vtkVisibilityBuffer.h"

#include <cstddef>

struct vtkShadowScreen
{
  vtkShadowReceivers Receivers;
  vtkVisibilityBuffer Visibility;
  bool Drawn = false; // the receivers, in this frame
  bool Valid = false; // the visibility too

  void Activate(vtkOpenGLRenderWindow* window)
  {
    this->Receivers.GetTexture().Activate(window);
    this->Visibility.GetShown().Activate(window);
  }
  void Deactivate(vtkOpenGLRenderWindow* window)
  {
    this->Receivers.GetTexture().Deactivate(window);
    this->Visibility.GetShown().Deactivate(window);
  }
  std::size_t GetBytes() const { return this->Receivers.GetBytes() + this->Visibility.GetBytes(); }
  void Release(vtkOpenGLRenderWindow* window)
  {
    this->Receivers.Release(window);
    this->Visibility.Release(window);
    this->Drawn = this->Valid = false;
  }
};

#endif
