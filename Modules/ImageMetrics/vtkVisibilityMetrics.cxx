// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisibilityMetrics.h"

#include "vtkFloatArray.h"
#include "vtkImageMetricsPrivate.h"
#include "vtkObjectFactory.h"

#include <nlohmann/json.hpp>

#include <vector>

vtkStandardNewMacro(vtkVisibilityMetrics);

namespace
{
using namespace vtkImageMetricsPrivate;

//------------------------------------------------------------------------------
// One input: its visibility, and its mask where it has one.
struct Input
{
  const float* Values = nullptr;
  const unsigned char* Mask = nullptr;
  const float* Cosine = nullptr; // N.L; none: 1
  int Components = 0;

  bool IsReceiver(vtkIdType pixel) const { return !this->Mask || this->Mask[pixel] != 0; }
};

//------------------------------------------------------------------------------
// Returns an empty string, or why the image cannot be used.
std::string Open(vtkImageData* image, Input& input)
{
  vtkDataArray* pixels = nullptr;
  const std::string failure = FindPixels(image, "Visibility", pixels);
  if (!failure.empty())
  {
    return failure;
  }
  vtkFloatArray* values = vtkFloatArray::SafeDownCast(pixels);
  input.Components = pixels->GetNumberOfComponents();
  if (!values || (input.Components != 1 && input.Components != 3))
  {
    return std::string("visibility is ") + pixels->GetDataTypeAsString() + " with " +
           std::to_string(input.Components) + " components, not float with 1 or 3";
  }
  input.Values = values->GetPointer(0);
  if (vtkDataArray* receiver = image->GetPointData()->GetArray("Receiver"))
  {
    vtkUnsignedCharArray* mask = vtkUnsignedCharArray::SafeDownCast(receiver);
    if (!mask || mask->GetNumberOfComponents() != 1 ||
        mask->GetNumberOfTuples() != pixels->GetNumberOfTuples())
    {
      return "its array \"Receiver\" is not one unsigned char a pixel";
    }
    input.Mask = mask->GetPointer(0);
  }
  if (vtkDataArray* cosine = image->GetPointData()->GetArray("Cosine"))
  {
    vtkFloatArray* weights = vtkFloatArray::SafeDownCast(cosine);
    if (!weights || weights->GetNumberOfComponents() != 1 ||
        weights->GetNumberOfTuples() != pixels->GetNumberOfTuples())
    {
      return "its array \"Cosine\" is not one float a pixel";
    }
    input.Cosine = weights->GetPointer(0);
  }
  return "";
}

//------------------------------------------------------------------------------
// Errors of a set of pixels, and what is made of them.
struct Errors
{
  std::vector<float> Values;
  double Weighted = 0.0; // sum of squares of errors times weights
  double Weights = 0.0;  // sum of squares of weights

  void Add(float error, double weight)
  {
    this->Values.push_back(error);
    this->Weighted += weight * weight * error * error;
    this->Weights += weight * weight;
  }
  /** 0 where nothing weighs anything. */
  double GetWeightedRMSE() const
  {
    return this->Weights > 0.0 ? std::sqrt(this->Weighted / this->Weights) : 0.0;
  }

  void Summarize(double& rmse, double& bias, double& p99, double& maximum)
  {
    rmse = bias = p99 = maximum = 0.0;
    const std::size_t count = this->Values.size();
    if (count == 0)
    {
      return;
    }
    for (float& value : this->Values)
    {
      bias += value;
      rmse += static_cast<double>(value) * value;
      value = std::abs(value);
    }
    bias /= static_cast<double>(count);
    rmse = std::sqrt(rmse / static_cast<double>(count));
    // Nearest rank: the smallest error that at least 99 % of all do not exceed.
    const auto rank =
      this->Values.begin() + static_cast<std::ptrdiff_t>((99 * count + 99) / 100) - 1;
    std::nth_element(this->Values.begin(), rank, this->Values.end());
    p99 = *rank;
    maximum = *std::max_element(rank, this->Values.end());
  }
};
}

//------------------------------------------------------------------------------
vtkVisibilityMetrics::vtkVisibilityMetrics()
{
  this->Reset();
}

//------------------------------------------------------------------------------
vtkVisibilityMetrics::~vtkVisibilityMetrics() = default;

//------------------------------------------------------------------------------
void vtkVisibilityMetrics::SetReference(vtkImageData* reference)
{
  if (this->Reference != reference)
  {
    this->Reference = reference;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkVisibilityMetrics::GetReference()
{
  return this->Reference;
}

//------------------------------------------------------------------------------
void vtkVisibilityMetrics::SetImage(vtkImageData* image)
{
  if (this->Image != image)
  {
    this->Image = image;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkVisibilityMetrics::GetImage()
{
  return this->Image;
}

//------------------------------------------------------------------------------
void vtkVisibilityMetrics::Reset()
{
  this->RMSE = this->Bias = this->P99 = this->Maximum = Unknown;
  this->WeightedRMSE = this->PenumbraWeightedRMSE = Unknown;
  this->PenumbraRMSE = this->PenumbraBias = this->PenumbraP99 = this->PenumbraMaximum = Unknown;
  this->NumberOfReceiverPixels = this->NumberOfPenumbraPixels = 0;
  this->DifferenceImage = nullptr;
}

//------------------------------------------------------------------------------
bool vtkVisibilityMetrics::Update()
{
  this->Reset();
  const std::string failure = this->Compare();
  if (!failure.empty())
  {
    this->Reset();
    vtkErrorMacro("Cannot compare visibility: " << failure << ".");
  }
  return failure.empty();
}

//------------------------------------------------------------------------------
std::string vtkVisibilityMetrics::Compare()
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
  const int components = image.Components;
  if (components != reference.Components)
  {
    return "the image has " + std::to_string(components) + " components, the reference " +
           std::to_string(reference.Components);
  }
  const float low = static_cast<float>(this->PenumbraRange[0]);
  const float high = static_cast<float>(this->PenumbraRange[1]);
  if (!(low <= high))
  {
    return "the penumbra range runs from " + std::to_string(low) + " to " + std::to_string(high);
  }

  const vtkIdType pixels = this->Reference->GetNumberOfPoints();
  unsigned char* colors = NewDifferenceImage(this->Reference, this->DifferenceImage);
  Errors all;
  Errors penumbra;
  all.Values.reserve(static_cast<std::size_t>(pixels) * components);
  vtkIdType badInImage = 0;
  vtkIdType badInReference = 0;
  for (vtkIdType pixel = 0; pixel < pixels; ++pixel, colors += 3)
  {
    if (!image.IsReceiver(pixel) || !reference.IsReceiver(pixel))
    {
      colors[0] = colors[1] = colors[2] = 128;
      continue;
    }
    ++this->NumberOfReceiverPixels;
    bool inPenumbra = false;
    const double weight = reference.Cosine ? std::max(0.0f, reference.Cosine[pixel]) : 1.0;
    float worst = 0.0f;
    for (int c = 0; c < components; ++c)
    {
      const float is = image.Values[pixel * components + c];
      const float ought = reference.Values[pixel * components + c];
      badInImage += std::isfinite(is) ? 0 : 1;
      badInReference += std::isfinite(ought) ? 0 : 1;
      const float error = is - ought;
      all.Add(error, weight);
      worst = std::abs(error) > std::abs(worst) ? error : worst;
      inPenumbra = inPenumbra || (ought >= low && ought <= high);
    }
    if (inPenumbra)
    {
      ++this->NumberOfPenumbraPixels;
      for (auto error = all.Values.end() - components; error != all.Values.end(); ++error)
      {
        penumbra.Add(*error, weight);
      }
    }
    DifferenceColor(worst, this->DifferenceScale, colors);
  }
  if (badInImage > 0 || badInReference > 0)
  {
    return std::to_string(badInImage) + " values of the image and " +
           std::to_string(badInReference) + " of the reference are NaN or infinite";
  }
  if (this->NumberOfReceiverPixels == 0)
  {
    return "no pixel is a receiver in both images";
  }
  all.Summarize(this->RMSE, this->Bias, this->P99, this->Maximum);
  penumbra.Summarize(
    this->PenumbraRMSE, this->PenumbraBias, this->PenumbraP99, this->PenumbraMaximum);
  this->WeightedRMSE = all.GetWeightedRMSE();
  this->PenumbraWeightedRMSE = penumbra.GetWeightedRMSE();
  return "";
}

//------------------------------------------------------------------------------
std::string vtkVisibilityMetrics::GetJSON()
{
  const nlohmann::ordered_json json = {
    { "receiver_pixels", this->NumberOfReceiverPixels },
    { "rmse", this->RMSE },
    { "bias", this->Bias },
    { "p99", this->P99 },
    { "maximum", this->Maximum },
    { "weighted_rmse", this->WeightedRMSE },
    { "penumbra",
      { { "range", { this->PenumbraRange[0], this->PenumbraRange[1] } },
        { "pixels", this->NumberOfPenumbraPixels }, { "rmse", this->PenumbraRMSE },
        { "bias", this->PenumbraBias }, { "p99", this->PenumbraP99 },
        { "maximum", this->PenumbraMaximum }, { "weighted_rmse", this->PenumbraWeightedRMSE } } },
  };
  return json.dump();
}

//------------------------------------------------------------------------------
vtkImageData* vtkVisibilityMetrics::GetDifferenceImage()
{
  return this->DifferenceImage;
}

//------------------------------------------------------------------------------
void vtkVisibilityMetrics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Reference: " << this->Reference.Get() << "\n";
  os << indent << "Image: " << this->Image.Get() << "\n";
  os << indent << "PenumbraRange: " << this->PenumbraRange[0] << " " << this->PenumbraRange[1]
     << "\n";
  os << indent << "DifferenceScale: " << this->DifferenceScale << "\n";
  os << indent << "Figures: " << this->GetJSON() << "\n";
}
