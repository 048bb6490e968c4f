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
#include "vtkSoftShadowsCoreModule.h" // For export macro
#include "vtkVisibilityBuffer.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkLight;
class vtkOpenGLRenderWindow;
struct vtkShadowFrame;

class VTKSOFTSHADOWSCORE_EXPORT vtkShadowErrorEstimate
{
public:
  /** Whether this program has what it takes: the technique ray-traced. */
  static bool IsPossible();

  /** A root mean square, and the ends of its 95 % interval; of no pixels, all are -1. */
  struct RMSE
  {
    double Value = -1.0;
    double Least = -1.0;
    double Most = -1.0;
  };
  /** A light's visibility as it is shown or tried: so many components a pixel. */
  struct Shown
  {
    std::vector<float> Values;
    int Components = 1;
  };

  /**
   * Choose some receivers by a light's visibility that is shown at them, and trace what is true. False after
   * an error.
   */
  bool Ask(const vtkShadowFrame& frame, vtkShadowReceivers& receivers, const Shown& shown,
    const vtkLight* light);
  /** How far a visibility of the same receivers is from that; see vtkShadowPass::GetErrorEstimate. */
  nlohmann::ordered_json Judge(const Shown& shown) const;
  /** The same in penumbrae, or where there are none, over all receivers. */
  RMSE FindError(const Shown& shown) const;

  /** The visibility of a light in a buffer that was filled, over all of its parts. */
  static Shown Read(
    const vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, const vtkLight* light);

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
    bool Known = false;
  };

  Shown Trace(vtkShadowFrame& frame, const vtkLight* light, const char* seed);
  std::vector<Pixel> FindPixels(const Shown& shown) const;
  static Figure FindMean(const std::vector<Stratum>& strata, const std::vector<Pixel>& pixels,
    double Pixel::*quantity, bool penumbraAlone);
  static nlohmann::ordered_json Describe(
    const std::vector<Stratum>& strata, const std::vector<Pixel>& pixels, bool penumbraAlone);

  std::vector<Stratum> Strata;
  std::vector<int> Pixels; // that were chosen, stratum by stratum
  Shown Truth[2];          // at these, by different rays; without values where no light is cast

  vtkShadowSettings Settings;
  std::unique_ptr<vtkShadowTechnique> Rays;
  vtkShadowReceivers Receivers;
  vtkVisibilityBuffer Visibility;
};

#endif
