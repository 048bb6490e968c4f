// SPDX-License-Identifier: BSD-3-Clause
// What is drawn and how it is lit, as the command line says it: the same for every subcommand.

#ifndef SceneOptions_h
#define SceneOptions_h

#include "CameraOptions.h"
#include "Errors.h"

#include "vtkType.h"

#include <nlohmann/json.hpp>

#include <array>
#include <functional>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
}
class OffscreenWindow;
class vtkAreaLight;
class vtkRenderer;

/** Options of the light; what is not given stays as the scene has it, or as AddLight makes it. */
struct LightOptions
{
  std::string Shape;
  std::optional<double> Radius;
  std::optional<double> Width;
  std::optional<double> Height;
  std::optional<double> Angle;
  std::optional<std::array<double, 3>> Position;
  std::optional<std::array<double, 3>> Target;
  // Of --light alone.
  std::optional<std::array<double, 3>> Color;
  std::optional<double> Intensity;

  /** The options of the scene's light, --light-... . */
  void Declare(CLI::App& command);
  /** The options of several, --light, each of which adds to `lights`. */
  static void DeclareMany(CLI::App& command, std::vector<LightOptions>& lights);
  /** Failure for a value that no light has. */
  void Check() const;
  /** Whether any is given. */
  bool IsAny() const;
  /** A new shape keeps the area that the light had, unless its size is given. */
  void Apply(vtkAreaLight* light) const;
};

/** A scene that was set up. */
struct Scene
{
  std::string Name; // of the built-in scene, or the model files
  vtkAreaLight* Light = nullptr;
  std::vector<vtkAreaLight*> Lights; // that one, and those that --light adds
  vtkIdType Triangles = 0;

  /** Of its lights the first. */
  nlohmann::ordered_json GetJSON() const;
};

struct SceneOptions
{
  std::vector<std::string> Models;
  std::string Builtin;
  int Triangles = 0;
  bool Ground = false;
  std::string Up;
  double Turn = 0.0;
  CameraOptions Camera;
  LightOptions Light;
  std::vector<LightOptions> Lights; // in the place of the scene's, where there are any
  bool ShowLights = false;
  /** Samples that each light is shown with. */
  int ShownSamples = 64;
  std::array<int, 2> Size = { 900, 700 };
  std::optional<std::array<double, 3>> Background;
  int SamplesPerPixel = 0;
  /** Models whose light no option names stand in a studio (vtkShadowStudio). */
  bool Studio = false;
  std::optional<std::array<double, 3>> StudioKey;
  std::optional<double> StudioSoftness;

  /** Told what is loaded next, and its number of how many. */
  std::function<void(const std::string&, std::size_t, std::size_t)> Progress;

  bool UsesStudio() const;
  /** The axis that points up: 0, 1 or 2. */
  int GetUpAxis() const;

  /** All options, and the models as positional arguments. */
  void Declare(CLI::App& command);
  /** WrongUsage or Failure for options that cannot be; nothing is read yet. */
  void Check() const;
  /** Set up the renderer; what needs to be said is left with Messages. */
  Scene Build(vtkRenderer* renderer) const;

private:
  void PlaceLights(vtkRenderer* renderer, std::vector<vtkAreaLight*>& lights) const;
};

/** Do work; where memory is at its end, a Failure tells the size of the picture that it was for. */
template <typename Function>
void WithinMemory(const std::array<int, 2>& size, Function function)
{
  try
  {
    function();
  }
  catch (const std::bad_alloc&)
  {
    throw Failure("out of memory, for a picture of --size " + std::to_string(size[0]) + "x" +
                  std::to_string(size[1]) + ".");
  }
}

/** A directional light shines the same from anywhere: put it beside the scene, to be shown there. */
void PlaceBeside(vtkAreaLight* light, vtkRenderer* renderer);

/** Place, shape and sizes of a light. */
nlohmann::ordered_json DescribeLight(vtkAreaLight* light);

/** A light's shape in the words of the command line: point, sphere, disk, rectangle, directional. */
std::string GetShapeName(vtkAreaLight* light);

#endif
