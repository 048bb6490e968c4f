// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCandidate.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkVisibilityBuffer.h"

#include <algorithm>
#include <chrono>
#include <exception>

namespace
{
/** Milliseconds of a call, until the GPU is done: rays take the processor's time. */
template <typename Call>
double Measure(Call call)
{
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  call();
  glFinish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}
}

//------------------------------------------------------------------------------
vtkShadowCandidate::vtkShadowCandidate(const vtkShadowDeclaration& declaration, int level)
  : Settings(declaration)
{
  for (const auto& parameter : declaration.Parameters)
  {
    if (!parameter.Presets.empty())
    {
      this->Settings.Set(
        parameter.Name, level < 0 ? parameter.GetPreview() : parameter.Presets[level]);
    }
  }
  this->Technique = declaration.Make(this->Settings);
}

//------------------------------------------------------------------------------
bool vtkShadowCandidate::Draw(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  vtkShadowTechnique& technique = *this->Technique;
  bool works = true;
  const auto draw = [&]
  {
    works = works && technique.UpdateLightData(frame);
    if (works)
    {
      technique.Evaluate(frame, buffer);
    }
  };
  try
  {
    this->Note = technique.FindUnsupported(frame.Window);
    if (!this->Note.empty())
    {
      return false;
    }
    draw(); // compiles shaders
    technique.Release(frame.Window);
    this->Dynamic = Measure(draw);
    this->Static = std::min(Measure(draw), Measure(draw));
    if (this->GetDeclaration().Traits.CameraDependent)
    {
      this->Static = this->Dynamic;
    }
    if (technique.GetSamples() > 0)
    {
      for (auto& part : frame.Parts)
      {
        part.Light.FirstSample = technique.GetSamples();
      }
      this->Adding = Measure(draw);
      for (auto& part : frame.Parts)
      {
        part.Light.FirstSample = -1;
      }
      draw(); // what is judged is a frame by itself
    }
    this->Note = works ? "" : "it has no light data here";
  }
  catch (const std::exception& exception)
  {
    technique.Deactivate(frame);
    this->Note = exception.what();
    works = false;
  }
  return works;
}

//------------------------------------------------------------------------------
void vtkShadowCandidate::Release(vtkOpenGLRenderWindow* window)
{
  this->Technique->Release(window);
}

//------------------------------------------------------------------------------
bool vtkShadowCandidate::IsSame(const vtkShadowCandidate& other) const
{
  const auto same = [](const auto& a, const auto& b) { return a.second.Text == b.second.Text; };
  const auto& mine = this->Settings.GetAll();
  const auto& others = other.Settings.GetAll();
  return &this->GetDeclaration() == &other.GetDeclaration() &&
         std::equal(mine.begin(), mine.end(), others.begin(), others.end(), same);
}

//------------------------------------------------------------------------------
nlohmann::ordered_json vtkShadowCandidate::GetJSON() const
{
  nlohmann::ordered_json json = { { "technique", this->Settings.GetTechnique() } };
  json["parameters"] = nlohmann::ordered_json::object();
  for (const auto& parameter : this->GetDeclaration().Parameters)
  {
    if (!parameter.Presets.empty())
    {
      json["parameters"][parameter.Name] = *this->Settings.Find(parameter.Name);
    }
  }
  if (!this->Note.empty())
  {
    json["note"] = this->Note;
    return json;
  }
  json["milliseconds"] = this->Static;
  json["millisecondsRebuilt"] = this->Dynamic;
  if (this->Error.Value >= 0.0)
  {
    json["rmse"] = this->Error.Value;
    json["rmseInterval"] = { this->Error.Least, this->Error.Most };
  }
  return json;
}
