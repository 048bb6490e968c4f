// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVertices.h"

#include "vtkShadowOpenGL.h"
#include "vtkType.h"

//------------------------------------------------------------------------------
void vtkShadowVertices::Upload(
  const std::vector<float>& values, const std::vector<Attribute>& attributes)
{
  this->Attributes = attributes;
  this->Stride = 0;
  for (const auto& attribute : attributes)
  {
    this->Stride += attribute.Components * sizeof(float);
  }
  this->Bytes = values.size() * sizeof(float);
  this->Count = this->Stride > 0 ? this->Bytes / this->Stride : 0;
  this->Buffer->Upload(values, vtkOpenGLBufferObject::ArrayBuffer);
  ++this->Version;
}

//------------------------------------------------------------------------------
void vtkShadowVertices::Draw(vtkOpenGLRenderWindow* window, unsigned int primitive,
  std::size_t first, std::size_t count, const vtkShadowPrograms::Sources& sources,
  const std::function<void(vtkShaderProgram*)>& setParameters)
{
  vtkShadowPrograms::Program* program = count > 0 ? this->Programs.Use(window, sources) : nullptr;
  if (!program)
  {
    return;
  }
  if (program->Version != this->Version)
  {
    program->VertexArray->ShaderProgramChanged(); // attributes are to be bound anew
    program->VertexArray->Bind();
    int offset = 0;
    for (const auto& attribute : this->Attributes)
    {
      program->VertexArray->AddAttributeArray(program->Shaders, this->Buffer, attribute.Name,
        offset, this->Stride, VTK_FLOAT, attribute.Components, false);
      offset += static_cast<int>(attribute.Components * sizeof(float));
    }
    program->Version = this->Version;
  }
  if (setParameters)
  {
    setParameters(program->Shaders);
    program->VertexArray->Bind(); // whatever that bound
  }
  glDrawArrays(primitive, static_cast<GLint>(first), static_cast<GLsizei>(count));
  program->VertexArray->Release();
}

//------------------------------------------------------------------------------
void vtkShadowVertices::Release()
{
  this->Programs.Release();
  this->Buffer->ReleaseGraphicsResources();
  this->Count = this->Bytes = 0;
}
