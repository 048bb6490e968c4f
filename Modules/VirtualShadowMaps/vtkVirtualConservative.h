// SPDX-License-Identifier: BSD-3-Clause
// The GPU's own conservative rasterization, where there is one: every texel counts that a triangle
// touches. Elsewhere triangles are enlarged: see vtkVirtualCoarseGS.glsl.

#ifndef vtkVirtualConservative_h
#define vtkVirtualConservative_h

#include "vtkSoftShadowsVirtualShadowMapsModule.h" // For export macro

#include <functional>

class VTKSOFTSHADOWSVIRTUALSHADOWMAPS_EXPORT vtkVirtualConservative
{
public:
  /** What OpenGL is to enable for it, by the names of its extensions; 0 where it has none. */
  static unsigned int Choose(const std::function<bool(const char*)>& has);
  /** That of the current context. */
  static unsigned int Choose();

  /** Enable what was chosen while it lives. */
  explicit vtkVirtualConservative(unsigned int capability);
  ~vtkVirtualConservative();
  vtkVirtualConservative(const vtkVirtualConservative&) = delete;
  void operator=(const vtkVirtualConservative&) = delete;

private:
  unsigned int Capability;
};

#endif
