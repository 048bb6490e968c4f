// SPDX-License-Identifier: BSD-3-Clause
// Vertices of a technique's own, with attributes of floats, and their drawing.

#ifndef vtkShadowVertices_h
#define vtkShadowVertices_h

#include "vtkNew.h"                      // For the buffer
#include "vtkOpenGLBufferObject.h"       // For the buffer
#include "vtkShadowPrograms.h"           // For programs
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowVertices
{
public:
  /** An input of the vertex shader. */
  struct Attribute
  {
    std::string Name;
    int Components;
  };

  /** Replace them: for each vertex its attributes' floats, one after another. */
  void Upload(const std::vector<float>& values, const std::vector<Attribute>& attributes);

  /** Draw some, as a primitive type of OpenGL's, into the bound framebuffer. */
  void Draw(vtkOpenGLRenderWindow* window, unsigned int primitive, std::size_t first,
    std::size_t count, const vtkShadowPrograms::Sources& sources,
    const std::function<void(vtkShaderProgram*)>& setParameters);

  std::size_t GetCount() const { return this->Count; }
  std::size_t GetBytes() const { return this->Bytes; }
  void Release();

private:
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkShadowPrograms Programs;
  std::vector<Attribute> Attributes;
  std::size_t Stride = 0; // bytes of a vertex
  std::size_t Count = 0;
  std::size_t Bytes = 0;
  unsigned long Version = 0;
};

#endif
