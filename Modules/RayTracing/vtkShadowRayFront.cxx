// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRayFront.h"

#include "vtkShadowLight.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
/** So many rays at least, and this share of all, tell whether more are needed. */
constexpr int FewestRays = 4;
constexpr int ShareOfRays = 8;

/** Of V as stratified rays give it: see the declaration's limits. One ray of each kind more is assumed. */
double FindError(const vtkShadowRaySeen& seen)
{
  const double share = (seen.Clear + 1.0) / (seen.Samples + 2.0);
  return std::sqrt(share * (1.0 - share)) / std::pow(static_cast<double>(seen.Samples), 0.75);
}
}

//------------------------------------------------------------------------------
std::vector<int> vtkShadowRayFront::GetSteps(int samples, bool doubling)
{
  // Powers of two, which are stratified by themselves.
  int first = FewestRays;
  while (2 * first * ShareOfRays <= samples)
  {
    first *= 2;
  }
  std::vector<int> steps;
  for (int step = first; step < samples && (doubling || steps.empty()); step *= 2)
  {
    steps.push_back(step);
  }
  steps.push_back(samples);
  return steps;
}

//------------------------------------------------------------------------------
vtkShadowRayFront::vtkShadowRayFront(vtkShadowRayTracer& tracer,
  const vtkShadowRayTracer::Target& target, int width, int height,
  const std::vector<vtkShadowRayReceiver>& receivers)
  : Tracer(tracer)
  , Target(target)
  , Width(width)
  , Height(height)
  , Receivers(receivers)
  , OfPixel(static_cast<std::size_t>(width) * height, -1)
  , Seen(receivers.size())
{
  for (std::size_t i = 0; i < receivers.size(); ++i)
  {
    this->OfPixel[receivers[i].Pixel] = static_cast<int>(i);
  }
}

//------------------------------------------------------------------------------
template <typename Visit>
void vtkShadowRayFront::ForEachNeighbour(int receiver, Visit visit) const
{
  const int x = this->Receivers[receiver].Pixel % this->Width;
  const int y = this->Receivers[receiver].Pixel / this->Width;
  for (int j = std::max(0, y - 1); j <= std::min(this->Height - 1, y + 1); ++j)
  {
    for (int i = std::max(0, x - 1); i <= std::min(this->Width - 1, x + 1); ++i)
    {
      visit(this->OfPixel[static_cast<std::size_t>(j) * this->Width + i]);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkShadowRayFront::IsPart(int receiver) const
{
  const vtkShadowRaySeen& seen = this->Seen[receiver];
  return seen.Clear > 0 && seen.Clear < seen.Samples;
}

//------------------------------------------------------------------------------
bool vtkShadowRayFront::Disagrees(int receiver) const
{
  const vtkShadowRaySeen& own = this->Seen[receiver];
  if (own.Samples == 0)
  {
    return false; // its own surface hides the light
  }
  bool all = own.Clear == own.Samples;
  bool none = own.Clear == 0;
  this->ForEachNeighbour(receiver,
    [&](int neighbour)
    {
      const vtkShadowRaySeen* seen = neighbour < 0 ? nullptr : &this->Seen[neighbour];
      none = none && seen && seen->Clear == 0;
      all = all && (!seen || seen->Clear == seen->Samples);
    });
  return !all && !none;
}

//------------------------------------------------------------------------------
void vtkShadowRayFront::TraceToError(std::vector<int> chosen, double error)
{
  const std::vector<int>& steps = this->Target.Steps;
  for (auto step = steps.begin() + 1; step != steps.end() && !chosen.empty(); ++step)
  {
    chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                   [&](int i) { return FindError(this->Seen[i]) <= error; }),
      chosen.end());
    this->Rays += this->Tracer.Trace(this->Target, this->Receivers, chosen, *step, this->Seen);
  }
}

//------------------------------------------------------------------------------
void vtkShadowRayFront::Trace(double error)
{
  std::vector<int> front(this->Receivers.size());
  std::iota(front.begin(), front.end(), 0);
  this->Rays += this->Tracer.Trace(
    this->Target, this->Receivers, front, this->Target.Steps.front(), this->Seen);
  if (this->Target.Steps.size() == 1 || this->Target.Part.Light.IsPoint())
  {
    return;
  }
  front.erase(
    std::remove_if(front.begin(), front.end(), [this](int i) { return !this->Disagrees(i); }),
    front.end());
  std::vector<char> reached(this->Receivers.size(), 0);
  for (const int i : front)
  {
    reached[i] = 1;
  }
  while (!front.empty())
  {
    this->Refined += front.size();
    this->TraceToError(front, error);
    std::vector<int> next;
    for (const int i : front)
    {
      if (this->IsPart(i))
      {
        this->ForEachNeighbour(i,
          [&](int neighbour)
          {
            if (neighbour >= 0 && !reached[neighbour] && this->Seen[neighbour].Samples > 0)
            {
              reached[neighbour] = 1;
              next.push_back(neighbour);
            }
          });
      }
    }
    front = std::move(next);
  }
}
