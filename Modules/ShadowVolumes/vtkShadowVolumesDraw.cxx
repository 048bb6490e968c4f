// SPDX-License-Identifier: BSD-3-Clause
// The drawing side of vtkShadowVolumes: extrusion, counting, the debug view.

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPenumbraLightFS.h"
#include "vtkPenumbraLines.h"
#include "vtkPenumbraSidesFS.h"
#include "vtkPenumbraSidesGS.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterDrawing.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowVolumeCapVS.h"
#include "vtkShadowVolumeCountFS.h"
#include "vtkShadowVolumeDepthFS.h"
#include "vtkShadowVolumeResolveFS.h"
#include "vtkShadowVolumeSidesGS.h"
#include "vtkShadowVolumeViewFS.h"
#include "vtkShadowVolumes.h"
#include "vtkVisibilityBuffer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace
{
/**
 * What a side seen from within is moved back, as a share of its depth near / distance: what rounding
 * does to positions, see shadowRounding in vtkShadowLightsFS.glsl. Of a depth that is an even share of
 * the clipping range, in a parallel view, it is a step of its 24 bits.
 */
constexpr float BackShare = static_cast<float>(2.0 * vtkShadowView::PositionRounding);
constexpr float BackStep = 1.0f / 16777216.0f;

/** Faces are drawn from both sides, nothing but the count is written. */
class CountingState
{
public:
  CountingState(vtkOpenGLState* state, bool color)
    : DepthMask(state)
    , DepthFunc(state)
    , ColorMask(state)
    , BlendFunc(state)
    , DepthTest(state, GL_DEPTH_TEST)
    , CullFace(state, GL_CULL_FACE)
    , StencilTest(state, GL_STENCIL_TEST)
    , Blend(state, GL_BLEND)
  {
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglColorMask(color, color, color, color);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_STENCIL_TEST);
    state->vtkglDisable(GL_BLEND);
  }

private:
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglBlendFuncSeparate BlendFunc;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
  vtkOpenGLState::ScopedglEnableDisable StencilTest;
  vtkOpenGLState::ScopedglEnableDisable Blend;
};
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::SetExtrusion(vtkShaderProgram* program, const vtkShadowCaster& caster,
  const glm::dvec4& place, const glm::dmat4& matrix) const
{
  // What is far from the light is keep x vertex - light, in clip coordinates: at infinity, keep is 1
  // and the light its position, or keep 0 and the light the direction to it.
  const bool positional = place.w != 0.0;
  glm::dvec4 light = matrix * place;
  double keep = positional ? 1.0 : 0.0;
  if (this->Parallel)
  {
    // Far enough to leave the picture: by scaling the caster about the light until it is further
    // away than all that is seen, or by moving it as far along the direction.
    double radius = 0.0; // of the box, which holds whatever the matrix shears
    const glm::dvec3 middle = 0.5 * (caster.Corners[0] + caster.Corners[7]);
    for (const auto& corner : caster.Corners)
    {
      radius = std::max(radius, glm::length(corner - middle));
    }
    double reach = 0.0;
    const glm::dvec3 from = positional ? glm::dvec3(place) : middle;
    for (const auto& corner : this->FrustumCorners)
    {
      reach = std::max(reach, glm::length(corner - from));
    }
    if (positional)
    {
      const double gap = glm::length(middle - from) - radius;
      light *= 1.0 - std::min(1.0, std::max(0.9 * gap / reach, 1e-6));
    }
    else
    {
      keep = 0.5 / (reach + radius);
    }
  }
  const glm::vec4 lightDC(light);
  program->SetUniform4f("shadowLightDC", glm::value_ptr(lightDC));
  program->SetUniformf("shadowKeep", static_cast<float>(keep));
}

//------------------------------------------------------------------------------
glm::vec2 vtkShadowVolumes::GetRetreat() const
{
  if (this->ClipControl && !this->Parallel)
  {
    return { BackShare, 0.0f };
  }
  return { 0.0f, this->ClipControl ? BackStep : 2.0f * BackStep };
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::DrawSides(vtkShadowFrame& frame, const glm::dvec4& place,
  const Selection& selection, const std::vector<vtkShadowCasterPart>& parts, bool counted,
  const char* shader, const std::function<void(vtkShaderProgram*)>& setParameters)
{
  vtkShadowCasterDraw how;
  how.GeometryShader = vtkShadowVolumeSidesGS;
  how.FragmentShader = shader;
  // Over the picture, for the debug view, nothing is counted.
  const glm::dmat4& matrix = counted ? this->SWCToDraw : this->SWCToClip;
  how.SetParameters = [&](vtkShaderProgram* program)
  {
    const glm::vec2 back = counted ? this->GetRetreat() : glm::vec2(0.0f);
    program->SetUniform2f("shadowRetreat", glm::value_ptr(back));
    program->SetUniformf("shadowFacing", this->Mirrored ? -1.0f : 1.0f);
    if (setParameters)
    {
      setParameters(program);
    }
  };
  how.SetCasterParameters = [&](vtkShaderProgram* program, const vtkShadowCaster& caster)
  { this->SetExtrusion(program, caster, place, matrix); };
  frame.Drawing->DrawParts(frame.Window, matrix, GL_LINES, selection.Lines->Lines, parts, how);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::DrawCaps(vtkShadowFrame& frame, const glm::dvec4& place, const char* shader,
  const std::function<void(vtkShaderProgram*)>& setParameters)
{
  for (const bool far : { false, true })
  {
    vtkShadowCasterDraw how;
    how.VertexShader = vtkShadowVolumeCapVS;
    how.FragmentShader = shader;
    how.SetParameters = [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowFar", far ? 1 : 0);
      const glm::vec2 back = this->GetRetreat();
      program->SetUniform2f("shadowRetreat", glm::value_ptr(back));
      if (setParameters)
      {
        setParameters(program);
      }
    };
    how.SetCasterParameters = [&](vtkShaderProgram* program, const vtkShadowCaster& caster)
    { this->SetExtrusion(program, caster, place, this->SWCToDraw); };
    // The near cap lies in surfaces that the light may reach: it counts as behind them, by the
    // depth's own steps and the face's slope. The far cap is the same faces from behind.
    (far ? glDisable : glEnable)(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(far ? 0.0f : -1.0f, far ? 0.0f : -1.0f);
    this->SetFrontFace(far);
    frame.Drawing->DrawParts(
      frame.Window, this->SWCToDraw, GL_TRIANGLES, this->Caps, this->CapParts, how);
  }
  this->SetFrontFace(false);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::SetFrontFace(bool reversed) const
{
  glFrontFace(this->Mirrored != reversed ? GL_CW : GL_CCW);
}

//------------------------------------------------------------------------------
template <typename SetCounter>
void vtkShadowVolumes::DrawVolumes(vtkShadowFrame& frame, const glm::dvec4& place,
  const Selection& selection, const char* shader, SetCounter setCounter, const Sides& sides)
{
  vtkOpenGLState* state = frame.Window->GetState();
  const auto drawSides = [&](const std::vector<vtkShadowCasterPart>& parts, GLenum depth,
                           const std::function<void(vtkShaderProgram*)>& setParameters)
  {
    state->vtkglDepthFunc(sides ? GL_ALWAYS : depth);
    sides ? sides(parts, setParameters)
          : this->DrawSides(frame, place, selection, parts, true, shader, setParameters);
    state->vtkglDepthFunc(depth);
  };
  this->SetFrontFace(false);
  if (this->ClipControl)
  {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  }
  if (!selection.ZPass.empty())
  {
    // In front of the surface: +1 where a volume is entered, -1 where it is left.
    drawSides(selection.ZPass, GL_GREATER, setCounter(true));
  }
  if (!selection.ZFail.empty())
  {
    // Behind it the other way round, clamped so that no end of the depth range cuts a volume open.
    glEnable(GL_DEPTH_CLAMP);
    const auto setParameters = setCounter(false);
    drawSides(selection.ZFail, GL_LEQUAL, setParameters);
    this->DrawCaps(frame, place, shader, setParameters);
    glDisable(GL_DEPTH_CLAMP);
  }
  if (this->ClipControl)
  {
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  }
  glFrontFace(GL_CCW);
}

//------------------------------------------------------------------------------
bool vtkShadowVolumes::UpdateDepth(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  if (!this->Depth.Allocate(frame.Window, vtkShadowTexture::Format::DepthStencil, buffer.GetWidth(),
        buffer.GetHeight(), 1))
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkShadowFramebuffer::Scope target(
    frame.Window, buffer.GetFramebuffer(), nullptr, &this->Depth, 0);
  const CountingState drawing(state, false);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_ALWAYS);
  buffer.GetReceivers().GetTexture().Activate(frame.Window);
  const glm::vec4 depthRow(this->DepthRow);
  const glm::vec4 wRow(this->WRow);
  frame.Quad->Draw(frame.Window, vtkShadowVolumeDepthFS,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowReceivers", buffer.GetReceivers().GetTexture().GetUnit());
      program->SetUniform4f("shadowDepthRow", glm::value_ptr(depthRow));
      program->SetUniform4f("shadowWRow", glm::value_ptr(wRow));
    });
  buffer.GetReceivers().GetTexture().Deactivate(frame.Window);
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumes::Subtract(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int light, int sample)
{
  const glm::dvec4& place = this->Silhouettes.GetPlace(light, sample);
  Selection selection = this->Select(frame, light, sample);
  if (selection.ZPass.empty() && selection.ZFail.empty())
  {
    return true;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  const bool wide = selection.Wide;
  selection.Wide = wide && this->Counts.Allocate(frame.Window, vtkShadowTexture::Format::Float1,
                             buffer.GetWidth(), buffer.GetHeight(), 1);
  if (selection.Wide)
  {
    vtkShadowFramebuffer::Scope target(
      frame.Window, buffer.GetFramebuffer(), &this->Counts, &this->Depth, 0);
    CountingState counting(state, true);
    const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, none);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    this->DrawVolumes(frame, place, selection, vtkShadowVolumeCountFS,
      [](bool passing)
      {
        return [passing](vtkShaderProgram* program)
        {
          program->SetUniformf("shadowFront", passing ? 1.0f : -1.0f);
          program->SetUniformf("shadowBack", passing ? -1.0f : 1.0f);
        };
      });
  }
  vtkShadowFramebuffer::Scope target(
    frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), &this->Depth, light);
  CountingState counting(state, false);
  if (!selection.Wide)
  {
    const GLint zero = 0;
    state->vtkglStencilMask(0xFF);
    glClearBufferiv(GL_STENCIL, 0, &zero);
    state->vtkglEnable(GL_STENCIL_TEST);
    state->vtkglStencilFunc(GL_ALWAYS, 0, 0xFF);
    this->DrawVolumes(frame, place, selection, nullptr,
      [this, state](bool passing) -> std::function<void(vtkShaderProgram*)>
      {
        const bool parity = this->Method == vtkShadowVolumeSettings::Counting::Xor;
        const GLenum enter = parity ? GL_INVERT : (passing ? GL_INCR_WRAP : GL_DECR_WRAP);
        const GLenum leave = parity ? GL_INVERT : (passing ? GL_DECR_WRAP : GL_INCR_WRAP);
        state->vtkglStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, enter);
        state->vtkglStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, leave);
        return {};
      });
    state->vtkglStencilFunc(GL_NOTEQUAL, 0, 0xFF);
    state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  std::string source = vtkShadowVolumeResolveFS;
  if (selection.Wide)
  {
    vtkShaderProgram::Substitute(
      source, "//VTK::Output::Dec", "#define SHADOW_WIDE\n//VTK::Output::Dec");
    this->Counts.Activate(frame.Window);
  }
  const glm::vec3 weight(this->Silhouettes.GetSamples(light)[sample].Weight);
  frame.Quad->Draw(frame.Window, source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniform3f("shadowWeight", glm::value_ptr(weight));
      if (selection.Wide)
      {
        program->SetUniformi("shadowCounts", this->Counts.GetUnit());
      }
    });
  this->Counts.Deactivate(frame.Window);
  state->vtkglStencilFunc(GL_ALWAYS, 0, 0xFF);
  return wide == selection.Wide;
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::AddCounts(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  const vtkShadowTexture& target, int layer, int part, int sample, vtkPenumbraLines& lines,
  const std::vector<int>* some)
{
  const glm::dvec4& place = this->Silhouettes.GetPlace(part, sample);
  std::vector<vtkShadowCasterPart> parts;
  for (std::size_t i = 0; i < (some ? some->size() : lines.GetParts().size()); ++i)
  {
    parts.push_back(lines.GetParts()[some ? static_cast<std::size_t>((*some)[i]) : i]);
  }
  const Selection selection = this->Select(frame, part, sample, &parts);
  if (selection.ZPass.empty() && selection.ZFail.empty())
  {
    return;
  }
  vtkShadowFramebuffer::Scope scope(
    frame.Window, buffer.GetFramebuffer(), &target, &this->Depth, layer);
  vtkOpenGLState* state = frame.Window->GetState();
  CountingState counting(state, true);
  state->vtkglColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
  receivers.Activate(frame.Window);
  vtkShadowTexture& planes = lines.GetPlanes();
  planes.Activate(frame.Window);
  bool passing = true;
  glm::mat4 VCToSWC(frame.VCToSWC);
  vtkShadowCasterDraw how;
  how.GeometryShader = vtkPenumbraSidesGS;
  how.FragmentShader = vtkPenumbraSidesFS;
  how.Definitions = frame.GetLightsGLSL("#define SHADOW_WEDGE_SHAPE 3\n") +
                    vtkShadowReceivers::GetGLSL() + vtkPenumbraLightFS;
  how.SetParameters = [&](vtkShaderProgram* program)
  {
    program->SetUniformi("shadowReceivers", receivers.GetUnit());
    program->SetUniformi("shadowPlanes", planes.GetUnit());
    program->SetUniformi("shadowPassing", passing);
    program->SetUniformMatrix4x4("shadowVCToSWC", glm::value_ptr(VCToSWC));
  };
  how.SetCasterParameters = [&](vtkShaderProgram* program, const vtkShadowCaster& caster)
  { this->SetExtrusion(program, caster, place, this->SWCToDraw); };
  how.SetPartParameters = [](vtkShaderProgram* program, const vtkShadowCasterPart& linesOfPart)
  {
    program->SetUniformi("shadowFirstLine", static_cast<int>(linesOfPart.First / 2));
    program->SetUniformi("shadowWidth", vtkPenumbraLines::Width);
  };
  this->DrawVolumes(
    frame, place, selection, vtkShadowVolumeCountFS,
    [&](bool zPass)
    {
      passing = zPass;
      return [](vtkShaderProgram* program) // of caps
      {
        program->SetUniformf("shadowFront", -1.0f);
        program->SetUniformf("shadowBack", 1.0f);
      };
    },
    [&](
      const std::vector<vtkShadowCasterPart>& drawn, const std::function<void(vtkShaderProgram*)>&)
    {
      frame.Drawing->DrawParts(
        frame.Window, this->SWCToDraw, GL_LINES, lines.GetBuffer(), drawn, how);
    });
  planes.Deactivate(frame.Window);
  receivers.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::AddBehind(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  const std::vector<const vtkShadowTexture*>& targets, int layer,
  const std::function<void(const glm::dmat4& SWCToDraw, float farthest, const glm::vec2& retreat)>&
    draw,
  bool outlines)
{
  vtkShadowFramebuffer::Scope scope(
    frame.Window, buffer.GetFramebuffer(), targets, &this->Depth, layer);
  vtkOpenGLState* state = frame.Window->GetState();
  CountingState adding(state, true);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(GL_FRONT);
  this->SetFrontFace(false);
  if (this->ClipControl)
  {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  }
  glEnable(GL_DEPTH_CLAMP);
  if (outlines)
  {
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDepthFunc(GL_GEQUAL);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  }
  draw(this->SWCToDraw, this->ClipControl ? 0.0f : -1.0f, this->GetRetreat());
  if (outlines)
  {
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  }
  glDisable(GL_DEPTH_CLAMP);
  if (this->ClipControl)
  {
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  }
  glFrontFace(GL_CCW);
  state->vtkglCullFace(GL_BACK);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::AddFaces(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int light, int sample)
{
  const Selection selection = this->Select(frame, light, sample);
  vtkShadowFramebuffer::Scope target(
    frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, light);
  vtkOpenGLState* state = frame.Window->GetState();
  CountingState counting(state, true);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->DrawVolumes(frame, this->Silhouettes.GetPlace(light, sample), selection,
    vtkShadowVolumeCountFS,
    [](bool)
    {
      return [](vtkShaderProgram* program)
      {
        program->SetUniformf("shadowFront", 1.0f);
        program->SetUniformf("shadowBack", 1.0f);
      };
    });
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::DrawView(vtkShadowFrame& frame, int light, int sample)
{
  const glm::dvec4& place = this->Silhouettes.GetPlace(light, sample);
  const Selection selection = this->Select(frame, light, sample);
  vtkOpenGLState* state = frame.Window->GetState();
  CountingState drawing(state, true);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  this->SetFrontFace(false);
  glEnable(GL_DEPTH_CLAMP);
  const auto setColors = [](const glm::vec4& front, const glm::vec4& back)
  {
    return [front, back](vtkShaderProgram* program)
    {
      program->SetUniform4f("shadowFrontColor", glm::value_ptr(front));
      program->SetUniform4f("shadowBackColor", glm::value_ptr(back));
    };
  };
  for (const auto* parts : { &selection.ZPass, &selection.ZFail })
  {
    this->DrawSides(frame, place, selection, *parts, false, vtkShadowVolumeViewFS,
      setColors({ 0.2f, 0.4f, 1.0f, 0.2f }, { 1.0f, 0.5f, 0.1f, 0.2f }));
    vtkShadowCasterDraw how;
    how.FragmentShader = vtkShadowVolumeViewFS;
    how.SetParameters = setColors({ 1.0f, 1.0f, 0.2f, 1.0f }, { 1.0f, 1.0f, 0.2f, 1.0f });
    frame.Drawing->DrawParts(
      frame.Window, this->SWCToClip, GL_LINES, selection.Lines->Lines, *parts, how);
  }
  glDisable(GL_DEPTH_CLAMP);
  glFrontFace(GL_CCW);
}
