// SPDX-License-Identifier: BSD-3-Clause
// The viewer's text: what is seen, and what it took.

#ifndef ViewText_h
#define ViewText_h

#include "ViewModel.h"

#include <string>

/** What a frame took. */
struct ViewFigures
{
  double Milliseconds = 0.0; // of the last frame
  double Rate = 0.0;         // frames a second, over the last ones
  nlohmann::ordered_json Statistics;
  nlohmann::ordered_json Error; // as vtkShadowPass::GetErrorEstimate gives it; null: none
  long long Triangles = 0;
  int Size[2] = { 0, 0 };
};

namespace ViewText
{
/** Technique, parameters, figures. */
std::string DescribeFrame(const ViewModel& model, const ViewFigures& figures);

/** Milliseconds of the GPU in a frame, as its statistics tell. */
double GetGPUMilliseconds(const nlohmann::ordered_json& statistics);

std::string Format(double number, int digits);
}

#endif
