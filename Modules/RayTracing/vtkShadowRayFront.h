// SPDX-License-Identifier: BSD-3-Clause
// Spends rays where they disagree.

#ifndef vtkShadowRayFront_h
#define vtkShadowRayFront_h

#include "vtkShadowRayTracer.h"

#include <vector>

/**
 * Traces a few rays from each of some receivers, and all that are asked for from those whose own, or a
 * neighbour's, do not agree; from there on around each one that turns out to see a part of the light. A
 * neighbour that is none of the receivers sees all of it, or receives nothing.
 */
class vtkShadowRayFront
{
public:
  /** The few first rays of so many, then all, or twice as many again and again. */
  static std::vector<int> GetSteps(int samples, bool doubling);

  /** Of a picture that is so many pixels wide and high. */
  vtkShadowRayFront(vtkShadowRayTracer& tracer, const vtkShadowRayTracer::Target& target, int width,
    int height, const std::vector<vtkShadowRayReceiver>& receivers);

  /** Until all steps are taken, or the standard error of a receiver is at most so large. */
  void Trace(double error);

  const std::vector<vtkShadowRaySeen>& GetSeen() const { return this->Seen; }
  double GetRays() const { return this->Rays; }
  /** Receivers that got more than the first few. */
  std::size_t GetRefined() const { return this->Refined; }

private:
  template <typename Visit>
  void ForEachNeighbour(int receiver, Visit visit) const;
  bool Disagrees(int receiver) const;
  bool IsPart(int receiver) const;
  void TraceToError(std::vector<int> chosen, double error);

  vtkShadowRayTracer& Tracer;
  const vtkShadowRayTracer::Target& Target;
  const int Width;
  const int Height;
  const std::vector<vtkShadowRayReceiver>& Receivers;
  std::vector<int> OfPixel; // receivers, or -1
  std::vector<vtkShadowRaySeen> Seen;
  double Rays = 0.0;
  std::size_t Refined = 0;
};

#endif
