// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowChoice.h"

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowErrorEstimate.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"
#include "vtkShadowNumber.h"
#include "vtkVisibilityBuffer.h"

#include <algorithm>
#include <cmath>

namespace
{
/** Quality low, medium and high; that of references is for these. */
constexpr int Levels = 3;
const char* const WithoutErrors = "map-pcss";
/** Of so many lights the error is asked: the largest counts. */
constexpr std::size_t MostLights = 4;
/** A better quality whose error is not smaller than this share has other errors than those of few samples. */
constexpr double LeastGain = 0.9;
/** Share of the wanted error that added samples are to reach: their number is extrapolated. */
constexpr double Margin = 0.85;
/** Errors of stratified samples fall with this power of their number. */
constexpr double Power = 0.75;
constexpr int MostSamples = 16384;

/** No message of candidates that may not be chosen. */
class Quiet
{
public:
  Quiet()
    : Before(vtkObject::GetGlobalWarningDisplay())
  {
    vtkObject::SetGlobalWarningDisplay(0);
  }
  ~Quiet() { vtkObject::SetGlobalWarningDisplay(this->Before); }
  Quiet(const Quiet&) = delete;
  void operator=(const Quiet&) = delete;

private:
  int Before;
};

bool IsTaken(const vtkShadowDeclaration& declaration, const vtkShadowFrame& frame)
{
  const vtkShadowTraits& traits = declaration.Traits;
  return declaration.Name != "auto" && !traits.PlanarReceivers && (frame.Hard || !traits.Hard) &&
         std::all_of(frame.Lights.begin(), frame.Lights.end(),
           [&declaration](const vtkShadowLight& light)
           {
             const std::size_t shape = light.Emission ? 5 : static_cast<std::size_t>(light.Kind);
             return declaration.LightShapes[shape] != vtkShadowShapeSupport::Unsupported;
           });
}

bool HasError(const vtkShadowCandidate& candidate, const vtkShadowChoice::Wish& wish)
{
  return wish.Error > 0.0 && candidate.Error.Value >= 0.0 && candidate.Error.Most <= wish.Error;
}
}

//------------------------------------------------------------------------------
class vtkShadowChoice::Trial
{
public:
  explicit Trial(const vtkShadowFrame& frame)
    : Messages(Source)
    , Frame(frame)
    , Errors(std::min(MostLights, frame.Lights.size()))
  {
    this->Frame.Messages = &this->Messages;
    this->Works = this->Buffer.Allocate(
      frame.Window, *frame.Receivers, static_cast<int>(frame.Parts.size()), frame.Color);
  }
  ~Trial()
  {
    for (auto& errors : this->Errors)
    {
      errors.Release(this->Frame.Window);
    }
    this->Buffer.Release(this->Frame.Window);
  }
  Trial(const Trial&) = delete;
  void operator=(const Trial&) = delete;

  void Try(vtkShadowCandidate& candidate)
  {
    if (!this->Works)
    {
      candidate.Note = "no memory to try it";
      return;
    }
    if (candidate.Draw(this->Frame, this->Buffer) && vtkShadowErrorEstimate::IsPossible())
    {
      this->FindError(candidate);
    }
    candidate.Release(this->Frame.Window);
  }

private:
  void FindError(vtkShadowCandidate& candidate)
  {
    for (std::size_t i = 0; i < this->Errors.size(); ++i)
    {
      const vtkLight* light = this->Frame.Lights[i].Light;
      const auto shown = vtkShadowErrorEstimate::Read(this->Frame, this->Buffer, light);
      if (!this->Asked && !this->Errors[i].Ask(this->Frame, *this->Frame.Receivers, shown, light))
      {
        return;
      }
      const auto error = this->Errors[i].FindError(shown);
      if (error.Most > candidate.Error.Most)
      {
        candidate.Error = error;
      }
    }
    this->Asked = true;
  }

  const Quiet NoMessages;
  vtkNew<vtkObject> Source;
  vtkShadowMessages Messages;
  vtkShadowFrame Frame;
  vtkVisibilityBuffer Buffer;
  std::vector<vtkShadowErrorEstimate> Errors; // of each light
  bool Asked = false;                         // what is true
  bool Works = false;
};

//------------------------------------------------------------------------------
bool vtkShadowChoice::Make(const vtkShadowFrame& frame, const Wish& wish)
{
  this->Release(frame.Window);
  this->All.clear();
  this->Static = this->Dynamic = this->Still = nullptr;
  Trial trial(frame);
  const auto attempt = [&](
                         const vtkShadowDeclaration& declaration, int level) -> vtkShadowCandidate*
  {
    auto candidate = std::make_unique<vtkShadowCandidate>(declaration, level);
    if (std::any_of(this->All.begin(), this->All.end(),
          [&candidate](const auto& other) { return other->IsSame(*candidate); }))
    {
      return nullptr;
    }
    trial.Try(*candidate);
    this->All.push_back(std::move(candidate));
    return this->All.back().get();
  };
  // Without errors there is nothing to choose by.
  const vtkShadowDeclaration* only = vtkShadowErrorEstimate::IsPossible()
                                       ? nullptr
                                       : vtkShadowTechniqueRegistration::Find(WithoutErrors);
  for (const auto& entry : vtkShadowTechniqueRegistration::GetAll())
  {
    if (IsTaken(entry.second, frame) && (!only || only == &entry.second))
    {
      attempt(entry.second, only ? Levels - 1 : 0);
    }
  }
  Candidates low = this->GetTried();
  std::sort(low.begin(), low.end(),
    [](const vtkShadowCandidate* a, const vtkShadowCandidate* b) { return a->Static < b->Static; });
  for (vtkShadowCandidate* last : low)
  {
    for (int level = 1; level < Levels; ++level)
    {
      const vtkShadowCandidate* best =
        this->FindBest(this->GetTried(), wish, &vtkShadowCandidate::Static);
      const bool slower = HasError(*best, wish) && last->Static >= best->Static;
      const bool late = wish.Time > 0.0 && last->Static >= wish.Time;
      if (HasError(*last, wish) || slower || late)
      {
        break;
      }
      vtkShadowCandidate* next = attempt(last->GetDeclaration(), level);
      if (!next)
      {
        continue;
      }
      const bool better = next->Note.empty() && next->Error.Value < LeastGain * last->Error.Value;
      last = next;
      if (!better)
      {
        break;
      }
    }
  }
  const Candidates tried = this->GetTried();
  if (tried.empty())
  {
    return false;
  }
  this->Static = this->FindBest(tried, wish, &vtkShadowCandidate::Static);
  this->Dynamic =
    wish.Time > 0.0 ? this->FindBest(tried, wish, &vtkShadowCandidate::Dynamic) : this->Static;
  if (wish.Error > 0.0 && !HasError(*this->Static, wish))
  {
    this->ChooseStill(tried, wish);
  }
  const bool inTime = wish.Time == 0.0 || this->Static->Static <= wish.Time;
  this->Why = !vtkShadowErrorEstimate::IsPossible()
                ? "errors are not known: the technique ray-traced is missing"
              : !inTime                       ? "nothing is within the time; it is the fastest"
              : HasError(*this->Static, wish) ? "the fastest within the error"
              : wish.Time > 0.0               ? "the least error within the time"
                                              : "nothing is within the error; it has the least";
  if (this->Still)
  {
    this->Why += "; once nothing moves, frames add up to the error";
  }
  return true;
}

//------------------------------------------------------------------------------
// Not those that failed.
vtkShadowChoice::Candidates vtkShadowChoice::GetTried() const
{
  Candidates tried;
  for (const auto& candidate : this->All)
  {
    if (candidate->Note.empty())
    {
      tried.push_back(candidate.get());
    }
  }
  return tried;
}

//------------------------------------------------------------------------------
vtkShadowCandidate* vtkShadowChoice::FindBest(
  const Candidates& tried, const Wish& wish, double vtkShadowCandidate::*time) const
{
  const auto isBetter = [&](const vtkShadowCandidate* a, const vtkShadowCandidate* b)
  {
    const bool inTime[] = { wish.Time == 0.0 || a->*time <= wish.Time,
      wish.Time == 0.0 || b->*time <= wish.Time };
    if (inTime[0] != inTime[1])
    {
      return inTime[0];
    }
    const bool hasError[] = { HasError(*a, wish), HasError(*b, wish) };
    if (hasError[0] != hasError[1] && inTime[0])
    {
      return hasError[0];
    }
    return !inTime[0] || hasError[0] ? a->*time < b->*time : a->Error.Value < b->Error.Value;
  };
  const auto best = std::min_element(tried.begin(), tried.end(), isBetter);
  return best == tried.end() ? nullptr : *best;
}

//------------------------------------------------------------------------------
// Of a technique's errors with few and many samples, e^2 = bias^2 + (c / n^0.75)^2 tells both.
void vtkShadowChoice::ChooseStill(const Candidates& tried, const Wish& wish)
{
  double least = 0.0;
  for (vtkShadowCandidate* candidate : tried)
  {
    const double n = candidate->GetTechnique().GetSamples();
    const bool late = wish.Time > 0.0 && candidate->Adding > wish.Time;
    if (n == 0.0 || candidate->Error.Value < 0.0 || (late && this->Still))
    {
      continue;
    }
    const double noise = std::pow(n, -2.0 * Power);
    double square = candidate->Error.Value * candidate->Error.Value / noise; // c^2, without bias
    double bias = 0.0;                                                       // squared
    for (vtkShadowCandidate* other : tried)
    {
      const double m = other->GetTechnique().GetSamples();
      if (&other->GetDeclaration() == &candidate->GetDeclaration() && m > 0.0 && m != n)
      {
        const double difference =
          candidate->Error.Value * candidate->Error.Value - other->Error.Value * other->Error.Value;
        square = std::max(0.0, difference / (noise - std::pow(m, -2.0 * Power)));
        bias = std::max(0.0, candidate->Error.Value * candidate->Error.Value - square * noise);
      }
    }
    const double room = Margin * Margin * wish.Error * wish.Error - bias;
    if (!(room > 0.0))
    {
      continue;
    }
    const double wanted = std::max(n, std::pow(square / room, 0.5 / Power));
    const double all = std::ceil(wanted / n) * candidate->Adding;
    if (wanted <= MostSamples && (!this->Still || all < least))
    {
      this->Still = candidate;
      this->Samples = static_cast<int>(std::ceil(wanted));
      least = all;
    }
  }
}

//------------------------------------------------------------------------------
nlohmann::ordered_json vtkShadowChoice::GetJSON() const
{
  nlohmann::ordered_json json;
  if (this->Static)
  {
    json["chosen"] = this->Static->GetJSON();
    if (this->Dynamic != this->Static)
    {
      json["whileLightsOrCastersMove"] = this->Dynamic->GetJSON();
    }
    if (this->Still)
    {
      json["atRest"] = this->Still->GetJSON();
      json["atRest"]["samples"] = this->Samples;
    }
    json["why"] = this->Why;
  }
  json["tried"] = nlohmann::ordered_json::array();
  for (const auto& candidate : this->All)
  {
    json["tried"].push_back(candidate->GetJSON());
  }
  return json;
}

//------------------------------------------------------------------------------
void vtkShadowChoice::Release(vtkOpenGLRenderWindow* window)
{
  for (const auto& candidate : this->All)
  {
    candidate->Release(window);
  }
}
