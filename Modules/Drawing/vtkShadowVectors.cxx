// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVectors.h"

#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
void vtkShadowVectors::Update(vtkOpenGLRenderWindow* window, bool few)
{
  this->Few = few;
  if (few)
  {
    this->Buffer.Release(window);
  }
  else
  {
    this->Buffer.UploadBuffer(window, this->Values);
  }
}

//------------------------------------------------------------------------------
void vtkShadowVectors::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->Few)
  {
    this->Buffer.Activate(window);
  }
}

//------------------------------------------------------------------------------
void vtkShadowVectors::SetParameter(vtkShaderProgram* program, const char* name)
{
  if (!this->Few)
  {
    program->SetUniformi(name, this->Buffer.GetUnit());
  }
  else if (!this->Values.empty())
  {
    program->SetUniform4fv(name, static_cast<int>(this->Values.size()),
      reinterpret_cast<const float(*)[4]>(this->Values.data()));
  }
}
