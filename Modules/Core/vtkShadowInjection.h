// SPDX-License-Identifier: BSD-3-Clause
// The text work of injecting visibility into VTK's shaders: see architecture.md.

#ifndef vtkShadowInjection_h
#define vtkShadowInjection_h

#include <string>
#include <vector>

namespace vtkShadowInjection
{
/** A program's sources; the geometry shader's is empty where there is none. */
struct Shaders
{
  std::string& Vertex;
  std::string& Geometry;
  std::string& Fragment;
};

/** Leave marks where the code goes, before the mapper replaces its own. */
void Mark(const Shaders& shaders);

/** What is injected. */
struct Code
{
  std::string Declarations;
  std::vector<std::vector<int>> LightsOfSlot; // N of lightColorN to the parts of a casting light
  bool Receivers = false;                     // the shader can write receivers
  bool Shading = false;                       // the shader can multiply lights
  bool Unrolled = false;                      // each light's code is there for itself
  bool Rigid = true;                          // VTK's view coordinates are VC: see vtkShadowView
  bool Smooth = false; // receivers rise to the surface that their normals stand for

  /** All parts of all casting lights. */
  std::size_t GetNumberOfLights() const;
  bool operator==(const Code& other) const;
};

/**
 * Put the code at the marks, and multiply the lights' colours, once the mapper is done. Where the
 * user has taken VTK's lighting out, or uses a light's colour before it, the code goes before the
 * first use. `later` is what the user's replacements put there afterwards.
 * A catcher's lights are turned to their brightness, with and without shadow, in red and green, and
 * its colour at the end to black of an alpha that tells their ratio.
 * Gives what keeps a light's colour, or all, from being shadowed, as a clause; empty if nothing.
 */
std::string Fill(
  const Shaders& shaders, const Code& code, bool catches, const std::string& later = "");

/** Whether a fragment shader that is all the user's can tell what it receives. */
bool CanFill(const std::string& fragmentShader);
}

#endif
