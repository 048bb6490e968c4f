// SPDX-License-Identifier: BSD-3-Clause
// Some of a picture's receivers, chosen on the GPU and read back by themselves: for rays, and for whatever
// else the CPU does for a few pixels.
//
//   selected  buffer  20 bytes a pixel of the picture: texel of the receiver, number of the pixel
//
// Start leaves the GPU to its work; Finish waits for it. In between, both are free.

#ifndef vtkShadowSelection_h
#define vtkShadowSelection_h

#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

class vtkShaderProgram;
class vtkShadowReceivers;
struct vtkShadowFrame;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowSelection
{
public:
  struct Pixel
  {
    glm::vec4 Receiver;  // see vtkShadowReceivers
    std::int32_t Number; // row by row from the bottom
  };

  vtkShadowSelection() = default;
  vtkShadowSelection(const vtkShadowSelection&) = delete;
  void operator=(const vtkShadowSelection&) = delete;

  /**
   * Choose the pixels where GLSL gives true: `bool shadowSelect(vec4 receiverVC)`, asked only where there
   * is a finite receiver, with the lights, what reads receivers and `ivec2 shadowSelectPixel` at hand.
   */
  void Start(vtkShadowFrame& frame, vtkShadowReceivers& receivers, const std::string& GLSL,
    const std::function<void(vtkShaderProgram*)>& setParameters = nullptr);
  /** Those that were chosen, in order; valid until the next Start: the memory is kept. */
  const std::vector<Pixel>& Finish();

  std::size_t GetBytes() const { return this->Bytes; }
  void Release();

private:
  unsigned int VertexArray = 0;
  unsigned int Buffer = 0;
  unsigned int Query = 0;
  std::size_t Bytes = 0;
  bool Pending = false;
  std::vector<Pixel> Pixels;
};

#endif
