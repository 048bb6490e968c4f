// SPDX-License-Identifier: BSD-3-Clause
#include "ExtremeField.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
double GetDifference(float a, float b)
{
  const double difference = static_cast<double>(a) - b;
  return std::isfinite(difference) ? difference : 1.0;
}

bool IsUsed(const ExtremeField& a, const ExtremeField& b, const ExtremeField& mask, std::size_t i)
{
  return a.Receives[i] && b.Receives[i] && (mask.IsEmpty() || mask.Receives[i]);
}

// Whether all receivers around a pixel see all of the light, or nothing of it.
bool IsSettled(const ExtremeField& field, int x, int y)
{
  float least = 1.0f;
  float most = 0.0f;
  for (int dy = -1; dy <= 1; ++dy)
  {
    for (int dx = -1; dx <= 1; ++dx)
    {
      const int i = std::clamp(y + dy, 0, field.Height - 1) * field.Width +
                    std::clamp(x + dx, 0, field.Width - 1);
      least = field.Receives[i] ? std::min(least, field.V[i]) : least;
      most = field.Receives[i] ? std::max(most, field.V[i]) : most;
    }
  }
  return least > 0.99f || most < 0.01f;
}
}

//------------------------------------------------------------------------------
ExtremeField::ExtremeField(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  this->Width = size[0];
  this->Height = size[1];
  vtkDataArray* values = image->GetPointData()->GetArray("Visibility");
  vtkDataArray* receivers = image->GetPointData()->GetArray("Receiver");
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    this->V.push_back(static_cast<float>(values->GetComponent(i, 0)));
    this->Receives.push_back(receivers->GetComponent(i, 0) != 0.0);
  }
}

namespace ExtremeFields
{
//------------------------------------------------------------------------------
ExtremeDifference Compare(const ExtremeField& a, const ExtremeField& b, const ExtremeField& mask)
{
  ExtremeDifference result;
  if (a.V.size() != b.V.size() || (!mask.IsEmpty() && mask.V.size() != a.V.size()))
  {
    return { 1.0, 1.0, 1.0, 1.0 };
  }
  double squares = 0.0;
  double sum = 0.0;
  std::size_t pixels = 0;
  std::size_t wrong = 0;
  std::size_t alone = 0;
  for (std::size_t i = 0; i < a.V.size(); ++i)
  {
    alone += a.Receives[i] != b.Receives[i] ? 1 : 0;
    if (!IsUsed(a, b, mask, i))
    {
      continue;
    }
    ++pixels;
    const double difference = GetDifference(a.V[i], b.V[i]);
    squares += difference * difference;
    sum += difference;
    const int x = static_cast<int>(i) % b.Width;
    const int y = static_cast<int>(i) / b.Width;
    wrong += std::abs(difference) >= 0.5 && IsSettled(b, x, y) ? 1 : 0;
  }
  const double count = std::max<double>(1.0, static_cast<double>(pixels));
  result.RMSE = std::sqrt(squares / count);
  result.Bias = sum / count;
  result.Wrong = static_cast<double>(wrong) / count;
  result.MaskShare = static_cast<double>(alone) / std::max<std::size_t>(1, a.V.size());
  return result;
}

//------------------------------------------------------------------------------
double CompareChanges(const ExtremeField& a, const ExtremeField& a0, const ExtremeField& b,
  const ExtremeField& b0, const ExtremeField& mask)
{
  double squares = 0.0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < a.V.size(); ++i)
  {
    if (IsUsed(a, a0, mask, i) && IsUsed(b, b0, mask, i))
    {
      const double off = GetDifference(a.V[i], a0.V[i]) - GetDifference(b.V[i], b0.V[i]);
      squares += off * off;
      ++pixels;
    }
  }
  return std::sqrt(squares / std::max<double>(1.0, static_cast<double>(pixels)));
}
}
