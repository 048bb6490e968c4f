// The text work of injecting visibility into VTK's shaders: see ARCHITECTURE.md, "Injection".

#ifndef vtkShadowInjection_h
#define vtkShadowInjection_h

#include <string>
#include <vector>

namespace vtkShadowInjection
{
/** Leave marks where the code goes, before the mapper replaces its own. */
void Mark(std::string& fragmentShader);

/** What is injected. */
struct Code
{
  std::string Declarations;
  std::vector<int> LightOfSlot; // N of lightColorN to a casting light, or -1
  bool Receivers = false;       // the shader can write receivers
  bool Shading = false;         // the shader can multiply lights

  bool operator==(const Code& other) const;
};

/** Put the code at the marks, and multiply the lights' colours, once the mapper is done. */
void Fill(std::string& fragmentShader, const Code& code);

/** The fragment shader that evaluates the technique's GLSL in screen space. */
std::string GetEvaluation(const std::string& preamble, const std::string& visibilityGLSL);
}

#endif
