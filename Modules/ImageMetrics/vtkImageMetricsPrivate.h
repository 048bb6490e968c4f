// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the classes of this module share: checking images, conversion to 8 bits, the colours of
 * signed difference maps. Not installed, not wrapped.
 */

#ifndef vtkImageMetricsPrivate_h
#define vtkImageMetricsPrivate_h

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vtkImageMetricsPrivate
{
/// Figures that are not known: before Update, and after one that failed. JSON shows null.
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

/// 8-bit value of a picture's float in [0,1]: clamped, rounded to nearest; NaN becomes 0.
inline unsigned char ToByte(float value)
{
  return value > 0.0f ? static_cast<unsigned char>(std::min(value, 1.0f) * 255.0f + 0.5f)
                      : static_cast<unsigned char>(0);
}
inline unsigned char ToByte(unsigned char value)
{
  return value;
}

/// "640 x 480", for messages.
inline std::string SizeText(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  return std::to_string(size[0]) + " x " + std::to_string(size[1]);
}

/**
 * Find the pixels of a flat image: the named array if there is one, else the active scalars.
 * Returns an empty string, or the reason why there are none.
 */
inline std::string FindPixels(vtkImageData* image, const char* name, vtkDataArray*& pixels)
{
  pixels = nullptr;
  if (!image)
  {
    return "there is no image";
  }
  const int* size = image->GetDimensions();
  if (size[0] < 1 || size[1] < 1 || size[2] < 1)
  {
    return "the image is empty";
  }
  if (size[2] != 1)
  {
    return "the image is a volume of " + std::to_string(size[2]) + " slices, not one picture";
  }
  vtkPointData* data = image->GetPointData();
  pixels = name ? data->GetArray(name) : nullptr;
  pixels = pixels ? pixels : data->GetScalars();
  if (!pixels)
  {
    return "the image has no pixels (no active point scalars)";
  }
  if (pixels->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return "the image has " + std::to_string(pixels->GetNumberOfTuples()) + " pixels where " +
           SizeText(image) + " asks for " + std::to_string(image->GetNumberOfPoints());
  }
  return "";
}

/// Reason why two images cannot be compared pixel by pixel, or an empty string.
inline std::string CompareSizes(vtkImageData* image, vtkImageData* reference)
{
  const int* a = image->GetDimensions();
  const int* b = reference->GetDimensions();
  return a[0] == b[0] && a[1] == b[1]
           ? ""
           : "the image is " + SizeText(image) + ", the reference " + SizeText(reference);
}

/// Colours of a signed difference: blue below, white at, red above zero; full at +-scale.
inline void DifferenceColor(double difference, double scale, unsigned char rgb[3])
{
  const float t = static_cast<float>(std::min(std::abs(difference) / scale, 1.0));
  const unsigned char faded = ToByte(1.0f - t);
  rgb[0] = difference < 0.0 ? faded : 255;
  rgb[1] = faded;
  rgb[2] = difference > 0.0 ? faded : 255;
}

/// An RGB image of the size, origin and spacing of another; returns where its bytes lie.
inline unsigned char* NewDifferenceImage(vtkImageData* like, vtkSmartPointer<vtkImageData>& image)
{
  image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(like);
  vtkSmartPointer<vtkUnsignedCharArray> colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Difference");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(like->GetNumberOfPoints());
  image->GetPointData()->SetScalars(colors);
  return colors->GetPointer(0);
}
}

#endif
