// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSceneBuilders.h"

#include "ShadowSceneRandom.h"
#include "ShadowSceneStage.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPerlinNoise.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShadowVTKVersion.h"

#include <array>
#include <cmath>
#include <map>

namespace stage = ShadowSceneStage;

namespace
{
/** Cells along a side of the cube whose faces become the body's. */
constexpr int Cells = 129;

/** How far the body reaches in a direction: bulges, folds and the roughness that a scanner leaves. */
double GetRadius(vtkPerlinNoise* noise, const vtkVector3d& direction)
{
  double radius = 1.0;
  double amplitude = 0.28;
  double frequency = 1.3;
  for (int octave = 0; octave < 7; ++octave)
  {
    noise->SetFrequency(frequency, frequency, frequency);
    double place[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] = direction[axis] + 11.3 * octave + 2.7 * axis;
    }
    const double value = noise->EvaluateFunction(place);
    radius += amplitude * (octave == 2 ? 0.4 - std::abs(2.0 * value) : value);
    amplitude *= 0.4;
    frequency *= 2.1;
  }
  return radius;
}
}

//------------------------------------------------------------------------------
// A closed body as a scanner gives it: uneven triangles of about a pixel, noise of several scales, no
// normals.
void ShadowSceneBuilders::Scan(vtkRenderer* renderer, int)
{
  vtkNew<vtkPerlinNoise> noise;
  ShadowSceneRandom random(7);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  std::map<std::array<int, 3>, vtkIdType> known; // points of the cube's lattice, which faces share
  const auto add = [&](const std::array<int, 3>& corner)
  {
    const auto found = known.find(corner);
    if (found != known.end())
    {
      return found->second;
    }
    vtkVector3d direction;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool border = corner[axis] == 0 || corner[axis] == Cells;
      const double place = corner[axis] + (border ? 0.0 : random.Between(-0.3, 0.3));
      direction[axis] = std::tan(0.5 * (place / Cells - 0.5) * 3.14159265358979); // even angles
    }
    direction.Normalize();
    const vtkVector3d point = GetRadius(noise, direction) * direction;
    const vtkIdType id = points->InsertNextPoint(point[0], point[1], point[2]);
    known.emplace(corner, id);
    return id;
  };
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const bool high = face % 2 == 1;
    for (int i = 0; i < Cells; ++i)
    {
      for (int j = 0; j < Cells; ++j)
      {
        const auto at = [&](int u, int v)
        {
          std::array<int, 3> corner{};
          corner[axis] = high ? Cells : 0;
          corner[(axis + 1) % 3] = high ? u : v;
          corner[(axis + 2) % 3] = high ? v : u;
          return add(corner);
        };
        const vtkIdType a = at(i, j);
        const vtkIdType b = at(i + 1, j);
        const vtkIdType c = at(i + 1, j + 1);
        const vtkIdType d = at(i, j + 1);
        triangles->InsertNextCell({ a, b, c });
        triangles->InsertNextCell({ a, c, d });
      }
    }
  }
  vtkNew<vtkPolyData> body;
  body->SetPoints(points);
  body->SetPolys(triangles);

  stage::AddFloor(renderer, 6.0);
  vtkActor* actor = stage::AddActor(renderer, body, stage::Bone);
  double bounds[6];
  actor->GetBounds(bounds);
  actor->SetPosition(0.0, 0.0, -bounds[4]);
  stage::AddSphereLight(renderer, vtkVector3d(-3.2, -2.2, 5.6), vtkVector3d(0.0, 0.0, 1.0), 0.35);
  stage::SetCamera(renderer, vtkVector3d(2.6, -6.8, 3.9), vtkVector3d(0.1, 0.1, 0.85));
}
