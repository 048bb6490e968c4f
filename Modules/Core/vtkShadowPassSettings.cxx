// SPDX-License-Identifier: BSD-3-Clause
// The settings of vtkShadowPass: technique, parameters, debug view, statistics.

#include "vtkInformationIntegerKey.h"
#include "vtkShadowDebugViews.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowNumber.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowPassChain.h"
#include "vtkShadowPassInternals.h"
#include "vtkShadowTags.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

//------------------------------------------------------------------------------
bool vtkShadowPass::SetTechnique(const std::string& name)
{
  Internals& my = *this->Internal;
  const vtkShadowDeclaration* declaration = vtkShadowTechniqueRegistration::Find(name);
  if (!declaration)
  {
    std::string known;
    for (const auto& entry : vtkShadowTechniqueRegistration::GetAll())
    {
      known += (known.empty() ? "" : ", ") + entry.first;
    }
    vtkErrorMacro("SetTechnique: there is no technique '"
                  << name << "'. Known: "
                  << (known.empty() ? vtkShadowTechniqueRegistration::GetHint() : known) << ".");
    return false;
  }
  const bool isAnother = declaration != my.Settings.GetDeclaration();
  my.Settings.Reset(declaration);
  if (isAnother)
  {
    if (my.Technique)
    {
      my.Retired.push_back(std::move(my.Technique));
    }
    my.Technique = declaration->Make(my.Settings);
    my.Active = false; // the frame that was drawn is not this technique's
    my.Stages.Opaque.Valid = my.Stages.Translucent.Valid = false;
  }
  const auto views = vtkShadowDebugViews::GetNames(declaration);
  if (std::find(views.begin(), views.end(), my.DebugView) == views.end())
  {
    my.DebugView = "none";
  }
  my.Messages.SetPrefix(name);
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetTechnique()
{
  return this->Internal->Settings.GetTechnique();
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetParameter(const std::string& name, const std::string& value)
{
  Internals& my = *this->Internal;
  const vtkMTimeType before = my.Settings.GetTimeOfAny();
  const std::string problem = my.Settings.Set(name, value);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  if (my.Settings.GetTimeOfAny() != before)
  {
    my.Messages.Forget();
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetParameter(const std::string& name, double value)
{
  return this->SetParameter(name, vtkShadowNumber::Print(value));
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetParameter(const std::string& name)
{
  const vtkShadowSettings& settings = this->Internal->Settings;
  const std::string* value = settings.Find(name);
  if (!value)
  {
    vtkErrorMacro(<< settings.GetUnknown(name));
  }
  return value ? *value : "";
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetQuality(int level)
{
  if (const vtkShadowDeclaration* declaration = this->Internal->Settings.GetDeclaration())
  {
    for (const auto& parameter : declaration->Parameters)
    {
      if (!parameter.Presets.empty())
      {
        this->SetParameter(
          parameter.Name, level < 0 ? parameter.GetPreview() : parameter.Presets[level]);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetDebugViews()
{
  std::string text;
  for (const auto& name : vtkShadowDebugViews::GetNames(this->Internal->Settings.GetDeclaration()))
  {
    text += (text.empty() ? "" : " ") + name;
  }
  return text;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetDebugView(const std::string& view)
{
  const auto names = vtkShadowDebugViews::GetNames(this->Internal->Settings.GetDeclaration());
  if (std::find(names.begin(), names.end(), view) == names.end())
  {
    vtkErrorMacro(<< this->GetTechnique() << " has no debug view '" << view
                  << "'. Known: " << this->GetDebugViews() << ".");
    return false;
  }
  this->Internal->DebugView = view;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetDebugView()
{
  return this->Internal->DebugView;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetDelegatePass(vtkRenderPass* delegate)
{
  if (vtkShadowPassChain::Holds(delegate, this))
  {
    vtkErrorMacro("SetDelegatePass: this pass is the delegate itself, or within it.");
    return;
  }
  if (this->Internal->Delegate != delegate)
  {
    this->Internal->Delegate = delegate;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkShadowPass::GetDelegatePass()
{
  return this->Internal->Delegate;
}

//------------------------------------------------------------------------------
void vtkShadowPass::CopySettings(vtkShadowPass* other)
{
  Internals& my = *this->Internal;
  const Internals& from = *other->Internal;
  if (this->GetTechnique() != other->GetTechnique() && from.Technique)
  {
    this->SetTechnique(other->GetTechnique());
  }
  const vtkMTimeType before = my.Settings.GetTime();
  my.Settings.Copy(from.Settings);
  if (my.Settings.GetTime() != before)
  {
    my.Messages.Forget();
  }
  my.DebugView = from.DebugView;
  this->SetDelegatePass(from.Delegate);
  this->SetDefaultLightRadius(other->GetDefaultLightRadius());
  this->SetDefaultLightAngle(other->GetDefaultLightAngle());
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkShadowPass::IsSupported(vtkRenderWindow* window)
{
  auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!glWindow)
  {
    this->Internal->UnsupportedReason = "the window is not a vtkOpenGLRenderWindow";
  }
  else
  {
    glWindow->Initialize();
    glWindow->MakeCurrent();
    int major = 0;
    int minor = 0;
    glWindow->GetOpenGLVersion(major, minor);
    const bool has = major > 3 || (major == 3 && minor >= 3) ||
                     (major == 3 && minor == 2 && VTK_SHADOW_HAS_GL(ARB_shader_bit_encoding));
    this->Internal->UnsupportedReason =
      has ? (this->Internal->Technique ? this->Internal->Technique->FindUnsupported(glWindow) : "")
          : "OpenGL 3.3 is needed, or 3.2 with ARB_shader_bit_encoding; the window has " +
              std::to_string(major) + "." + std::to_string(minor);
  }
  return this->Internal->UnsupportedReason.empty();
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetUnsupportedReason()
{
  return this->Internal->UnsupportedReason;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::IsFinished()
{
  if (vtkShadowPass* copy = this->Internal->At.Copy)
  {
    return copy->IsFinished();
  }
  return this->Internal->Frames > 0 && this->Internal->Accumulation.IsFinished();
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetStatistics()
{
  Internals& my = *this->Internal;
  if (my.At.Copy)
  {
    return my.At.Copy->GetStatistics();
  }
  vtkShadowStages& stages = my.Stages;
  nlohmann::ordered_json json = { { "technique", this->GetTechnique() }, { "frame", my.Frames },
    { "evaluation", my.Active ? (stages.IsInScreenSpace() ? "screen" : "forward") : "none" } };
  if (my.At.Window && stages.GetTimers().ArePending())
  {
    my.At.Window->MakeCurrent();
  }
  json["milliseconds"] = stages.GetTimers().GetMilliseconds();
  json["counts"] = stages.GetFrame().Counts;
  json["lights"] = stages.GetLightNotes();
  const std::string report = my.Technique ? my.Technique->GetReport() : "";
  if (!report.empty())
  {
    json["choice"] = nlohmann::ordered_json::parse(report);
  }
  if (my.ErrorFrame == my.Frames && !my.Errors.empty())
  {
    json["errors"] = my.Errors;
  }
  std::size_t total = stages.GetCasterBytes() + stages.GetBufferBytes();
  json["bytes"]["casters"] = stages.GetCasterBytes();
  json["bytes"]["buffers"] = stages.GetBufferBytes();
  const auto add = [&](vtkShadowTechnique* technique, const std::string& prefix)
  {
    for (const auto& entry : technique->GetBytes())
    {
      json["bytes"][prefix + entry.first] = entry.second;
      total += entry.second;
    }
  };
  if (my.Technique)
  {
    add(my.Technique.get(), "");
  }
  for (const auto& technique : my.Retired)
  {
    add(technique.get(), "replaced: ");
  }
  json["bytes"]["total"] = total;
  return json.dump(2);
}

//------------------------------------------------------------------------------
void vtkShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->GetTechnique() << "\n";
  for (const auto& entry : this->Internal->Settings.GetAll())
  {
    os << indent << entry.first << ": " << entry.second.Text << "\n";
  }
  os << indent << "DebugView: " << this->Internal->DebugView << "\n";
  os << indent << "DefaultLightRadius: " << this->DefaultLightRadius << "\n";
  os << indent << "DefaultLightAngle: " << this->DefaultLightAngle << "\n";
  os << indent << "DelegatePass: " << this->Internal->Delegate.Get() << "\n";
}

//------------------------------------------------------------------------------
static bool& Advice()
{
  static bool advice = true;
  return advice;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetAdvice(bool advice)
{
  Advice() = advice;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetAdvice()
{
  return Advice();
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkShadowPass::CASTS_SHADOW()
{
  return vtkShadowTags::CASTS_SHADOW();
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkShadowPass::RECEIVES_SHADOW()
{
  return vtkShadowTags::RECEIVES_SHADOW();
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkShadowPass::SHADOW_CATCHER()
{
  return vtkShadowTags::SHADOW_CATCHER();
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetCasting(vtkProp* prop, bool casts)
{
  vtkShadowTags::SetCasting(prop, casts);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetCasting(vtkProp* prop)
{
  return vtkShadowTags::GetCasting(prop);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetReceiving(vtkProp* prop, bool receives)
{
  vtkShadowTags::SetReceiving(prop, receives);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetReceiving(vtkProp* prop)
{
  return vtkShadowTags::GetReceiving(prop);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetShadowCatcher(vtkProp* prop, bool catches)
{
  vtkShadowTags::SetShadowCatcher(prop, catches);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetShadowCatcher(vtkProp* prop)
{
  return vtkShadowTags::GetShadowCatcher(prop);
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightCasting(vtkLight* light, bool casts)
{
  vtkShadowTags::SetLightCasting(light, casts);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetLightCasting(vtkLight* light)
{
  return vtkShadowTags::GetLightCasting(light);
}
