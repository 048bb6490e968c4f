// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAutomaticShadowTechnique.h"

#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkAutomaticShadowTechnique::Kind::IsLike(const Kind& other) const
{
  const auto near = [](double a, double b) { return a <= 2.0 * b && b <= 2.0 * a; };
  return this->Shapes == other.Shapes && this->Hard == other.Hard &&
         near(this->Triangles, other.Triangles) && near(this->Pixels, other.Pixels);
}

//------------------------------------------------------------------------------
vtkAutomaticShadowTechnique::Kind vtkAutomaticShadowTechnique::Describe(const vtkShadowFrame& frame)
{
  Kind kind;
  for (const auto& part : frame.Parts)
  {
    kind.Shapes.push_back(part.Light.Emission ? 5 : static_cast<int>(part.Light.Kind));
  }
  kind.Hard = frame.Hard;
  kind.Triangles = static_cast<double>(frame.Casters->GetNumberOfTriangles());
  kind.Pixels = static_cast<double>(frame.Size[0]) * frame.Size[1];
  return kind;
}

//------------------------------------------------------------------------------
bool vtkAutomaticShadowTechnique::IsDecided() const
{
  return this->Decided && this->Time == this->Settings.GetTime();
}

//------------------------------------------------------------------------------
vtkShadowTechnique* vtkAutomaticShadowTechnique::Get() const
{
  vtkShadowCandidate* still = this->Still ? this->Choice.GetStill() : nullptr;
  vtkShadowCandidate* chosen =
    still ? still : (this->Moving ? this->Choice.GetDynamic() : this->Choice.GetStatic());
  return chosen ? &chosen->GetTechnique() : nullptr;
}

//------------------------------------------------------------------------------
// Candidates need the receivers.
vtkShadowTraits vtkAutomaticShadowTechnique::GetTraits()
{
  vtkShadowTechnique* technique = this->Get();
  vtkShadowTraits traits = technique ? technique->GetTraits() : vtkShadowTraits();
  traits.NeedsReceivers = traits.NeedsReceivers || !this->IsDecided();
  return traits;
}

//------------------------------------------------------------------------------
int vtkAutomaticShadowTechnique::GetSamples()
{
  vtkShadowTechnique* technique = this->IsDecided() ? this->Get() : nullptr;
  const bool adds = this->Choice.GetStill() ? this->Still : this->Settings.GetBoolean("accumulate");
  return technique && adds ? technique->GetSamples() : 0;
}

//------------------------------------------------------------------------------
int vtkAutomaticShadowTechnique::GetWantedSamples()
{
  if (!this->IsDecided())
  {
    return 1; // the first frames are not all
  }
  return this->Choice.GetStill()
           ? this->Choice.GetSamples()
           : (this->GetSamples() > 0 ? this->Settings.GetInteger("accumulate-samples") : 0);
}

//------------------------------------------------------------------------------
void vtkAutomaticShadowTechnique::BeginFrame(bool still)
{
  this->Still = still && this->IsDecided();
  this->Moving = this->Moved;
}

//------------------------------------------------------------------------------
std::string vtkAutomaticShadowTechnique::GetReport()
{
  return this->Choice.GetJSON().dump();
}

//------------------------------------------------------------------------------
bool vtkAutomaticShadowTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  if (!this->IsDecided() && frame.Receivers)
  {
    this->Still = this->Moving = false;
    this->Decided =
      this->Choice.Make(frame, { this->Settings.GetReal("error"), this->Settings.GetReal("time") });
    this->Time = this->Settings.GetTime();
    this->Of = Describe(frame);
    this->Changes.Update(frame, false);
    frame.Counts["candidatesTried"] = static_cast<double>(this->Choice.GetJSON()["tried"].size());
  }
  vtkShadowTechnique* technique = this->Get();
  if (!technique)
  {
    frame.Messages->Error(
      "no technique that is linked draws these lights' shadows; drawn without.");
    return false;
  }
  const bool drawn = technique->UpdateLightData(frame);
  // For the next frame: whether this one's receivers are drawn was asked before.
  this->Changes.Update(frame, false);
  this->Moved = this->Changes.IsAny() && !this->Still;
  this->Decided = this->Decided && this->Of.IsLike(Describe(frame));
  return drawn;
}

//------------------------------------------------------------------------------
std::string vtkAutomaticShadowTechnique::GetVisibilityGLSL()
{
  return this->Get()->GetVisibilityGLSL();
}

//------------------------------------------------------------------------------
bool vtkAutomaticShadowTechnique::CanEvaluateForward()
{
  return this->Get()->CanEvaluateForward();
}

//------------------------------------------------------------------------------
bool vtkAutomaticShadowTechnique::PrefersForward(const vtkShadowFrame& frame)
{
  return this->Get()->PrefersForward(frame);
}

//------------------------------------------------------------------------------
void vtkAutomaticShadowTechnique::Activate(vtkShadowFrame& frame)
{
  this->Get()->Activate(frame);
}

//------------------------------------------------------------------------------
void vtkAutomaticShadowTechnique::Deactivate(vtkShadowFrame& frame)
{
  if (vtkShadowTechnique* technique = this->Get())
  {
    technique->Deactivate(frame);
  }
}

//------------------------------------------------------------------------------
void vtkAutomaticShadowTechnique::SetVisibilityParameters(vtkShaderProgram* program)
{
  this->Get()->SetVisibilityParameters(program);
}

//------------------------------------------------------------------------------
void vtkAutomaticShadowTechnique::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  this->Get()->FillVisibility(frame, buffer);
}

//------------------------------------------------------------------------------
double vtkAutomaticShadowTechnique::GetMaximumCost()
{
  return this->Get()->GetMaximumCost();
}

//------------------------------------------------------------------------------
std::string vtkAutomaticShadowTechnique::GetDebugQuantity(const std::string& view)
{
  vtkShadowTechnique* technique = this->Get();
  return technique ? technique->GetDebugQuantity(view) : "";
}

//------------------------------------------------------------------------------
void vtkAutomaticShadowTechnique::DrawDebugView(vtkShadowFrame& frame, const std::string& view)
{
  this->Get()->DrawDebugView(frame, view);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkAutomaticShadowTechnique::GetBytes()
{
  std::vector<vtkShadowCandidate*> chosen;
  for (vtkShadowCandidate* candidate :
    { this->Choice.GetStatic(), this->Choice.GetDynamic(), this->Choice.GetStill() })
  {
    if (candidate && std::find(chosen.begin(), chosen.end(), candidate) == chosen.end())
    {
      chosen.push_back(candidate);
    }
  }
  std::vector<std::pair<std::string, std::size_t>> bytes;
  for (vtkShadowCandidate* candidate : chosen)
  {
    for (const auto& entry : candidate->GetTechnique().GetBytes())
    {
      bytes.emplace_back(candidate->GetDeclaration().Name + ": " + entry.first, entry.second);
    }
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkAutomaticShadowTechnique::Release(vtkOpenGLRenderWindow* window)
{
  this->Choice.Release(window);
}
