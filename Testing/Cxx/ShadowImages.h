// SPDX-License-Identifier: BSD-3-Clause
// Visibilities and pictures, and how they differ.

#ifndef ShadowImages_h
#define ShadowImages_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/** Visibility of one light at the pixels of a viewport, row by row from the bottom. */
struct Visibility
{
  int Width = 0;
  int Height = 0;
  int Components = 1;
  std::vector<float> V; // Components a pixel
  std::vector<unsigned char> Mask;

  float operator()(int x, int y) const { return this->V[y * this->Width + x]; }
  std::size_t GetNumberOfReceivers() const;
};

/** 8-bit RGB, row by row from the bottom. */
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> RGB;

  /** The largest difference of a channel at a pixel. */
  int Difference(const Picture& other, std::size_t pixel) const;
};

/** How two visibilities differ, over the pixels that are receivers in both. */
struct Difference
{
  double RMSE = 0.0;
  double Bias = 0.0; // mean of a - b
  double Maximum = 0.0;
  double Share = 0.0;     // of pixels that differ by more than the threshold
  double MaskShare = 0.0; // of all pixels: receivers in one of both alone
  std::size_t Pixels = 0;
};

/** A NaN differs from everything. Pixels where `use` is 0 do not count. */
Difference Compare(const Visibility& a, const Visibility& b, double threshold = 0.1,
  const std::vector<unsigned char>& use = {});
/** Values and mask are the same bit by bit. */
bool Same(const Visibility& a, const Visibility& b);
bool Same(const Picture& a, const Picture& b);

/** A part of a picture. */
Picture Crop(const Picture& picture, int x, int y, int width, int height);

/** What all pixels around one have in common, by as far as an effect on the picture reaches. */
enum class Region : unsigned char
{
  Mixed,
  Lit, // V is 1 throughout, or nothing receives
  Dark // V is 0 throughout
};
/** Pixels where `use` is 0, and those nearer to the picture's border than the reach, are mixed. */
std::vector<Region> GetRegions(
  const Visibility& visibility, int reach = 0, const std::vector<unsigned char>& use = {});
/**
 * What every way of drawing must keep to: lit pixels are those of the plain picture, and dark ones
 * those of the picture with the light all but out, to 1/255. There are at least so many of both, and
 * the dark ones of them that the light would show are darker than the plain picture.
 */
void CheckShadowed(const Picture& picture, const Picture& plain, const Picture& out,
  const std::vector<Region>& regions, double leastLit, double leastDark, const std::string& what);

/** The lowest and highest V of the receivers; NaN where one is NaN. */
std::pair<float, float> GetRange(const Visibility& visibility);

#endif
