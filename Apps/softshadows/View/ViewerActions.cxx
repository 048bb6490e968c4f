// SPDX-License-Identifier: BSD-3-Clause
// What the user can do in the viewer, by keys and the menu.

#include "Errors.h"
#include "References.h"
#include "Values.h"
#include "ViewSnapshot.h"
#include "Viewer.h"

#include "vtkAreaLight.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
constexpr double LightStep = 0.05; // of the scene
constexpr double SizeStep = 1.1;
constexpr double ZoomStep = 1.1;
constexpr double DividerStep = 0.05;
}

//------------------------------------------------------------------------------
void Viewer::Say(const std::string& text)
{
  this->Message = text;
  std::fprintf(stderr, "softshadows: %s\n", Messages::GetPrintable(text).c_str());
}

//------------------------------------------------------------------------------
void Viewer::RaiseLight(int step)
{
  this->Stage->RaiseLight(step * LightStep);
  this->LightChanged = true;
}

//------------------------------------------------------------------------------
void Viewer::ScaleLight(int step)
{
  this->Stage->ScaleLight(std::pow(SizeStep, step));
  this->LightChanged = true;
}

//------------------------------------------------------------------------------
void Viewer::Zoom(int step)
{
  this->Stage->Zoom(std::pow(ZoomStep, step));
}

//------------------------------------------------------------------------------
void Viewer::ResetCamera(int)
{
  this->Stage->ResetCamera();
}

//------------------------------------------------------------------------------
void Viewer::StepTechnique(int step)
{
  this->Left->StepTechnique(step);
  this->Recent.clear();
  this->LightChanged = true;
}

//------------------------------------------------------------------------------
void Viewer::Spin(int casters)
{
  const Spinning wanted = casters ? Spinning::Casters : Spinning::Camera;
  this->Spins = this->Spins == wanted ? Spinning::None : wanted;
  this->Recent.clear();
}

//------------------------------------------------------------------------------
void Viewer::SetQuality(int level)
{
  const std::string& quality = ViewModel::GetQualities()[level];
  this->Left->SetQuality(quality);
  this->Message = "quality " + quality;
  this->LightChanged = true;
}

//------------------------------------------------------------------------------
void Viewer::Choose(int step)
{
  this->Left->Choose(step);
}

//------------------------------------------------------------------------------
void Viewer::Change(int step)
{
  this->Left->Change(step);
  this->LightChanged = true;
}

//------------------------------------------------------------------------------
void Viewer::SwitchMidpoint(int)
{
  if (!this->Left->Has("midpoint"))
  {
    this->Message = this->Left->GetTechnique() + " has no midpoint maps";
    return;
  }
  this->Left->SetValue("midpoint", this->Left->GetValue("midpoint") == "off" ? "on" : "off");
  this->Message = "midpoint = " + this->Left->GetValue("midpoint");
  this->LightChanged = true;
}

//------------------------------------------------------------------------------
void Viewer::SwitchSamples(int)
{
  if (!this->Left->Has("samples"))
  {
    this->Message = this->Left->GetTechnique() + " takes no number of samples";
    return;
  }
  this->Left->SetValue("samples", this->Left->GetValue("samples") == "64" ? "100" : "64");
  this->Message = this->Left->GetValue("samples") + " samples";
  this->LightChanged = true;
}

//------------------------------------------------------------------------------
void Viewer::StepDebugView(int step)
{
  this->Left->StepDebugView(step);
  this->Message = "view " + this->Left->GetDebugView();
}

//------------------------------------------------------------------------------
void Viewer::Split(bool on, const std::string& technique)
{
  this->IsSplit = on;
  this->ErrorsShown = this->ErrorsShown && !on;
  if (on)
  {
    this->Right = this->Right ? std::move(this->Right)
                              : std::make_unique<ViewModel>(TechniqueOptions(), technique);
    this->Right->SetTechnique(technique);
  }
}

//------------------------------------------------------------------------------
void Viewer::SplitReference(int)
{
  const bool already = this->IsSplit && this->Right->GetTechnique() == ReferenceTechnique;
  this->Split(!already, ReferenceTechnique);
}

//------------------------------------------------------------------------------
// From the one after the left side's on, all others in turn, then none.
void Viewer::SplitTechnique(int)
{
  const auto all = ViewModel::GetTechniques();
  const auto at = [&all](const std::string& name)
  { return std::find(all.begin(), all.end(), name) - all.begin(); };
  const std::string now = this->IsSplit ? this->Right->GetTechnique() : this->Left->GetTechnique();
  const std::string next = all[(at(now) + 1) % all.size()];
  this->Split(next != this->Left->GetTechnique(), next);
}

//------------------------------------------------------------------------------
void Viewer::MoveDivider(int step)
{
  this->Divider = std::clamp(this->Divider + step * DividerStep, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void Viewer::SwitchErrors(int)
{
  const auto all = ViewModel::GetTechniques();
  if (std::find(all.begin(), all.end(), ReferenceTechnique) == all.end())
  {
    this->Message = "this build has no reference: the technique ray-traced is missing";
    return;
  }
  this->ErrorsShown = !this->ErrorsShown;
  this->IsSplit = false;
}

//------------------------------------------------------------------------------
void Viewer::SwitchLights(int)
{
  this->LightsShown = !this->LightsShown;
}

//------------------------------------------------------------------------------
void Viewer::SwitchText(int)
{
  this->TextShown = !this->TextShown;
}

//------------------------------------------------------------------------------
void Viewer::SwitchHelp(int)
{
  this->HelpShown = !this->HelpShown;
}

//------------------------------------------------------------------------------
std::vector<std::string> Viewer::GetOptions() const
{
  std::vector<std::string> words = this->Stage->GetOptions(this->Window->GetSize());
  const auto more = this->Left->GetOptions();
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

//------------------------------------------------------------------------------
void Viewer::PrintOptions(int)
{
  std::printf("%s\n", Values::Join(this->GetOptions()).c_str());
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
// Of the left side alone, at full quality, in the whole window and without what lies over it.
void Viewer::TakeSnapshot(int)
{
  const bool split = this->IsSplit;
  this->IsSplit = false;
  this->Left->Restore();
  this->Overlay.SetShown(false);
  this->Draw();
  const auto picture = ViewSnapshot::Grab(this->Window);
  this->Overlay.SetShown(true);
  this->IsSplit = split;
  vtkShadowPass* pass = this->Left->GetPass();
  const auto visibility =
    pass ? References::GetVisibility(pass, this->Stage->GetScene().Light, nullptr) : nullptr;
  const nlohmann::ordered_json settings = { { "options", this->GetOptions() },
    { "command", "softshadows render " + Values::Join(this->GetOptions()) },
    { "technique", this->Left->GetTechnique() },
    { "parameters", pass ? Techniques::GetParameters(pass) : nlohmann::ordered_json() },
    { "scene", this->Stage->GetScene().GetJSON() },
    { "frame_milliseconds", this->Figures.Milliseconds }, { "pass", this->Figures.Statistics } };
  const std::string name = ViewSnapshot::Write(picture, visibility, settings);
  this->Message = "wrote " + name + ".png" + (pass ? ", " + name + "-visibility.exr" : "") +
                  " and " + name + ".json";
  std::printf("%s\n", this->Message.c_str());
  std::fflush(stdout);
}

//------------------------------------------------------------------------------
void Viewer::End(int)
{
  this->Ended = true;
  if (!this->Options.Screenshot.empty())
  {
    this->LastPicture = ViewSnapshot::Grab(this->Window); // the interactor gives up what was drawn
  }
  this->Interactor->TerminateApp();
}
