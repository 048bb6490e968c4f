// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSceneBuilders.h"

#include "ShadowSceneMesh.h"
#include "ShadowSceneRandom.h"
#include "ShadowSceneStage.h"

#include "vtkMath.h"
#include "vtkShadowVTKVersion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stage = ShadowSceneStage;

namespace
{
constexpr int Levels = 7;

//------------------------------------------------------------------------------
// One branch, a bent and tapered tube, and all that grows from it. Level 0 is the trunk.
void Grow(ShadowSceneMesh& mesh, ShadowSceneRandom& random, const vtkVector3d& start,
  const vtkVector3d& heading, double length, double radius, int level)
{
  const bool twig = level == Levels - 1;
  const int segments = twig ? 3 : 4;
  vtkVector3d direction = heading.Normalized();
  std::vector<vtkVector3d> path = { start };
  std::vector<double> radii = { radius };
  for (int k = 1; k <= segments; ++k)
  {
    // Wander a little and turn to the light.
    const double wander = level == 0 ? 0.05 : 0.22;
    vtkVector3d bend(0.0, 0.0, level == 0 ? 0.1 : 0.08);
    for (int axis = 0; axis < 3; ++axis)
    {
      bend[axis] += random.Between(-wander, wander);
    }
    direction = (direction + bend).Normalized();
    path.push_back(path.back() + length / segments * direction);
    radii.push_back(radius * (1.0 - 0.38 * k / segments));
  }
  if (twig)
  {
    radii.back() = 0.0;
  }
  else if (level == 0)
  {
    radii.front() *= 1.35; // the foot
  }
  mesh.AddTube(path, radii, std::max(4, 14 - 2 * level));
  if (twig)
  {
    return;
  }

  const vtkVector3d axis =
    std::abs(direction[2]) < 0.9 ? vtkVector3d(0.0, 0.0, 1.0) : vtkVector3d(1.0, 0.0, 0.0);
  const vtkVector3d side = direction.Cross(axis).Normalized();
  const vtkVector3d other = direction.Cross(side);
  const double phase = random.Between(0.0, 2.0 * vtkMath::Pi());
  constexpr int children = 3;
  for (int k = 0; k < children; ++k)
  {
    // The first goes on from the tip, the others leave from further down.
    const double turn = phase + 2.0 * vtkMath::Pi() * k / children + random.Between(-0.4, 0.4);
    const double spread = (k == 0 ? 0.25 : 0.75) * random.Between(0.8, 1.2);
    const vtkVector3d out = std::cos(turn) * side + std::sin(turn) * other;
    const vtkVector3d child = std::cos(spread) * direction + std::sin(spread) * out;
    const std::size_t from = path.size() - 1 - (k == 2 ? 1 : 0);
    const double shorter = random.Between(0.66, 0.82);
    Grow(mesh, random, path[from], child, length * shorter, radii[from] * (k == 0 ? 0.95 : 0.72),
      level + 1);
  }
}
}

//------------------------------------------------------------------------------
void ShadowSceneBuilders::Tree(vtkRenderer* renderer, int)
{
  stage::AddFloor(renderer, 12.0);
  ShadowSceneRandom random(11);
  ShadowSceneMesh tree;
  Grow(tree, random, vtkVector3d(0.0, 0.0, -0.02), vtkVector3d(0.0, 0.0, 1.0), 1.5, 0.16, 0);
  stage::AddActor(renderer, tree, stage::Bark);
  stage::AddSphereLight(renderer, vtkVector3d(-6.0, -5.0, 11.0), vtkVector3d(0.0, 0.0, 1.5), 0.5);
  stage::SetCamera(renderer, vtkVector3d(4.6, -10.5, 6.0), vtkVector3d(0.7, 0.4, 2.1));
}
