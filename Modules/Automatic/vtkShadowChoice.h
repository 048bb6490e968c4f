// SPDX-License-Identifier: BSD-3-Clause
// Which techniques an error and a time ask for: candidates are tried on a frame, few of each technique.
//
// All are tried at quality low first. Better ones follow, the fastest techniques first, until one has the error,
// takes more time than another that has it, or than is allowed, or is no better than the one before.

#ifndef vtkShadowChoice_h
#define vtkShadowChoice_h

#include "vtkShadowCandidate.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
struct vtkShadowFrame;

class vtkShadowChoice
{
public:
  /** What is wanted: an RMSE in penumbrae, and milliseconds; 0: not that. */
  struct Wish
  {
    double Error = 0.0;
    double Time = 0.0;
  };

  /** Try candidates on a frame that has its receivers, and choose. False where there is none at all. */
  bool Make(const vtkShadowFrame& frame, const Wish& wish);
  void Release(vtkOpenGLRenderWindow* window);

  ///@{ While the camera moves; while lights or casters do; once nothing does. The last one may be nullptr.
  vtkShadowCandidate* GetStatic() const { return this->Static; }
  vtkShadowCandidate* GetDynamic() const { return this->Dynamic; }
  vtkShadowCandidate* GetStill() const { return this->Still; }
  ///@}
  /** How many samples the still one is to add up. */
  int GetSamples() const { return this->Samples; }
  /** What was chosen, what was tried, and why. */
  nlohmann::ordered_json GetJSON() const;

private:
  using Candidates = std::vector<vtkShadowCandidate*>;

  /** How candidates are tried. */
  class Trial;

  /** The best for a wish, by the time of a kind of frame. */
  vtkShadowCandidate* FindBest(
    const Candidates& tried, const Wish& wish, double vtkShadowCandidate::*time) const;
  void ChooseStill(const Candidates& tried, const Wish& wish);
  Candidates GetTried() const;

  std::vector<std::unique_ptr<vtkShadowCandidate>> All;
  vtkShadowCandidate* Static = nullptr;
  vtkShadowCandidate* Dynamic = nullptr;
  vtkShadowCandidate* Still = nullptr;
  int Samples = 0;
  std::string Why;
};

#endif
