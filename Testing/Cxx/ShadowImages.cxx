#include "ShadowImages.h"

#include "ShadowTest.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

//------------------------------------------------------------------------------
std::size_t Visibility::GetNumberOfReceivers() const
{
  return std::count_if(this->Mask.begin(), this->Mask.end(), [](unsigned char m) { return m; });
}

//------------------------------------------------------------------------------
int Picture::Difference(const Picture& other, std::size_t pixel) const
{
  int largest = 0;
  for (std::size_t c = 3 * pixel; c < 3 * pixel + 3; ++c)
  {
    largest = std::max(largest, std::abs(int(this->RGB[c]) - int(other.RGB[c])));
  }
  return largest;
}

//------------------------------------------------------------------------------
Difference Compare(
  const Visibility& a, const Visibility& b, double threshold, const std::vector<unsigned char>& use)
{
  Difference result;
  if (a.V.size() != b.V.size() || a.Width != b.Width || a.V.empty())
  {
    ShadowTest::Check(false, "visibilities of different size, or empty");
    result.RMSE = result.Bias = result.Maximum = result.Share = result.MaskShare =
      std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  std::size_t differing = 0;
  std::size_t alone = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.Mask.size(); ++i)
  {
    if (!use.empty() && !use[i])
    {
      continue;
    }
    alone += (a.Mask[i] != 0) != (b.Mask[i] != 0);
    if (!a.Mask[i] || !b.Mask[i])
    {
      continue;
    }
    double largest = 0.0;
    for (int c = 0; c < a.Components; ++c)
    {
      const double signedDifference = double(a.V[i * a.Components + c]) - b.V[i * a.Components + c];
      result.Bias += signedDifference / a.Components;
      const double d = std::abs(signedDifference);
      largest = std::isnan(d) ? 1e9 : std::max(largest, d);
    }
    ++result.Pixels;
    sum += largest * largest;
    differing += largest > threshold;
    result.Maximum = std::max(result.Maximum, largest);
  }
  const auto pixels = static_cast<double>(result.Pixels);
  result.MaskShare = static_cast<double>(alone) / static_cast<double>(a.Mask.size());
  // No pixel to compare is no agreement: NaN passes no check.
  result.RMSE = std::sqrt(sum / pixels);
  result.Bias /= pixels;
  result.Share = static_cast<double>(differing) / pixels;
  return result;
}

//------------------------------------------------------------------------------
bool Same(const Visibility& a, const Visibility& b)
{
  return a.V.size() == b.V.size() && a.Mask == b.Mask &&
         std::memcmp(a.V.data(), b.V.data(), a.V.size() * sizeof(float)) == 0;
}

//------------------------------------------------------------------------------
bool Same(const Picture& a, const Picture& b)
{
  return a.RGB == b.RGB;
}

//------------------------------------------------------------------------------
std::pair<float, float> GetRange(const Visibility& visibility)
{
  std::pair<float, float> range(
    std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
  for (std::size_t i = 0; i < visibility.V.size(); ++i)
  {
    if (!visibility.Mask[i / visibility.Components])
    {
      continue;
    }
    const float v = visibility.V[i];
    if (std::isnan(v))
    {
      return { v, v };
    }
    range = { std::min(range.first, v), std::max(range.second, v) };
  }
  return range;
}
