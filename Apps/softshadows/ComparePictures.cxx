// SPDX-License-Identifier: BSD-3-Clause
// softshadows compare PICTURE REFERENCE.

#include "Compare.h"

#include "Errors.h"
#include "Inputs.h"
#include "Outputs.h"
#include "StandardOutput.h"

#include "vtkImageData.h"
#include "vtkImageFile.h"
#include "vtkNew.h"
#include "vtkPictureMetrics.h"
#include "vtkVisibilityMetrics.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace
{
namespace fs = std::filesystem;

void Read(const std::string& path, vtkImageData* image)
{
  Inputs::Check(path);
  if (!vtkImageFile::Read(path, image))
  {
    Messages::Check();
  }
}

// Throws what the metrics have reported, with the files' names instead of theirs.
void CheckMetrics(const std::string& path, const std::string& reference)
{
  const std::string error = Messages::TakeError();
  if (!error.empty())
  {
    const bool named = error.rfind("Cannot compare", 0) == 0 && error.find(": ") < error.size();
    throw Failure("cannot compare \"" + path + "\" with \"" + reference +
                  "\": " + (named ? error.substr(error.find(": ") + 2) : error) + ".");
  }
}

bool IsVisibility(const std::string& path, vtkImageData* image)
{
  return fs::path(path).extension() == ".exr" && image->GetNumberOfScalarComponents() == 1 &&
         image->GetScalarType() == VTK_FLOAT;
}
}

//------------------------------------------------------------------------------
bool IsPicture(const std::string& path)
{
  static const char* const known[] = { ".png", ".exr", ".tif", ".tiff", ".bmp" };
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return std::find(std::begin(known), std::end(known), extension) != std::end(known);
}

//------------------------------------------------------------------------------
void ComparePictures(const CompareOptions& options)
{
  const std::string& path = options.Scene.Models[0];
  const std::string& referencePath = options.Scene.Models[1];
  Outputs outputs({ path, referencePath });
  if (!options.Output.empty())
  {
    outputs.PlanPicture(options.Output, 3);
  }
  vtkNew<vtkImageData> image;
  vtkNew<vtkImageData> reference;
  Read(path, image);
  Read(referencePath, reference);

  vtkNew<vtkPictureMetrics> picture;
  picture->SetImage(image);
  picture->SetReference(reference);
  picture->Update();
  CheckMetrics(path, referencePath);
  const bool isVisibility = IsVisibility(path, image) && IsVisibility(referencePath, reference);
  vtkNew<vtkVisibilityMetrics> visibility;
  if (isVisibility)
  {
    visibility->SetImage(image);
    visibility->SetReference(reference);
    visibility->Update();
    CheckMetrics(path, referencePath);
  }
  if (!options.Output.empty())
  {
    outputs.StagePicture(options.Output,
      isVisibility ? visibility->GetDifferenceImage() : picture->GetDifferenceImage());
    outputs.Commit();
  }

  Messages::ShowWarnings();
  if (options.AsJson)
  {
    nlohmann::ordered_json json = { { "image", path }, { "reference", referencePath },
      { "picture", nlohmann::ordered_json::parse(picture->GetJSON()) } };
    if (isVisibility)
    {
      json["visibility"] = nlohmann::ordered_json::parse(visibility->GetJSON());
    }
    StandardOutput::Print(json);
    return;
  }
  std::printf("correct %.3f %%, RMSE %.6f, ", picture->GetCorrectness(), picture->GetRMSE());
  std::printf(
    std::isinf(picture->GetPSNR()) ? "PSNR infinite, " : "PSNR %.2f dB, ", picture->GetPSNR());
  std::printf("max %.6f over %lld pixels\n", picture->GetMaximum(),
    static_cast<long long>(picture->GetNumberOfPixels()));
  if (isVisibility)
  {
    std::printf("as visibility: RMSE %.6f, penumbra RMSE %.6f, bias %+.6f, P99 %.6f, max %.6f\n",
      visibility->GetRMSE(), visibility->GetPenumbraRMSE(), visibility->GetBias(),
      visibility->GetP99(), visibility->GetMaximum());
  }
}
