// SPDX-License-Identifier: BSD-3-Clause
// The camera, as the command line says it.

#ifndef CameraOptions_h
#define CameraOptions_h

#include <nlohmann/json.hpp>

#include <array>
#include <optional>

namespace CLI
{
class App;
}
class vtkCamera;

/** Options of the camera; what is not given stays as the scene has it. */
struct CameraOptions
{
  std::optional<std::array<double, 3>> Position;
  std::optional<std::array<double, 3>> Target;
  std::optional<std::array<double, 3>> ViewUp;
  std::optional<double> ViewAngle;
  std::optional<double> ParallelScale;

  void Declare(CLI::App& command);
  /** WrongUsage where the camera would look nowhere, or along its own way up. */
  void Apply(vtkCamera* camera) const;
};

/** A camera, by the names of its options. */
nlohmann::ordered_json DescribeCamera(vtkCamera* camera);

#endif
