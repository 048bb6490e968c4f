// SPDX-License-Identifier: BSD-3-Clause
#include "ViewSnapshot.h"

#include "Errors.h"
#include "Outputs.h"
#include "StandardOutput.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkWindowToImageFilter.h"

#include <cstdio>
#include <filesystem>

namespace ViewSnapshot
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Grab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->SetInputBufferTypeToRGB();
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  grabber->Update();
  Messages::Check("the picture cannot be read back");
  return grabber->GetOutput();
}

//------------------------------------------------------------------------------
std::string Write(
  vtkImageData* picture, vtkImageData* visibility, const nlohmann::ordered_json& settings)
{
  constexpr int most = 999999;
  for (int number = 1; number <= most; ++number)
  {
    char name[40];
    std::snprintf(name, sizeof(name), "softshadows-%03d", number);
    const std::string files[] = { std::string(name) + ".png", std::string(name) + "-visibility.exr",
      std::string(name) + ".json" };
    bool taken = false;
    for (const std::string& file : files)
    {
      std::error_code ignored;
      taken = taken || std::filesystem::exists(std::filesystem::symlink_status(file, ignored));
    }
    if (taken)
    {
      continue;
    }
    Outputs outputs({});
    outputs.PlanPicture(files[0], 3);
    outputs.PlanText(files[2]);
    outputs.StagePicture(files[0], picture);
    if (visibility)
    {
      outputs.PlanPicture(files[1], visibility->GetNumberOfScalarComponents());
      outputs.StagePicture(files[1], visibility);
    }
    outputs.StageText(files[2], StandardOutput::GetText(settings));
    outputs.Commit();
    return name;
  }
  throw Failure("a snapshot has no name left: softshadows-999999 is there.");
}
}
