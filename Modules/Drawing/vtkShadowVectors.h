// SPDX-License-Identifier: BSD-3-Clause
// Vectors that a technique's GLSL reads by number: uniforms if they are few, else a buffer texture.
//
//   vectors  uniform vec4 name[N], or RGBA32F buffer (samplerBuffer name), 16 bytes each

#ifndef vtkShadowVectors_h
#define vtkShadowVectors_h

#include "vtkShadowGL.h"                 // For the buffer
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowVectors
{
public:
  /** To be filled; then Update. */
  std::vector<glm::vec4>& Get() { return this->Values; }
  /** Uploads them if they are not few. */
  void Update(vtkOpenGLRenderWindow* window, bool few);
  std::size_t GetCount() const { return this->Values.size(); }
  bool AreFew() const { return this->Few; }

  ///@{ Around drawing, and for each program that reads them under a name.
  void Activate(vtkOpenGLRenderWindow* window);
  void Deactivate(vtkOpenGLRenderWindow* window) { this->Buffer.Deactivate(window); }
  void SetParameter(vtkShaderProgram* program, const char* name);
  ///@}

  std::size_t GetBytes() const { return this->Buffer.GetBytes(); }
  void Release(vtkOpenGLRenderWindow* window) { this->Buffer.Release(window); }

private:
  std::vector<glm::vec4> Values;
  bool Few = true;
  vtkShadowTexture Buffer;
};

#endif
