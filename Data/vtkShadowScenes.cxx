// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowScenes.h"

#include "ShadowSceneBuilders.h"
#include "ShadowSceneBunny.h"
#include "ShadowSceneStage.h"

#include "vtkAreaLight.h"
#include "vtkBoundingBox.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShadowVTKVersion.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
//------------------------------------------------------------------------------
struct Scene
{
  const char* Name;
  const char* Title;
  void (*Build)(vtkRenderer* renderer, int triangles);
  int Triangles; // of the whole scene at its defaults; 0: depends on VTK's version
  int Minimum;   // range of the parameter triangles, whose default is Triangles; 0, 0: no parameter
  int Maximum;
};

using namespace ShadowSceneBuilders;
const Scene Scenes[] = {
  { "basic", "Mixed solids at different heights over a floor", Basic, 17408, 0, 0 },
  { "huge", "Seven subdivided bunnies on and above a floor", Huge, 114109, 0, 0 },
  { "bunny", "One bunny on a floor", Bunny, 3676, 0, 0 },
  { "blocker", "Square blocker under a rectangular light, with a closed form", Blocker, 4, 0, 0 },
  { "cylinder", "A standing column, a lying one and leaning pipes", Cylinder, 1314, 0, 0 },
  { "tree", "A bare tree: thousands of thin branches", Tree, 35638, 0, 0 },
  { "boxes", "A heap of overlapping boxes", Boxes, 1802, 0, 0 },
  { "plant", "An industrial plant: pipes, beams, tanks", Plant, 100000, 10000, 2000000 },
  { "isosurface", "An isosurface: a gyroid ball", Isosurface, 0, 0, 0 },
  { "streamtubes", "Stream tubes of a tornado", Streamtubes, 0, 0, 0 },
  { "molecule", "A double helix and a fullerene of spheres and tubes", Molecule, 48450, 0, 0 },
  { "grid", "A large grid of bars over a floor, up to the horizon", Grid, 166, 0, 0 },
  { "figure", "A scientist's figure: isosurface, tubes, arrows, slice", Figure, 0, 0, 0 },
  { "terrain", "Noise terrain under a low sun", Terrain, 64800, 0, 0 },
  { "scan", "A scanned body: uneven triangles, noise of several scales, no normals", Scan, 199694,
    0, 0 },
};

//------------------------------------------------------------------------------
const Scene* FindScene(const std::string& name)
{
  const auto* found = std::find_if(std::begin(Scenes), std::end(Scenes),
    [&name](const Scene& scene) { return name == scene.Name; });
  if (found != std::end(Scenes))
  {
    return found;
  }
  std::string known;
  for (const Scene& scene : Scenes)
  {
    known += (known.empty() ? "" : ", ") + std::string(scene.Name);
  }
  vtkErrorWithObjectMacro(
    nullptr, "There is no scene \"" << name << "\". The scenes are: " << known << ".");
  return nullptr;
}

//------------------------------------------------------------------------------
bool CheckAxis(int upAxis)
{
  if (upAxis < 0 || upAxis > 2)
  {
    vtkErrorWithObjectMacro(nullptr, "The up axis must be 0, 1 or 2, not " << upAxis << ".");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
// Bounds of what is visible, grounds left out unless there is nothing else.
bool GetModelBounds(vtkRenderer* renderer, const char* purpose, double bounds[6])
{
  if (!renderer)
  {
    vtkErrorWithObjectMacro(nullptr, "There is no renderer to " << purpose << ".");
    return false;
  }
  vtkBoundingBox model;
  vtkBoundingBox ground;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (!prop->GetVisibility() || !prop->GetUseBounds())
    {
      continue;
    }
    const double* own = prop->GetBounds();
    if (own && vtkMath::AreBoundsInitialized(own) &&
        std::all_of(own, own + 6, [](double value) { return std::isfinite(value); }))
    {
      vtkInformation* keys = prop->GetPropertyKeys();
      const bool isGround = keys && keys->Get(vtkShadowScenes::GROUND());
      (isGround ? ground : model).AddBounds(own);
    }
  }
  const vtkBoundingBox& box = model.IsValid() ? model : ground;
  if (!box.IsValid())
  {
    vtkErrorWithObjectMacro(nullptr, "There is nothing visible to " << purpose << ".");
    return false;
  }
  box.GetBounds(bounds);
  return true;
}

//------------------------------------------------------------------------------
// Fraction of the interval [-half, half] that [low, high] covers; of a point: whether it is inside.
double CoveredFraction(double half, double low, double high)
{
  if (half <= 0.0)
  {
    return low < 0.0 && high > 0.0 ? 1.0 : 0.0;
  }
  return std::max(0.0, std::min(half, high) - std::max(-half, low)) / (2.0 * half);
}
}

vtkStandardNewMacro(vtkShadowScenes);
vtkInformationKeyMacro(vtkShadowScenes, GROUND, Integer);

//------------------------------------------------------------------------------
int vtkShadowScenes::GetNumberOfScenes()
{
  return static_cast<int>(std::size(Scenes));
}

//------------------------------------------------------------------------------
const char* vtkShadowScenes::GetName(int i)
{
  return i >= 0 && i < vtkShadowScenes::GetNumberOfScenes() ? Scenes[i].Name : nullptr;
}

//------------------------------------------------------------------------------
std::string vtkShadowScenes::Describe(const std::string& name)
{
  const Scene* scene = FindScene(name);
  if (!scene)
  {
    return std::string();
  }
  nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
  if (scene->Maximum > 0)
  {
    parameters.push_back({ { "name", "triangles" }, { "default", scene->Triangles },
      { "min", scene->Minimum }, { "max", scene->Maximum } });
  }
  nlohmann::ordered_json description;
  description["name"] = scene->Name;
  description["title"] = scene->Title;
  description["triangles"] = nullptr;
  if (scene->Triangles > 0)
  {
    description["triangles"] = scene->Triangles;
  }
  description["parameters"] = parameters;
  return description.dump();
}

//------------------------------------------------------------------------------
bool vtkShadowScenes::Build(const std::string& name, vtkRenderer* renderer, int triangles)
{
  const Scene* scene = FindScene(name);
  if (!scene)
  {
    return false;
  }
  if (!renderer)
  {
    vtkErrorWithObjectMacro(nullptr, "There is no renderer to build scene " << name << " in.");
    return false;
  }
  if (triangles != 0 && scene->Maximum == 0)
  {
    vtkErrorWithObjectMacro(
      nullptr, "Scene " << name << " has no parameter triangles: " << triangles << " is ignored.");
    triangles = 0;
  }
  else if (triangles != 0 && (triangles < scene->Minimum || triangles > scene->Maximum))
  {
    vtkErrorWithObjectMacro(nullptr, "Scene " << name << " takes " << scene->Minimum << " to "
                                              << scene->Maximum << " triangles, not " << triangles
                                              << ": it is built with " << scene->Triangles << ".");
    triangles = 0;
  }

  ShadowSceneBunny::ClearNote();
  scene->Build(renderer, triangles != 0 ? triangles : scene->Triangles);
  renderer->AutomaticLightCreationOff();
  renderer->GradientBackgroundOff();
  renderer->SetBackground(0.87, 0.88, 0.90);
  renderer->ResetCameraClippingRange();
  return true;
}

//------------------------------------------------------------------------------
std::string vtkShadowScenes::GetModelNote()
{
  return ShadowSceneBunny::GetNote();
}

//------------------------------------------------------------------------------
bool vtkShadowScenes::AddGround(vtkRenderer* renderer, int upAxis)
{
  double bounds[6];
  if (!CheckAxis(upAxis) || !GetModelBounds(renderer, "put a ground under", bounds))
  {
    return false;
  }
  const int first = (upAxis + 1) % 3;
  const int second = (upAxis + 2) % 3;
  const double height = bounds[2 * upAxis + 1] - bounds[2 * upAxis];
  double side = 6.0 * std::max(bounds[2 * first + 1] - bounds[2 * first],
                        bounds[2 * second + 1] - bounds[2 * second]);
  side = side > 0.0 ? side : std::max(height, 1.0);
  vtkVector3d center(
    0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]));
  // Under a thing without height the ground keeps a small distance, or the two would be one.
  center[upAxis] = bounds[2 * upAxis] - (height > 0.0 ? 0.0 : 1e-3 * side);

  ShadowSceneStage::AddSquare(renderer, center, 0.5 * side, upAxis);
  renderer->ResetCameraClippingRange();
  return true;
}

//------------------------------------------------------------------------------
vtkAreaLight* vtkShadowScenes::AddLight(vtkRenderer* renderer, int upAxis)
{
  double bounds[6];
  if (!CheckAxis(upAxis) || !GetModelBounds(renderer, "light", bounds))
  {
    return nullptr;
  }
  const ShadowSceneStage::Frame frame = ShadowSceneStage::GetFrame(upAxis);
  const vtkVector3d low(bounds[0], bounds[2], bounds[4]);
  const vtkVector3d high(bounds[1], bounds[3], bounds[5]);
  const vtkVector3d center = 0.5 * (low + high);
  double diagonal = (high - low).Norm();
  diagonal = diagonal > 0.0 ? diagonal : 1.0;
  double height = high[upAxis] - low[upAxis];
  height = height > 0.0 ? height : 0.5 * diagonal;
  const vtkVector3d direction =
    (-0.75 * frame.Right + 0.45 * frame.Front + 1.2 * frame.Up).Normalized();
  return ShadowSceneStage::AddSphereLight(
    renderer, center + 2.0 * diagonal * direction, center, 0.12 * height);
}

//------------------------------------------------------------------------------
void vtkShadowScenes::ResetCamera(vtkRenderer* renderer, int upAxis)
{
  double bounds[6];
  if (!CheckAxis(upAxis) || !GetModelBounds(renderer, "point the camera at", bounds))
  {
    return;
  }
  const ShadowSceneStage::Frame frame = ShadowSceneStage::GetFrame(upAxis);
  ShadowSceneStage::FitCamera(
    renderer, bounds, 0.55 * frame.Right + frame.Front + 0.65 * frame.Up, frame.Up, 1.25);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void vtkShadowScenes::ResetCameraWithShadow(vtkRenderer* renderer, int upAxis)
{
  double bounds[6];
  if (!CheckAxis(upAxis) || !GetModelBounds(renderer, "point the camera at", bounds))
  {
    return;
  }
  // The studio's key stands 40 degrees to the camera's left and 50 degrees high.
  const ShadowSceneStage::Frame frame = ShadowSceneStage::GetFrame(upAxis);
  const vtkVector3d direction = 0.55 * frame.Right + frame.Front + 0.65 * frame.Up;
  const vtkVector3d front = (0.55 * frame.Right + frame.Front).Normalized();
  const vtkVector3d right = frame.Up.Cross(front);
  const double azimuth = vtkMath::RadiansFromDegrees(-40.0);
  const double height = bounds[2 * upAxis + 1] - bounds[2 * upAxis];
  const vtkVector3d reach = (-height / std::tan(vtkMath::RadiansFromDegrees(50.0))) *
                            (std::cos(azimuth) * front + std::sin(azimuth) * right);
  vtkBoundingBox box(bounds);
  for (int corner = 0; corner < 4; ++corner)
  {
    double point[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int side = axis == upAxis ? 0 : (axis == (upAxis + 1) % 3 ? corner & 1 : corner >> 1);
      point[axis] = bounds[2 * axis + side] + reach[axis];
    }
    box.AddPoint(point);
  }
  box.GetBounds(bounds);
  ShadowSceneStage::FitCamera(renderer, bounds, direction, frame.Up, 1.1);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
double vtkShadowScenes::BlockerVisibility(double x, double y)
{
  return vtkShadowScenes::RectangleVisibility(BlockerLightHalfSide, BlockerLightHalfSide,
    BlockerLightHeight, BlockerHalfSide, BlockerHeight, x, y);
}

//------------------------------------------------------------------------------
double vtkShadowScenes::RectangleVisibility(double lightHalfWidth, double lightHalfHeight,
  double lightHeight, double blockerHalfSide, double blockerHeight, double x, double y)
{
  if (blockerHalfSide <= 0.0 || blockerHeight >= lightHeight || lightHeight <= 0.0 ||
      blockerHeight < 0.0)
  {
    return 1.0; // no blocker between light and floor
  }
  if (blockerHeight == 0.0)
  {
    return std::max(std::abs(x), std::abs(y)) < blockerHalfSide ? 0.0 : 1.0; // it lies on the floor
  }
  // The blocker's shadow on the light's plane, cast from the floor point.
  const double scale = lightHeight / blockerHeight;
  const double coveredX = CoveredFraction(
    lightHalfWidth, x + scale * (-blockerHalfSide - x), x + scale * (blockerHalfSide - x));
  const double coveredY = CoveredFraction(
    lightHalfHeight, y + scale * (-blockerHalfSide - y), y + scale * (blockerHalfSide - y));
  return 1.0 - coveredX * coveredY;
}

//------------------------------------------------------------------------------
void vtkShadowScenes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scenes:";
  for (const Scene& scene : Scenes)
  {
    os << " " << scene.Name;
  }
  os << "\n";
}
