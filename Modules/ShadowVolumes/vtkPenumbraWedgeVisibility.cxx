// SPDX-License-Identifier: BSD-3-Clause
// How wedges and counts become visibility: the drawing side of vtkPenumbraWedgeTechnique.

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPenumbraAreaFS.h"
#include "vtkPenumbraCountFS.h"
#include "vtkPenumbraLoopsFS.h"
#include "vtkPenumbraSamplesFS.h"
#include "vtkPenumbraSumFS.h"
#include "vtkPenumbraWedgeTechnique.h"
#include "vtkPenumbraWedgeVS.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"
#include "vtkVisibilityBuffer.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <numeric>

namespace
{
/** So many loops are combined one by one; the rest, the shortest of the last casters, are one more. */
constexpr std::size_t MostLoops = 256;
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddWedges(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  const std::vector<const vtkShadowTexture*>& targets, int layer, int part,
  vtkPenumbraWedges& wedges, const char* shader, const std::string& definitions,
  const std::function<void(vtkShaderProgram*)>& setParameters, const std::vector<int>* some)
{
  const vtkShadowPrograms::Sources sources{ vtkPenumbraWedgeVS, nullptr, shader,
    frame.GetLightsGLSL(definitions) + vtkShadowReceivers::GetGLSL() + wedges.GetLightGLSL(),
    false };
  vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
  receivers.Activate(frame.Window);
  wedges.Activate(frame.Window);
  this->Volumes.AddBehind(
    frame, buffer, targets, layer,
    [&](const glm::dmat4& SWCToDraw, float farthest, const glm::vec2& retreat)
    {
      wedges.Draw(
        frame, this->Volumes, SWCToDraw, farthest, retreat, sources,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi("shadowReceivers", receivers.GetUnit());
          program->SetUniformi("shadowLight", part);
          frame.SetLights(program);
          if (setParameters)
          {
            setParameters(program);
          }
        },
        some);
    },
    buffer.GetQuantity() == "wedges");
  wedges.Deactivate(frame.Window);
  receivers.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::DrawOver(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  const vtkShadowTexture& target, int layer, bool adds, vtkShadowTexture& sums,
  const vtkPenumbraWedges& wedges, const char* shader, const std::string& definitions,
  const std::function<void(vtkShaderProgram*)>& setParameters)
{
  std::string source = shader;
  vtkShaderProgram::Substitute(source, "//VTK::Output::Dec",
    "//VTK::Output::Dec\n" + frame.GetLightsGLSL(definitions) + vtkShadowReceivers::GetGLSL() +
      wedges.GetLightGLSL());
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  vtkShadowFramebuffer::Scope scope(frame.Window, buffer.GetFramebuffer(), &target, nullptr, layer);
  state->vtkglDisable(GL_DEPTH_TEST);
  adds ? state->vtkglEnable(GL_BLEND) : state->vtkglDisable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
  receivers.Activate(frame.Window);
  wedges.Activate(frame.Window);
  sums.Activate(frame.Window);
  frame.Quad->Draw(frame.Window, source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowReceivers", receivers.GetUnit());
      program->SetUniformi("shadowSums", sums.GetUnit());
      wedges.SetLight(frame, program);
      setParameters(program);
    });
  sums.Deactivate(frame.Window);
  wedges.Deactivate(frame.Window);
  receivers.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::CountCentre(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  int part, int area, const std::vector<int>* some)
{
  {
    vtkShadowFramebuffer::Scope scope(
      frame.Window, buffer.GetFramebuffer(), &this->Sums, nullptr, 0);
    const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, none);
  }
  this->Volumes.AddCounts(
    frame, buffer, this->Sums, 0, part, area, this->Parts[part].Areas[area]->GetLines(), some);
}

//------------------------------------------------------------------------------
std::vector<std::vector<int>> vtkPenumbraWedgeTechnique::GetLoops(
  vtkShadowFrame& frame, int part, int area)
{
  const glm::dvec4& place = this->Volumes.GetSilhouettes().GetPlace(part, area);
  const auto& parts =
    vtkShadowSilhouetteCache::Get(this->Volumes.GetBatch(frame, part, area), area).Parts;
  std::vector<std::vector<int>> loops;
  std::vector<int> rest;
  bool capped = false;
  for (int i = 0; i < static_cast<int>(parts.size()); ++i)
  {
    const bool same = i > 0 && parts[i].Caster == parts[i - 1].Caster;
    capped = same ? capped : this->Volumes.HasCaps(frame.Casters->Get()[parts[i].Caster], place);
    if (capped && same)
    {
      loops.back().push_back(i);
    }
    else if (capped || loops.size() < MostLoops)
    {
      loops.push_back({ i });
    }
    else
    {
      rest.push_back(i);
    }
  }
  if (!rest.empty())
  {
    loops.push_back(rest);
  }
  return loops;
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::CombineLoops(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area)
{
  vtkPenumbraWedges& wedges = *this->Parts[part].Areas[area];
  const int channels = this->IsColor(part) ? 3 : 1;
  for (auto& texture : this->Loops)
  {
    texture.Allocate(frame.Window, vtkShadowTexture::Format::Float2, buffer.GetWidth(),
      buffer.GetHeight(), channels);
  }
  int last = 0; // which holds what is combined
  const auto loops = this->GetLoops(frame, part, area);
  frame.Counts["loops"] += static_cast<double>(loops.size());
  const auto combine = [&](const char* definitions)
  {
    this->Loops[last].Activate(frame.Window);
    for (int c = 0; c < channels; ++c)
    {
      this->DrawOver(frame, buffer, this->Loops[1 - last], c, false, this->Sums, wedges,
        vtkPenumbraLoopsFS, definitions,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi("shadowLoops", this->Loops[last].GetUnit());
          program->SetUniformi("shadowChannel", c);
        });
    }
    this->Loops[last].Deactivate(frame.Window);
    last = 1 - last;
  };
  for (int c = 0; c < channels; ++c)
  {
    vtkShadowFramebuffer::Scope scope(
      frame.Window, buffer.GetFramebuffer(), &this->Loops[last], nullptr, c);
    const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, none);
  }
  for (const auto& loop : loops)
  {
    this->CountCentre(frame, buffer, part, area, &loop);
    this->AddWedges(
      frame, buffer, { &this->Sums }, 0, part, wedges, vtkPenumbraSumFS, "", nullptr, &loop);
    combine("");
  }
  if (last != 0)
  {
    combine("#define SHADOW_COPY\n");
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddArea(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area)
{
  vtkPenumbraWedges& wedges = *this->Parts[part].Areas[area];
  const bool loops = this->Overlap == "loops";
  if (loops)
  {
    this->CombineLoops(frame, buffer, part, area);
  }
  else
  {
    this->CountCentre(frame, buffer, part, area);
    this->AddWedges(frame, buffer, { &this->Sums }, 0, part, wedges, vtkPenumbraSumFS, "", nullptr);
  }
  const glm::vec3 share = this->GetShare(part, area);
  this->DrawOver(frame, buffer, buffer.GetTarget(), part, true, loops ? this->Loops[0] : this->Sums,
    wedges, vtkPenumbraAreaFS, loops ? "#define SHADOW_COMBINED\n" : "",
    [&](vtkShaderProgram* program)
    { program->SetUniform3f("shadowShare", glm::value_ptr(share)); });
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddQuantity(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area)
{
  const std::string& quantity = buffer.GetQuantity();
  vtkPenumbraWedges& wedges = *this->Parts[part].Areas[area];
  if (quantity == "centre")
  {
    this->Volumes.AddCounts(frame, buffer, buffer.GetTarget(), part, part, area, wedges.GetLines());
    return;
  }
  const std::string shown = quantity == "inner"   ? "#define SHADOW_WEDGE_HALF 1\n"
                            : quantity == "outer" ? "#define SHADOW_WEDGE_HALF 0\n"
                            : quantity == "edges" ? "#define SHADOW_WEDGE_EDGES\n"
                                                  : "#define SHADOW_QUANTITY\n";
  const bool counts = this->CountsSamples(part);
  this->AddWedges(frame, buffer, { &buffer.GetTarget() }, part, part, wedges,
    counts ? vtkPenumbraCountFS : vtkPenumbraSumFS,
    counts ? this->Parts[part].Samples.GetDefinitions(0) + "#define SHADOW_QUANTITY\n"
           : "#define SHADOW_WEDGE_VIEW\n" + shown,
    nullptr);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddSamples(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part)
{
  const vtkPenumbraSamples& samples = this->Parts[part].Samples;
  vtkPenumbraWedges& wedges = *this->Parts[part].Areas[0];
  this->CountCentre(frame, buffer, part, 0);
  for (int pass = 0; pass < samples.GetPasses(); ++pass)
  {
    const int targets = samples.GetTargets(pass);
    std::vector<const vtkShadowTexture*> counts;
    for (int t = 0; t < targets; ++t)
    {
      this->Counts[t].Allocate(
        frame.Window, vtkShadowTexture::Format::Float4, buffer.GetWidth(), buffer.GetHeight(), 1);
      counts.push_back(&this->Counts[t]);
    }
    {
      vtkShadowFramebuffer::Scope scope(frame.Window, buffer.GetFramebuffer(), counts, nullptr, 0);
      const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
      for (int t = 0; t < targets; ++t)
      {
        glClearBufferfv(GL_COLOR, t, none);
      }
    }
    const std::string definitions = samples.GetDefinitions(pass);
    const auto setParameters = [&](vtkShaderProgram* program)
    {
      samples.SetParameters(program, pass);
      for (int t = 0; t < targets; ++t)
      {
        const std::string name = "shadowCounts" + std::to_string(t);
        if (program->IsUniformUsed(name.c_str()))
        {
          program->SetUniformi(name.c_str(), this->Counts[t].GetUnit());
        }
      }
    };
    this->AddWedges(
      frame, buffer, counts, 0, part, wedges, vtkPenumbraCountFS, definitions, setParameters);
    for (int t = 0; t < targets; ++t)
    {
      this->Counts[t].Activate(frame.Window);
    }
    this->DrawOver(frame, buffer, buffer.GetTarget(), part, true, this->Sums, wedges,
      vtkPenumbraSamplesFS, definitions, setParameters);
    for (int t = 0; t < targets; ++t)
    {
      this->Counts[t].Deactivate(frame.Window);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  const bool cost = !buffer.GetQuantity().empty();
  this->Most = 0.0;
  bool memory = this->Volumes.UpdateDepth(frame, buffer);
  const bool color = std::any_of(this->Parts.begin(), this->Parts.end(),
    [](const PartState& state) { return !state.Emissions.empty(); });
  memory = memory && this->Sums.Allocate(frame.Window,
                       color ? vtkShadowTexture::Format::Float4 : vtkShadowTexture::Format::Float2,
                       buffer.GetWidth(), buffer.GetHeight(), 1);
  for (int i = 0; memory && i < static_cast<int>(frame.Parts.size()); ++i)
  {
    if (this->Volumes.GetSamples(i).empty())
    {
      continue;
    }
    const PartState& state = this->Parts[i];
    if (state.Areas.empty())
    {
      cost ? this->Volumes.AddFaces(frame, buffer, i, 0)
           : static_cast<void>(this->Volumes.Subtract(frame, buffer, i, 0));
    }
    for (int k = 0; k < static_cast<int>(state.Areas.size()); ++k)
    {
      cost                     ? this->AddQuantity(frame, buffer, i, k)
      : this->CountsSamples(i) ? this->AddSamples(frame, buffer, i)
                               : this->AddArea(frame, buffer, i, k);
    }
    if (cost)
    {
      const auto values = buffer.ReadTarget(frame.Window, i);
      this->Most = std::max<double>(this->Most, *std::max_element(values.begin(), values.end()));
      const std::string name = buffer.GetQuantity() == "cost" ? "wedge" : buffer.GetQuantity();
      frame.Counts[name + "Pixels"] += std::accumulate(values.begin(), values.end(), 0.0);
    }
  }
  if (!memory)
  {
    frame.Messages->Error("no memory for wedges over " + std::to_string(buffer.GetWidth()) + " x " +
                          std::to_string(buffer.GetHeight()) + " pixels; drawn without shadows.");
  }
}
