// SPDX-License-Identifier: BSD-3-Clause
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

//------------------------------------------------------------------------------
Picture Crop(const Picture& picture, int x, int y, int width, int height)
{
  Picture part;
  part.Width = width;
  part.Height = height;
  for (int row = 0; row < height; ++row)
  {
    const auto first = picture.RGB.begin() + 3 * ((y + row) * picture.Width + x);
    part.RGB.insert(part.RGB.end(), first, first + 3 * width);
  }
  return part;
}

//------------------------------------------------------------------------------
std::vector<Region> GetRegions(
  const Visibility& visibility, int reach, const std::vector<unsigned char>& use)
{
  const int width = visibility.Width;
  std::vector<Region> regions(visibility.Mask.size(), Region::Mixed);
  for (int y = reach; y < visibility.Height - reach; ++y)
  {
    for (int x = reach; x < width - reach; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      bool lit = use.empty() || use[pixel];
      bool dark = lit;
      for (int dy = -reach; dy <= reach; ++dy)
      {
        for (int dx = -reach; dx <= reach; ++dx)
        {
          const std::size_t i = pixel + dy * width + dx;
          for (int c = 0; c < visibility.Components; ++c)
          {
            const float v = visibility.V[i * visibility.Components + c];
            lit = lit && (v == 1.0f || !visibility.Mask[i]);
            dark = dark && v == 0.0f && visibility.Mask[i];
          }
        }
      }
      regions[pixel] = lit ? Region::Lit : (dark ? Region::Dark : Region::Mixed);
    }
  }
  return regions;
}

//------------------------------------------------------------------------------
void CheckShadowed(const Picture& picture, const Picture& plain, const Picture& out,
  const std::vector<Region>& regions, double leastLit, double leastDark, const std::string& what)
{
  if (!ShadowTest::Check(picture.RGB.size() == 3 * regions.size() &&
                           plain.RGB.size() == picture.RGB.size() &&
                           out.RGB.size() == picture.RGB.size(),
        what + ": pictures of different sizes"))
  {
    return;
  }
  int worst[2] = { 0, 0 };
  std::size_t count[2] = { 0, 0 };
  std::size_t notDarker = 0;
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    if (regions[i] != Region::Mixed)
    {
      const bool dark = regions[i] == Region::Dark;
      ++count[dark];
      worst[dark] = std::max(worst[dark], picture.Difference(dark ? out : plain, i));
      notDarker +=
        dark && plain.RGB[3 * i] > out.RGB[3 * i] + 4 && picture.RGB[3 * i] >= plain.RGB[3 * i];
    }
  }
  ShadowTest::CheckAtLeast(static_cast<double>(count[0]), leastLit, what + ", lit pixels");
  ShadowTest::CheckAtLeast(static_cast<double>(count[1]), leastDark, what + ", dark pixels");
  ShadowTest::CheckAtMost(worst[0], 1.0, what + ", lit: difference, of 255");
  ShadowTest::CheckAtMost(worst[1], 1.0, what + ", dark: difference, of 255");
  ShadowTest::CheckEqual(static_cast<double>(notDarker), 0.0, what + ", dark but no darker");
}
