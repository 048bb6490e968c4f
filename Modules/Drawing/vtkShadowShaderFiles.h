// SPDX-License-Identifier: BSD-3-Clause
// Writes the shaders as they are compiled, for who wants to read them: into the folder that the
// environment variable SOFTSHADOWS_SHADERS names, which is there. Without it nothing is done.
//
//   NAME-HASH.vert, .geom, .frag   the same text is written once; the hash is the text's

#ifndef vtkShadowShaderFiles_h
#define vtkShadowShaderFiles_h

#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <string>

class vtkShaderProgram;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowShaderFiles
{
public:
  static void Write(vtkShaderProgram* program, const std::string& name);
};

#endif
