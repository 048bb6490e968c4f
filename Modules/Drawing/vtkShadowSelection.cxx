// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSelection.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowSelectionGS.h"
#include "vtkShadowSelectionVS.h"
#include "vtkShadowShaderFiles.h"
#include "vtkSmartPointer.h"
#include "vtkTransformFeedback.h"

namespace
{
/** A vertex each costs a software rasterizer far more than what is asked of it. */
constexpr int PixelsOfVertex = 16;

/** Names of what is captured, as VTK wants them: always one object, or it links the program anew. */
vtkTransformFeedback* GetCaptured()
{
  static const auto captured = []
  {
    auto made = vtkSmartPointer<vtkTransformFeedback>::New();
    made->AddVarying(
      vtkTransformFeedback::Color_RGBA_F, "selectedTexel"); // roles mean nothing here
    made->AddVarying(vtkTransformFeedback::Normal_F, "selectedPixel");
    return made;
  }();
  return captured;
}
}

//------------------------------------------------------------------------------
void vtkShadowSelection::Start(vtkShadowFrame& frame, vtkShadowReceivers& receivers,
  const std::string& GLSL, const std::function<void(vtkShaderProgram*)>& setParameters)
{
  this->Pending = false;
  this->Pixels.clear();
  const std::string pixels = std::to_string(PixelsOfVertex);
  std::string vertex = vtkShadowSelectionVS;
  std::string geometry = vtkShadowSelectionGS;
  vtkShaderProgram::Substitute(vertex, "SHADOW_PIXELS", pixels);
  vtkShaderProgram::Substitute(geometry, "SHADOW_PIXELS", pixels);
  vtkShaderProgram::Substitute(geometry, "//SHADOW::Declarations",
    frame.GetLightsGLSL() + vtkShadowReceivers::GetGLSL() + GLSL);
  vtkShaderProgram* program = frame.Window->GetShaderCache()->ReadyShaderProgram(
    vertex.c_str(), "//VTK::System::Dec\nvoid main() {}\n", geometry.c_str(), GetCaptured());
  if (!program)
  {
    return;
  }
  vtkShadowShaderFiles::Write(program, "selection");
  if (!this->Buffer)
  {
    glGenVertexArrays(1, &this->VertexArray);
    glGenBuffers(1, &this->Buffer);
    glGenQueries(1, &this->Query);
  }
  const GLsizei count = receivers.GetWidth() * receivers.GetHeight();
  const std::size_t bytes = sizeof(Pixel) * static_cast<std::size_t>(count);
  glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, this->Buffer);
  if (bytes != this->Bytes)
  {
    glBufferData(
      GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_READ);
    this->Bytes = bytes;
  }
  vtkShadowTexture& texture = receivers.GetTexture();
  texture.Activate(frame.Window);
  program->SetUniformi("shadowReceivers", texture.GetUnit());
  frame.SetLights(program);
  if (setParameters)
  {
    setParameters(program);
  }
  glBindVertexArray(this->VertexArray);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, this->Buffer);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, this->Query);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, (count + PixelsOfVertex - 1) / PixelsOfVertex);
  glEndTransformFeedback();
  glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
  glDisable(GL_RASTERIZER_DISCARD);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
  glBindVertexArray(0);
  texture.Deactivate(frame.Window);
  this->Pending = true;
}

//------------------------------------------------------------------------------
const std::vector<vtkShadowSelection::Pixel>& vtkShadowSelection::Finish()
{
  if (this->Pending)
  {
    GLuint count = 0;
    glGetQueryObjectuiv(this->Query, GL_QUERY_RESULT, &count);
    this->Pixels.resize(count);
    glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, this->Buffer);
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0,
      static_cast<GLsizeiptr>(count * sizeof(Pixel)), this->Pixels.data());
    glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    this->Pending = false;
  }
  return this->Pixels;
}

//------------------------------------------------------------------------------
void vtkShadowSelection::Release()
{
  if (this->Buffer)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    glDeleteBuffers(1, &this->Buffer);
    glDeleteQueries(1, &this->Query);
    this->VertexArray = this->Buffer = this->Query = 0;
  }
  this->Bytes = 0;
  this->Pending = false;
  std::vector<Pixel>().swap(this->Pixels);
}
