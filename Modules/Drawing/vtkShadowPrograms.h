// SPDX-License-Identifier: BSD-3-Clause
// Shader programs, each with the vertex array that is bound to its attributes. They are found by where the
// texts of their shaders lie, which are constants, and by what is defined for them: to hash the texts for
// each draw call can take longer than the draw.

#ifndef vtkShadowPrograms_h
#define vtkShadowPrograms_h

#include "vtkNew.h"                      // For vertex arrays
#include "vtkOpenGLVertexArrayObject.h"  // For vertex arrays
#include "vtkShaderProgram.h"            // For programs
#include "vtkSmartPointer.h"             // For programs
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <functional>
#include <map>
#include <string>
#include <tuple>

class vtkOpenGLRenderWindow;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowPrograms
{
public:
  /** Constants: texts that neither change nor go before the programs. nullptr: no geometry shader. */
  struct Sources
  {
    const char* Vertex = nullptr;
    const char* Geometry = nullptr;
    const char* Fragment = nullptr;
    /** What the fragment shader begins with, for constants that choose among its variants. */
    std::string Definitions;
    /** Another variant of the same texts, which `change` makes. */
    bool Variant = false;
  };
  struct Program
  {
    vtkSmartPointer<vtkShaderProgram> Shaders;
    vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
    unsigned long Version = 0; // of the buffers that it is bound to, 0 of none
  };
  using Change = std::function<void(std::string& vertex, std::string& fragment)>;

  vtkShadowPrograms() = default;
  vtkShadowPrograms(const vtkShadowPrograms&) = delete;
  void operator=(const vtkShadowPrograms&) = delete;

  /**
   * A program, in use, with its vertex array bound; made if it is the first time, by texts that `change`
   * changes. nullptr where it does not compile: VTK has said why.
   */
  Program* Use(
    vtkOpenGLRenderWindow* window, const Sources& sources, const Change& change = nullptr);
  void Release();

private:
  using Key = std::tuple<const char*, const char*, const char*, std::string, bool>;
  std::map<Key, Program> Programs;
};

#endif
