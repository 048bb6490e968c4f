// SPDX-License-Identifier: BSD-3-Clause
// How far a frame's visibility is from the truth: by rays from some of its receivers, chosen at random.
//
// The technique ray-traced, where it is built, is asked for the chosen receivers as if they were a small
// picture: twice, by different rays. The product of what V differs from both by is then the square of its
// error in the mean, without the rays' own noise. Pixels that show a part of the light, or an edge, are
// chosen by themselves, as many as of the others: what is seldom counts no less, and its figures are surer.
//
//   receivers, visibility   as those of a picture of 64 x 32 pixels (vtkShadowReceivers, vtkVisibilityBuffer)

#ifndef vtkShadowErrorEstimate_h
#define vtkShadowErrorEstimate_h

#include "vtkShadowReceivers.h"
#include "vtkShadowSettings.h"
#include "vtkShadowTechnique.h"
#include "vtkVisibilityBuffer.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkLight;
class vtkOpenGLRenderWindow;
struct vtkShadowFrame;

class vtkShadowErrorEstimate
{
public:
  /** Whether this program has what it takes: the technique ray-traced. */
  static bool IsPossible();

  /**
   * Of a light's visibility, as vtkShadowPass::GetVisibility gives it, at receivers; see
   * vtkShadowPass::GetErrorEstimate. Null after an error.
   */
  nlohmann::ordered_json Make(const vtkShadowFrame& frame, vtkShadowReceivers& receivers,
    vtkImageData* visibility, const vtkLight* light);

  void Release(vtkOpenGLRenderWindow* window);

private:
  /** Pixels of one kind, and those of them that were chosen. */
  struct Stratum
  {
    std::vector<int> Pixels;
    std::size_t Chosen = 0; // the first ones
  };
  /** What is known of a chosen pixel. */
  struct Pixel
  {
    double Square = 0.0;     // of its error, in the mean
    double Difference = 0.0; // of V from the rays' mean
    double Truth = 0.0;
  };
  struct Figure
  {
    double Value = 0.0;
    double Margin = 0.0; // half of the 95 % interval
  };

  std::vector<float> Trace(vtkShadowFrame& frame, const char* seed);
  static Figure FindMean(const std::vector<Stratum>& strata, const std::vector<Pixel>& pixels,
    double Pixel::*quantity, bool penumbraAlone);
  static nlohmann::ordered_json Describe(
    const std::vector<Stratum>& strata, const std::vector<Pixel>& pixels, bool penumbraAlone);

  vtkShadowSettings Settings;
  std::unique_ptr<vtkShadowTechnique> Rays;
  vtkShadowReceivers Receivers;
  vtkVisibilityBuffer Visibility;
};

#endif
