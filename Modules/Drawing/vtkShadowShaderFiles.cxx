// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowShaderFiles.h"

#include "vtkObject.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <cstdlib>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>

namespace
{
void WriteOne(vtkShader* shader, const std::string& start, const char* kind)
{
  const std::string text = shader ? shader->GetSource() : "";
  if (text.empty())
  {
    return;
  }
  std::ostringstream path;
  path << start << "-" << std::hex << std::hash<std::string>()(text) << kind;
  static std::set<std::string> written;
  if (!written.insert(path.str()).second)
  {
    return;
  }
  std::ofstream file(path.str());
  file << text;
  file.flush();
  if (!file)
  {
    vtkGenericWarningMacro("SOFTSHADOWS_SHADERS: cannot write " << path.str() << ".");
  }
}
}

//------------------------------------------------------------------------------
void vtkShadowShaderFiles::Write(vtkShaderProgram* program, const std::string& name)
{
  static const char* const folder = std::getenv("SOFTSHADOWS_SHADERS");
  if (!folder || !*folder || !program)
  {
    return;
  }
  const std::string start = std::string(folder) + "/" + name;
  WriteOne(program->GetVertexShader(), start, ".vert");
  WriteOne(program->GetGeometryShader(), start, ".geom");
  WriteOne(program->GetFragmentShader(), start, ".frag");
}
