// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPenumbraSamples.h"

#include "vtkShaderProgram.h"
#include "vtkShadowLight.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkPenumbraSamples::Set(const vtkShadowLight& light, int count, std::size_t mostNested)
{
  this->Count = count;
  this->Color = light.Emission != nullptr;
  this->Digits = mostNested <= LeastMost ? 4 : (mostNested < 128 ? 3 : 2);
  // On a light at 0 with unit axes.
  vtkShadowLight unit = light;
  unit.Kind =
    light.Kind == vtkShadowLight::Shape::Rectangle ? light.Kind : vtkShadowLight::Shape::Disk;
  unit.Position = glm::dvec3(0.0);
  unit.U = { 1.0, 0.0, 0.0 };
  unit.V = { 0.0, 1.0, 0.0 };
  const std::size_t room =
    static_cast<std::size_t>(this->GetOfTarget()) * MostTargets * this->GetPasses();
  this->X.assign(room, 0.0f);
  this->Y.assign(room, 0.0f);
  for (auto& weights : this->Weights)
  {
    weights.assign(room, 0.0f); // of what is left over too
  }
  const auto samples = unit.GetSamples(count, glm::dvec3(0.0));
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    this->X[i] = static_cast<float>(samples[i].Point.x);
    this->Y[i] = static_cast<float>(samples[i].Point.y);
    for (int c = 0; c < 3; ++c)
    {
      this->Weights[c][i] = static_cast<float>(samples[i].Weight[c]);
    }
  }
}

//------------------------------------------------------------------------------
int vtkPenumbraSamples::GetPasses() const
{
  const int ofPass = this->GetOfTarget() * MostTargets;
  return (this->Count + ofPass - 1) / ofPass;
}

//------------------------------------------------------------------------------
int vtkPenumbraSamples::GetTargets(int pass) const
{
  const int left = this->Count - pass * this->GetOfTarget() * MostTargets;
  return std::min(MostTargets, (left + this->GetOfTarget() - 1) / this->GetOfTarget());
}

//------------------------------------------------------------------------------
std::string vtkPenumbraSamples::GetDefinitions(int pass) const
{
  return "#define SHADOW_DIGITS " + std::to_string(this->Digits) + "\n#define SHADOW_BASE " +
         std::to_string(1 << 24 / this->Digits) + ".0\n#define SHADOW_TARGETS " +
         std::to_string(this->GetTargets(pass)) + "\n" +
         (this->Color ? "#define SHADOW_COLOR\n" : "");
}

//------------------------------------------------------------------------------
void vtkPenumbraSamples::SetParameters(vtkShaderProgram* program, int pass) const
{
  const int vectors = this->Digits * this->GetTargets(pass);
  const std::size_t first = static_cast<std::size_t>(pass) * this->GetOfTarget() * MostTargets;
  const auto set = [&](const char* name, const std::vector<float>& values)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniform4fv(
        name, vectors, reinterpret_cast<const float(*)[4]>(values.data() + first));
    }
  };
  set("shadowSampleX", this->X);
  set("shadowSampleY", this->Y);
  set("shadowSampleRed", this->Weights[0]);
  set("shadowSampleGreen", this->Weights[1]);
  set("shadowSampleBlue", this->Weights[2]);
}
