// SPDX-License-Identifier: BSD-3-Clause
// What each pixel of a picture shows of the surfaces that receive: their position and geometric normal.
//
//   receivers  RGBA32F  xyz: position in VC; w: packed normal, rounding and side (see vtkShadowReceiver),
//                       negative where the prop does not cast, 0 where nothing receives
//   depth      24 bits  helper of these; as the window's, so that coplanar surfaces hide each other as
//                       they do in the picture
//
// vtkShadowReceiversFS.glsl reads them.

#ifndef vtkShadowReceivers_h
#define vtkShadowReceivers_h

#include "vtkShadowGL.h"                 // For textures
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

/** What shadowPackReceiver in vtkShadowInjectFS.glsl packs into the receivers' fourth component. */
struct VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowReceiver
{
  glm::dvec3 Normal{ 0.0 }; // unit, in VC
  double Rounding = 0.0;    // how far its prop's positions may be off: a power of two

  /** Whether a texel is one: what is not finite counts as lit, and is asked nothing. */
  static bool IsOne(const glm::vec4& texel);
  /** Of a component that is not 0; its sign, a flag, does not matter. */
  static vtkShadowReceiver Unpack(float packed);
};

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowReceivers
{
public:
  /** Make them this size. False when out of memory. */
  bool Allocate(vtkOpenGLRenderWindow* window, int width, int height);

  int GetWidth() const { return this->Texture.GetWidth(); }
  int GetHeight() const { return this->Texture.GetHeight(); }
  vtkShadowTexture& GetTexture() { return this->Texture; }
  const vtkShadowTexture& GetDepth() const { return this->Depth; }
  vtkShadowFramebuffer& GetFramebuffer() { return this->Framebuffer; }

  /** GLSL that reads them: vtkShadowReceiversFS.glsl. */
  static std::string GetGLSL();
  /**
   * Texels, row by row from the bottom, valid until the next call: the memory is kept. As
   * shadowFetchReceiver gives them: their normals are those of what is seen.
   */
  const std::vector<glm::vec4>& Read(vtkOpenGLRenderWindow* window);

  std::size_t GetBytes() const { return this->Texture.GetBytes() + this->Depth.GetBytes(); }
  void Release(vtkOpenGLRenderWindow* window);

private:
  vtkShadowTexture Texture;
  vtkShadowTexture Depth;
  vtkShadowFramebuffer Framebuffer;
  std::vector<glm::vec4> Texels;
};

#endif
