// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPictureMetrics.h"

#include "vtkFloatArray.h"
#include "vtkImageMetricsPrivate.h"
#include "vtkObjectFactory.h"

#include <nlohmann/json.hpp>

#include <cstdlib>

vtkStandardNewMacro(vtkPictureMetrics);

namespace
{
using namespace vtkImageMetricsPrivate;

//------------------------------------------------------------------------------
// One input: its values, as bytes or as floats.
struct Input
{
  unsigned char* Bytes = nullptr;
  float* Floats = nullptr;
  int Components = 0;

  // Grey or RGB, without alpha.
  int GetNumberOfColors() const { return this->Components == 1 ? 1 : 3; }

  float GetValue(vtkIdType pixel, int c) const
  {
    const vtkIdType i = pixel * this->Components + c;
    return this->Bytes ? this->Bytes[i] / 255.0f : this->Floats[i];
  }

  unsigned char GetByte(vtkIdType pixel, int c) const
  {
    const vtkIdType i = pixel * this->Components + c;
    return this->Bytes ? this->Bytes[i] : ToByte(this->Floats[i]);
  }

  vtkIdType CountNotFinite(vtkIdType pixels) const
  {
    vtkIdType count = 0;
    for (vtkIdType i = 0; this->Floats && i < pixels * this->Components; ++i)
    {
      const bool color = i % this->Components < this->GetNumberOfColors();
      count += color && !std::isfinite(this->Floats[i]) ? 1 : 0;
    }
    return count;
  }
};

//------------------------------------------------------------------------------
// Returns an empty string, or why the image cannot be used.
std::string Open(vtkImageData* image, Input& input)
{
  vtkDataArray* pixels = nullptr;
  const std::string failure = FindPixels(image, nullptr, pixels);
  if (!failure.empty())
  {
    return failure;
  }
  vtkUnsignedCharArray* bytes = vtkUnsignedCharArray::SafeDownCast(pixels);
  vtkFloatArray* floats = vtkFloatArray::SafeDownCast(pixels);
  const int components = pixels->GetNumberOfComponents();
  if ((!bytes && !floats) || (components != 1 && components != 3 && components != 4))
  {
    return std::string("it is ") + pixels->GetDataTypeAsString() + " with " +
           std::to_string(components) + " components, not unsigned char or float with 1, 3 or 4";
  }
  input.Bytes = bytes ? bytes->GetPointer(0) : nullptr;
  input.Floats = floats ? floats->GetPointer(0) : nullptr;
  input.Components = components;
  return "";
}
}

//------------------------------------------------------------------------------
vtkPictureMetrics::vtkPictureMetrics()
{
  this->Reset();
}

//------------------------------------------------------------------------------
vtkPictureMetrics::~vtkPictureMetrics() = default;

//------------------------------------------------------------------------------
void vtkPictureMetrics::SetReference(vtkImageData* reference)
{
  if (this->Reference != reference)
  {
    this->Reference = reference;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkPictureMetrics::GetReference()
{
  return this->Reference;
}

//------------------------------------------------------------------------------
void vtkPictureMetrics::SetImage(vtkImageData* image)
{
  if (this->Image != image)
  {
    this->Image = image;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkPictureMetrics::GetImage()
{
  return this->Image;
}

//------------------------------------------------------------------------------
void vtkPictureMetrics::Reset()
{
  this->Correctness = this->RMSE = this->PSNR = this->Maximum = Unknown;
  this->NumberOfPixels = 0;
  this->DifferenceImage = nullptr;
}

//------------------------------------------------------------------------------
bool vtkPictureMetrics::Update()
{
  this->Reset();
  const std::string failure = this->Compare();
  if (!failure.empty())
  {
    this->Reset();
    vtkErrorMacro("Cannot compare pictures: " << failure << ".");
  }
  return failure.empty();
}

//------------------------------------------------------------------------------
std::string vtkPictureMetrics::Compare()
{
  Input image;
  Input reference;
  std::string failure = Open(this->Reference, reference);
  if (!failure.empty())
  {
    return "reference: " + failure;
  }
  failure = Open(this->Image, image);
  failure = failure.empty() ? CompareSizes(this->Image, this->Reference) : "image: " + failure;
  if (!failure.empty())
  {
    return failure;
  }
  const int colors = image.GetNumberOfColors();
  if (colors != reference.GetNumberOfColors())
  {
    return "the image has " + std::to_string(colors) + " colour channels, the reference " +
           std::to_string(reference.GetNumberOfColors());
  }
  const vtkIdType pixels = this->Reference->GetNumberOfPoints();
  const vtkIdType badInImage = image.CountNotFinite(pixels);
  const vtkIdType badInReference = reference.CountNotFinite(pixels);
  if (badInImage > 0 || badInReference > 0)
  {
    return std::to_string(badInImage) + " values of the image and " +
           std::to_string(badInReference) + " of the reference are NaN or infinite";
  }

  this->NumberOfPixels = pixels;

  vtkIdType correct = 0;
  double squares = 0.0;
  double maximum = 0.0;
  unsigned char* difference = NewDifferenceImage(this->Reference, this->DifferenceImage);
  for (vtkIdType pixel = 0; pixel < pixels; ++pixel, difference += 3)
  {
    float worst = 0.0f;
    for (int c = 0; c < colors; ++c)
    {
      const int bytes = image.GetByte(pixel, c) - reference.GetByte(pixel, c);
      correct += std::abs(bytes) <= this->Tolerance ? 1 : 0;
      const float error = image.GetValue(pixel, c) - reference.GetValue(pixel, c);
      squares += static_cast<double>(error) * error;
      worst = std::abs(error) > std::abs(worst) ? error : worst;
    }
    maximum = std::max(maximum, static_cast<double>(std::abs(worst)));
    DifferenceColor(worst, this->DifferenceScale, difference);
  }
  this->RMSE = std::sqrt(squares / (static_cast<double>(pixels) * colors));
  this->Maximum = maximum;
  this->PSNR =
    this->RMSE > 0.0 ? -20.0 * std::log10(this->RMSE) : std::numeric_limits<double>::infinity();
  this->Correctness = 100.0 * static_cast<double>(correct) / (static_cast<double>(pixels) * colors);
  return "";
}

//------------------------------------------------------------------------------
std::string vtkPictureMetrics::GetJSON()
{
  const nlohmann::ordered_json json = {
    { "pixels", this->NumberOfPixels },
    { "tolerance", this->Tolerance },
    { "correctness_percent", this->Correctness },
    { "rmse", this->RMSE },
    { "psnr_db", this->PSNR },
    { "maximum", this->Maximum },
    { "equal", this->Maximum == 0.0 },
  };
  return json.dump();
}

//------------------------------------------------------------------------------
vtkImageData* vtkPictureMetrics::GetDifferenceImage()
{
  return this->DifferenceImage;
}

//------------------------------------------------------------------------------
void vtkPictureMetrics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Reference: " << this->Reference.Get() << "\n";
  os << indent << "Image: " << this->Image.Get() << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "DifferenceScale: " << this->DifferenceScale << "\n";
  os << indent << "Figures: " << this->GetJSON() << "\n";
}
