// SPDX-License-Identifier: BSD-3-Clause
// Some of a picture's receivers, chosen on the GPU and read back by themselves: for rays, and for whatever
// else the CPU does for a few pixels.
//
//   selected  buffer  20 bytes a pixel of the picture: texel of the receiver, number of the pixel
//
// Start leaves the GPU to its work; Finish waits for it. In between, both are free.

#ifndef vtkShadowSelection_h
#define vtkShadowSelection_h

#include "vtkSmartPointer.h"             // For what is captured
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/vec4.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

class vtkShaderProgram;
class vtkShadowReceivers;
class vtkTransformFeedback;
struct vtkShadowFrame;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowSelection
{
public:
  struct Pixel
  {
    glm::vec4 Receiver; // see vtkShadowReceivers
    float Number;       // row by row from the bottom; whole
  };

  vtkShadowSelection();
  ~vtkShadowSelection();
  vtkShadowSelection(const vtkShadowSelection&) = delete;
  void operator=(const vtkShadowSelection&) = delete;

  /**
   * Choose the pixels where GLSL gives true: `bool shadowSelect(vec4 receiverVC)`, asked only where there
   * is a finite receiver, with the lights and what reads receivers at hand.
   */
  void Start(vtkShadowFrame& frame, vtkShadowReceivers& receivers, const std::string& GLSL,
    const std::function<void(vtkShaderProgram*)>& setParameters = nullptr);
  /** Those that were chosen, in order; valid until the next Start: the memory is kept. */
  const std::vector<Pixel>& Finish();

  std::size_t GetBytes() const { return this->Bytes; }
  void Release();

private:
  /** Names of what is captured; always the same object, or VTK would link the program anew. */
  vtkSmartPointer<vtkTransformFeedback> Captured;
  unsigned int VertexArray = 0;
  unsigned int Buffer = 0;
  unsigned int Query = 0;
  std::size_t Bytes = 0;
  bool Pending = false;
  std::vector<Pixel> Pixels;
};

#endif
