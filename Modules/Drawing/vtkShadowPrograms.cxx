// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowPrograms.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShadowShaderFiles.h"

//------------------------------------------------------------------------------
vtkShadowPrograms::Program* vtkShadowPrograms::Use(
  vtkOpenGLRenderWindow* window, const Sources& sources, const Change& change)
{
  Program& program = this->Programs[Key(
    sources.Vertex, sources.Geometry, sources.Fragment, sources.Definitions, sources.Variant)];
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (!program.Shaders)
  {
    std::string vertex = sources.Vertex;
    std::string fragment = sources.Fragment;
    if (!sources.Definitions.empty())
    {
      vtkShaderProgram::Substitute(
        fragment, "//VTK::Output::Dec", sources.Definitions + "//VTK::Output::Dec");
    }
    if (change)
    {
      change(vertex, fragment);
    }
    program.Shaders = cache->ReadyShaderProgram(
      vertex.c_str(), fragment.c_str(), sources.Geometry ? sources.Geometry : "");
    vtkShadowShaderFiles::Write(program.Shaders, "casters");
  }
  else if (!cache->ReadyShaderProgram(program.Shaders))
  {
    return nullptr;
  }
  if (!program.Shaders)
  {
    return nullptr;
  }
  program.VertexArray->Bind();
  return &program;
}

//------------------------------------------------------------------------------
void vtkShadowPrograms::Release()
{
  for (auto& entry : this->Programs)
  {
    entry.second.VertexArray->ReleaseGraphicsResources();
  }
  this->Programs.clear();
}
