// The screen-space buffers of a pass: what each pixel's receiver is, and its visibility.
//
//   receivers   RGBA32F  xyz: position in VC; w: packed normal and rounding (see vtkShadowReceiver),
//                        negative where the prop does not cast, 0 where nothing receives
//   depth       24 bits  helper of the receivers; as the window's, so that coplanar surfaces hide each
//                        other as they do in the picture
//   visibility  R32F, or RGBA32F with a textured light; a layer each light
//   quantity    R32F, a layer each light: what a debug view shows instead

#ifndef vtkVisibilityBuffer_h
#define vtkVisibilityBuffer_h

#include "vtkShadowGL.h"              // For textures
#include "vtkSoftShadowsCoreModule.h" // For export macro

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

/** What shadowPackReceiver in vtkShadowInjectFS.glsl packs into the receivers' fourth component. */
struct VTKSOFTSHADOWSCORE_EXPORT vtkShadowReceiver
{
  glm::dvec3 Normal{ 0.0 }; // unit, in VC
  double Rounding = 0.0;    // how far its prop's positions may be off: a power of two

  /** Whether a texel is one: what is not finite counts as lit, and is asked nothing. */
  static bool IsOne(const glm::vec4& texel);
  /** Of a component that is not 0; its sign, a flag, does not matter. */
  static vtkShadowReceiver Unpack(float packed);
};

class VTKSOFTSHADOWSCORE_EXPORT vtkVisibilityBuffer
{
public:
  /** Make it this size. False when out of memory. */
  bool Allocate(vtkOpenGLRenderWindow* window, int width, int height, int lights, bool color);

  int GetWidth() const { return this->Receivers.GetWidth(); }
  int GetHeight() const { return this->Receivers.GetHeight(); }
  bool IsColor() const { return this->Color; }
  /** 1, or 4 where a light is textured. */
  int GetComponents() const { return this->Color ? 4 : 1; }

  /**
   * What is to be filled instead of the visibility: the name of a variable of the GLSL, such as
   * shadowCost, or empty.
   */
  const std::string& GetQuantity() const { return this->Quantity; }
  void SetQuantity(vtkOpenGLRenderWindow* window, const std::string& name);
  /** What is to be filled, a layer each light. */
  vtkShadowTexture& GetTarget()
  {
    return this->Quantity.empty() ? this->Visibility : this->Quantities;
  }

  vtkShadowTexture& GetReceivers() { return this->Receivers; }
  const vtkShadowTexture& GetReceiverDepth() const { return this->ReceiverDepth; }
  vtkShadowFramebuffer& GetFramebuffer() { return this->Framebuffer; }

  /** Texels, row by row from the bottom. */
  std::vector<glm::vec4> ReadReceivers(vtkOpenGLRenderWindow* window);
  /** GetComponents() floats a pixel, or 1 of a quantity. */
  std::vector<float> ReadTarget(vtkOpenGLRenderWindow* window, int light);

  std::size_t GetGPUBytes() const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  void Read(vtkOpenGLRenderWindow* window, const vtkShadowTexture& texture, int layer,
    int components, float* values);

  vtkShadowTexture Receivers;
  vtkShadowTexture ReceiverDepth;
  vtkShadowTexture Visibility;
  vtkShadowTexture Quantities;
  vtkShadowFramebuffer Framebuffer;
  bool Color = false;
  std::string Quantity;
};

#endif
