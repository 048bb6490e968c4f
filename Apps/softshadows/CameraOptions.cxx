// SPDX-License-Identifier: BSD-3-Clause
#include "CameraOptions.h"

#include "Errors.h"
#include "Values.h"

#include "vtkCamera.h"
#include "vtkMath.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <limits>

//------------------------------------------------------------------------------
void CameraOptions::Declare(CLI::App& command)
{
  const auto triple =
    [&](const char* name, std::optional<std::array<double, 3>>& value, const char* meaning)
  { Values::AddTriple(command, name, value, "X,Y,Z", meaning)->group("Camera"); };
  const auto number = [&](const char* name, std::optional<double>& value,
                        const std::array<double, 2>& range, const char* meaning)
  { Values::AddNumber(command, name, value, range, meaning)->type_name("X")->group("Camera"); };
  triple("--camera-position", this->Position, "Where the camera is");
  triple("--camera-target", this->Target, "What it looks at");
  triple("--view-up", this->ViewUp, "The way up in the picture");
  number("--view-angle", this->ViewAngle, { 1e-3, 179.0 },
    "How much it sees from the lower to the upper edge, in degrees");
  number("--parallel-scale", this->ParallelScale,
    { std::numeric_limits<float>::min(), std::numeric_limits<float>::max() },
    "Half the picture's height in units of the scene, without perspective");
}

//------------------------------------------------------------------------------
void CameraOptions::Apply(vtkCamera* camera) const
{
  if (this->Position)
  {
    camera->SetPosition(this->Position->data());
  }
  if (this->Target)
  {
    camera->SetFocalPoint(this->Target->data());
  }
  if (this->ViewUp)
  {
    camera->SetViewUp(this->ViewUp->data());
  }
  if (!(vtkMath::Distance2BetweenPoints(camera->GetPosition(), camera->GetFocalPoint()) > 0.0))
  {
    throw WrongUsage("the camera has no direction: --camera-position is its target.");
  }
  double up[3];
  double across[3];
  std::copy_n(this->ViewUp ? this->ViewUp->data() : camera->GetViewUp(), 3, up);
  vtkMath::Normalize(up);
  vtkMath::Cross(camera->GetDirectionOfProjection(), up, across);
  if (!(vtkMath::Norm(across) > 1e-9)) // VTK takes another way for none
  {
    throw WrongUsage("--view-up is the way that the camera looks, or no way at all.");
  }
  if (this->ViewAngle)
  {
    camera->SetViewAngle(*this->ViewAngle);
  }
  if (this->ParallelScale)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(*this->ParallelScale);
  }
}

//------------------------------------------------------------------------------
nlohmann::ordered_json DescribeCamera(vtkCamera* camera)
{
  const auto triple = [](const double* v) { return std::array<double, 3>{ v[0], v[1], v[2] }; };
  nlohmann::ordered_json json = { { "camera_position", triple(camera->GetPosition()) },
    { "camera_target", triple(camera->GetFocalPoint()) },
    { "view_up", triple(camera->GetViewUp()) } };
  if (camera->GetParallelProjection())
  {
    json["parallel_scale"] = camera->GetParallelScale();
  }
  else
  {
    json["view_angle"] = camera->GetViewAngle();
  }
  return json;
}
