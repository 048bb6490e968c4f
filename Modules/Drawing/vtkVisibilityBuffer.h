// SPDX-License-Identifier: BSD-3-Clause
// The visibility of receivers in screen space, a layer each part of a light.
//
//   visibility  R32F, or RGBA32F with a textured light
//   mean        the same, of several frames, where they add up
//   quantity    R32F: what a debug view shows instead

#ifndef vtkVisibilityBuffer_h
#define vtkVisibilityBuffer_h

#include "vtkShadowGL.h"                 // For textures
#include "vtkShadowReceivers.h"          // For whose visibility it is
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
struct vtkShadowFrame;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkVisibilityBuffer
{
public:
  /** Make it that of receivers, which outlive it. False when out of memory. */
  bool Allocate(
    vtkOpenGLRenderWindow* window, vtkShadowReceivers& receivers, int lights, bool color);

  int GetWidth() const { return this->Visibility.GetWidth(); }
  int GetHeight() const { return this->Visibility.GetHeight(); }
  bool IsColor() const { return this->Color; }
  /** 1, or 4 where a light is textured. */
  int GetComponents() const { return this->Color ? 4 : 1; }

  /**
   * What is to be filled instead of the visibility: the name of a variable of the GLSL, such as
   * shadowCost, or empty.
   */
  const std::string& GetQuantity() const { return this->Quantity; }
  void SetQuantity(vtkOpenGLRenderWindow* window, const std::string& name);
  /** What is to be filled, a layer each part of a light. */
  vtkShadowTexture& GetTarget()
  {
    return this->Quantity.empty() ? this->Visibility : this->Quantities;
  }

  /**
   * Add what was filled to the mean of `before` frames, which is shown from then on. False when out of
   * memory.
   */
  bool Accumulate(vtkShadowFrame& frame, int before);
  /** Show what is filled again. */
  void ForgetMean(vtkOpenGLRenderWindow* window);
  /** What is to be looked up and read: what was filled, or the mean. */
  vtkShadowTexture& GetShown() { return this->ShowsMean ? this->Mean : this->GetTarget(); }

  vtkShadowReceivers& GetReceivers() { return *this->Receivers; }
  vtkShadowFramebuffer& GetFramebuffer() { return this->Framebuffer; }

  ///@{
  /**
   * Before and after signed shares are added: clear all layers to full visibility, or a quantity to 0;
   * then keep the sums within 0 and 1, the visibility of what turns away from the whole light at 0, and
   * that of what receives nothing at 1.
   */
  void Clear(vtkShadowFrame& frame);
  void Resolve(vtkShadowFrame& frame);
  ///@}

  /** GetComponents() floats a pixel, or 1 of a quantity; row by row from the bottom. */
  std::vector<float> ReadTarget(vtkOpenGLRenderWindow* window, int part);
  /** The same of what is shown. */
  std::vector<float> ReadShown(vtkOpenGLRenderWindow* window, int part);

  std::size_t GetBytes() const
  {
    return this->Visibility.GetBytes() + this->Mean.GetBytes() + this->Quantities.GetBytes();
  }
  void Release(vtkOpenGLRenderWindow* window);

private:
  std::vector<float> Read(vtkOpenGLRenderWindow* window, vtkShadowTexture& texture, int part);

  vtkShadowReceivers* Receivers = nullptr;
  vtkShadowTexture Visibility;
  vtkShadowTexture Mean;
  vtkShadowTexture Quantities;
  vtkShadowFramebuffer Framebuffer;
  bool Color = false;
  bool ShowsMean = false;
  std::string Quantity;
};

#endif
