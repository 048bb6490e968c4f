// SPDX-License-Identifier: BSD-3-Clause
// Where the scene lies, its unit, and what else is there.

#include "ExtremeScenes.h"

#include "vtkCamera.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkRenderer.h"

namespace
{
void AddOrdinary(ExtremeScene& scene)
{
  scene.AddThings();
  scene.AddLight(ExtremeScene::Shape::Rectangle);
}

// Ten units are the scene's size.
glm::dvec3 GetOffset(const ExtremeValue& at)
{
  return 10.0 * at.Number * glm::dvec3(0.78, -0.54, 0.31);
}

//------------------------------------------------------------------------------
void UnitByPoints(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.PointScale = glm::dvec3(at.Number);
  AddOrdinary(scene);
}

void UnitByActors(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.ActorScale = glm::dvec3(at.Number);
  AddOrdinary(scene);
}

void UnitByMatrix(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.UserMatrix = true;
  UnitByActors(scene, at);
}

void UnitAgainst(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.PointScale = glm::dvec3(at.Number);
  scene.Place.ActorScale = glm::dvec3(1.0 / at.Number);
  AddOrdinary(scene);
}

void UnitUneven(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.PointScale = glm::dvec3(1.0, 1.0, at.Number);
  scene.Place.ActorScale = glm::dvec3(1.0, 1.0, 1.0 / at.Number);
  AddOrdinary(scene);
}

//------------------------------------------------------------------------------
void OriginByPoints(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.PointOffset = GetOffset(at);
  AddOrdinary(scene);
}

void OriginByFloats(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.Floats = true;
  OriginByPoints(scene, at);
}

void OriginUnshifted(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.ShiftScale = vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE;
  OriginByPoints(scene, at);
}

void OriginShifted(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.ShiftScale = vtkOpenGLVertexBufferObject::ALWAYS_AUTO_SHIFT_SCALE;
  OriginByPoints(scene, at);
}

void OriginByPosition(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.ActorOffset = GetOffset(at);
  AddOrdinary(scene);
}

void OriginByMatrix(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.UserMatrix = true;
  OriginByPosition(scene, at);
}

void OriginCancelling(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.Place.PointOffset = GetOffset(at);
  scene.Place.ActorOffset = -GetOffset(at);
  AddOrdinary(scene);
}

//------------------------------------------------------------------------------
// The light is in it, and it casts: but nothing that it could cast on.
void Sky(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  scene.AddSphere(glm::dvec3(0.0), 10.0 * at.Number);
}

void Ground(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  scene.AddFloor(4.0 * at.Number, -2.0); // further down than VTK rounds such a one
}

// Things of another size beside it, out of view, that reach none of its shadows.
void Beside(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  const double size = at.Number;
  const glm::dvec3 centre(0.0, 8.0 + 4.0 * size, -2.0 * size);
  scene.AddBox(centre, glm::dvec3(size));
  scene.AddSphere(centre + glm::dvec3(1.5 * size, 0.0, 0.0), 0.6 * size);
}

void FlatCasters(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  const int count = static_cast<int>(at.Number);
  for (int i = 0; i < count; ++i)
  {
    scene.AddQuad({ -3.5 + 0.15 * (i % 45), 3.0 + 0.03 * (i / 45), 0.1 + 1e-4 * i },
      { 0.02, 0.0, 0.0 }, { 0.0, 0.02, 0.0 });
  }
}

void NearAndFar(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  constexpr double far = 50.0;
  scene.GetRenderer()->GetActiveCamera()->SetClippingRange(far / at.Number, far);
}
}

//------------------------------------------------------------------------------
void ExtremeScenes::AddPlaces(ExtremeBuilders& builders)
{
  builders["unit-by-points"] = UnitByPoints;
  builders["unit-by-actors"] = UnitByActors;
  builders["unit-by-matrix"] = UnitByMatrix;
  builders["unit-against"] = UnitAgainst;
  builders["unit-uneven"] = UnitUneven;
  builders["origin-by-points"] = OriginByPoints;
  builders["origin-by-floats"] = OriginByFloats;
  builders["origin-unshifted"] = OriginUnshifted;
  builders["origin-shifted"] = OriginShifted;
  builders["origin-by-position"] = OriginByPosition;
  builders["origin-by-matrix"] = OriginByMatrix;
  builders["origin-cancelling"] = OriginCancelling;
  builders["sky"] = Sky;
  builders["ground"] = Ground;
  builders["beside"] = Beside;
  builders["flat-casters"] = FlatCasters;
  builders["near-and-far"] = NearAndFar;
}
