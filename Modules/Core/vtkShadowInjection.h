// The text work of injecting visibility into VTK's shaders: see ARCHITECTURE.md, "Injection".

#ifndef vtkShadowInjection_h
#define vtkShadowInjection_h

#include <string>

namespace vtkShadowInjection
{
/** Leave marks where the code goes, before the mapper replaces its own. */
void Mark(std::string& fragmentShader);

/**
 * Put the code at the marks, and multiply each light's colour, once the mapper is done.
 * Declarations come from GetDeclarations.
 */
void Fill(std::string& fragmentShader, const std::string& declarations);

/** What the injected code declares: forward with the technique's GLSL, else reading the buffer. */
std::string GetDeclarations(
  const std::string& preamble, bool forward, const std::string& visibilityGLSL);

/** The fragment shader that evaluates the technique's GLSL in screen space. */
std::string GetEvaluation(const std::string& preamble, const std::string& visibilityGLSL);
}

#endif
