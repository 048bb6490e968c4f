// SPDX-License-Identifier: BSD-3-Clause
// Visibility of a frame as plain numbers, and how two differ.

#ifndef ExtremeField_h
#define ExtremeField_h

#include <vector>

class vtkImageData;

struct ExtremeField
{
  int Width = 0;
  int Height = 0;
  std::vector<float> V;
  std::vector<unsigned char> Receives;

  ExtremeField() = default;
  /** What vtkShadowPass::GetVisibility gives. */
  explicit ExtremeField(vtkImageData* image);
  bool IsEmpty() const { return this->V.empty(); }
};

/** Over the pixels that receive in both, and in `mask` where it is not empty. NaN counts as 1 off. */
struct ExtremeDifference
{
  double RMSE = 0.0;
  double Bias = 0.0;      // mean of a - b
  double Wrong = 0.0;     // share: b is 0, or 1, all around, and a is off by half or more
  double MaskShare = 0.0; // of all pixels, those that receive in one alone
};

namespace ExtremeFields
{
ExtremeDifference Compare(
  const ExtremeField& a, const ExtremeField& b, const ExtremeField& mask = {});

/** RMSE of (a - a0) - (b - b0). */
double CompareChanges(const ExtremeField& a, const ExtremeField& a0, const ExtremeField& b,
  const ExtremeField& b0, const ExtremeField& mask = {});
}

#endif
