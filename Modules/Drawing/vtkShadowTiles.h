// SPDX-License-Identifier: BSD-3-Clause
// A picture's receivers by tiles: the box that those of each tile fill, found on the GPU.
//
//   low, high  RGBA32F  a texel a tile of 16 x 16 pixels: corners of the box in VC; w: how many receivers
//                       the tile has. A tile without any has a low corner above its high one.

#ifndef vtkShadowTiles_h
#define vtkShadowTiles_h

#include "vtkShadowGL.h"                 // For textures
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <cstddef>

class vtkShadowReceivers;
struct vtkShadowFrame;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowTiles
{
public:
  /** Pixels along a side of a tile; those at the right and upper border may be cut. */
  static constexpr int Side = 16;

  /** Find the boxes of a picture's receivers. False when out of memory. */
  bool Update(vtkShadowFrame& frame, vtkShadowReceivers& receivers);

  /** Tiles across and up. */
  int GetWidth() const { return this->Low.GetWidth(); }
  int GetHeight() const { return this->Low.GetHeight(); }
  ///@{ To be looked up; or to be read with the framebuffer (vtkShadowFramebuffer::Read).
  vtkShadowTexture& GetLow() { return this->Low; }
  vtkShadowTexture& GetHigh() { return this->High; }
  vtkShadowFramebuffer& GetFramebuffer() { return this->Framebuffer; }
  ///@}

  std::size_t GetBytes() const { return this->Low.GetBytes() + this->High.GetBytes(); }
  void Release(vtkOpenGLRenderWindow* window);

private:
  vtkShadowTexture Low;
  vtkShadowTexture High;
  vtkShadowFramebuffer Framebuffer;
};

#endif
