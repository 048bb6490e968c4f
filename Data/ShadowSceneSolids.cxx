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

//------------------------------------------------------------------------------
// 17,408 triangles: torus 8,192, sphere 4,096, ellipsoid 2,048, cylinder 1,024, ball 1,024,
// tower 512, floor 512.
void ShadowSceneBuilders::Basic(vtkRenderer* renderer, int)
{
  ShadowSceneMesh torus;
  torus.AddGrid(64, 64, true, true,
    [](double u, double v, vtkVector3d& point, vtkVector3d& normal)
    {
      const double a = 2.0 * vtkMath::Pi() * u;
      const double b = 2.0 * vtkMath::Pi() * v;
      const vtkVector3d out(std::cos(a), std::sin(a), 0.0);
      normal = std::cos(b) * out + std::sin(b) * vtkVector3d(0.0, 0.0, 1.0);
      point = 0.8 * out + 0.28 * normal;
      // Tilted about x, its lowest point just above the floor.
      const double c = std::cos(0.5);
      const double s = std::sin(0.5);
      point.Set(point[0] - 1.2, c * point[1] - s * point[2] - 1.5,
        s * point[1] + c * point[2] + 0.8 * s + 0.29);
      normal.Set(normal[0], c * normal[1] - s * normal[2], s * normal[1] + c * normal[2]);
    });
  stage::AddActor(renderer, torus, stage::Clay);

  ShadowSceneMesh sphere;
  sphere.AddSphere(vtkVector3d(-1.4, 1.4, 0.9), 0.9, 64, 33);
  stage::AddActor(renderer, sphere, stage::Sky);

  ShadowSceneMesh ellipsoid;
  ellipsoid.AddSphere(vtkVector3d(0.75, 0.35, 2.1), vtkVector3d(0.75, 0.5, 0.35), 32, 33);
  stage::AddActor(renderer, ellipsoid, stage::Ochre);

  ShadowSceneMesh cylinder;
  std::vector<vtkVector3d> path;
  for (int k = 0; k <= 7; ++k)
  {
    path.emplace_back(2.2, 1.7, 1.6 * k / 7);
  }
  cylinder.AddTube(path, 0.5, 64);
  stage::AddActor(renderer, cylinder, stage::Sage);

  ShadowSceneMesh ball;
  ball.AddSphere(vtkVector3d(0.3, -2.3, 0.4), 0.4, 32, 17);
  stage::AddActor(renderer, ball, stage::Rose);

  ShadowSceneMesh tower;
  tower.AddBox(vtkVector3d(1.7, -1.1, 1.1), vtkVector3d(0.33, -0.12, 0.0),
    vtkVector3d(0.12, 0.33, 0.0), vtkVector3d(0.0, 0.0, 1.1), 4, 4, 14);
  stage::AddActor(renderer, tower, stage::Plum);

  ShadowSceneMesh floor;
  floor.AddGrid(16, 16, false, false,
    [](double u, double v, vtkVector3d& point, vtkVector3d& normal)
    {
      point.Set(10.0 * u - 5.0, 10.0 * v - 5.0, 0.0);
      normal.Set(0.0, 0.0, 1.0);
    });
  stage::MarkGround(stage::AddActor(renderer, floor, stage::Floor));

  stage::AddRectangleLight(
    renderer, vtkVector3d(-2.6, -3.0, 6.0), vtkVector3d(0.0, 0.0, 0.0), 1.2, 1.2);
  stage::SetCamera(renderer, vtkVector3d(4.6, -10.5, 7.0), vtkVector3d(0.2, 0.0, 0.6));
}

//------------------------------------------------------------------------------
// The camera looks flatly under the blocker, so that the shadow lies free in front of it.
void ShadowSceneBuilders::Blocker(vtkRenderer* renderer, int)
{
  stage::AddFloor(renderer, 4.0);

  ShadowSceneMesh square;
  square.AddGrid(1, 1, false, false,
    [](double u, double v, vtkVector3d& point, vtkVector3d& normal)
    {
      point.Set(
        BlockerHalfSide * (2.0 * u - 1.0), BlockerHalfSide * (2.0 * v - 1.0), BlockerHeight);
      normal.Set(0.0, 0.0, 1.0);
    });
  stage::AddActor(renderer, square, stage::Clay);

  stage::AddRectangleLight(renderer, vtkVector3d(0.0, 0.0, BlockerLightHeight),
    vtkVector3d(0.0, 0.0, 0.0), 2.0 * BlockerLightHalfSide, 2.0 * BlockerLightHalfSide);
  stage::SetCamera(renderer, vtkVector3d(3.6, -11.0, 6.4), vtkVector3d(0.0, 0.0, 0.7));
}

//------------------------------------------------------------------------------
// 166 triangles: 41 bars each way, two of the floor. From near, penumbrae of many pixels; towards the
// horizon many bars within a pixel.
void ShadowSceneBuilders::Grid(vtkRenderer* renderer, int)
{
  static constexpr int bars = 41;
  static constexpr double half = 20.0;
  static constexpr double width = 0.25;
  static constexpr double height = 1.0;
  stage::AddFloor(renderer, 30.0);

  ShadowSceneMesh grid;
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int k = 0; k < bars; ++k)
    {
      const double middle = half * (2.0 * k / (bars - 1) - 1.0);
      grid.AddGrid(1, 1, false, false,
        [axis, middle](double u, double v, vtkVector3d& point, vtkVector3d& normal)
        {
          const double along = half * (2.0 * (axis == 0 ? u : v) - 1.0);
          const double across = middle + width * ((axis == 0 ? v : u) - 0.5);
          point.Set(axis == 0 ? along : across, axis == 0 ? across : along, height);
          normal.Set(0.0, 0.0, 1.0);
        });
    }
  }
  stage::AddActor(renderer, grid, stage::Clay);

  stage::AddRectangleLight(
    renderer, vtkVector3d(-6.0, -4.0, 24.0), vtkVector3d(0.0, 0.0, 0.0), 1.5, 1.5);
  stage::SetCamera(renderer, vtkVector3d(1.3, -24.5, 4.2), vtkVector3d(0.0, -12.0, 0.2));
}

//------------------------------------------------------------------------------
void ShadowSceneBuilders::Cylinder(vtkRenderer* renderer, int)
{
  stage::AddFloor(renderer, 9.0);

  ShadowSceneMesh column;
  column.AddTube({ vtkVector3d(-0.6, 0.6, 0.0), vtkVector3d(-0.6, 0.6, 4.0) }, 0.6, 64);
  stage::AddActor(renderer, column, stage::Bone);

  ShadowSceneMesh log;
  log.AddTube({ vtkVector3d(0.4, -1.9, 0.5), vtkVector3d(3.2, -0.5, 0.5) }, 0.5, 64);
  stage::AddActor(renderer, log, stage::Clay);

  // A pipe, open at both ends: outside, upper rim, inside and lower rim.
  ShadowSceneMesh pipe;
  const double profile[5][2] = { { 0.55, 0.0 }, { 0.55, 1.5 }, { 0.43, 1.5 }, { 0.43, 0.0 },
    { 0.55, 0.0 } };
  for (int k = 0; k < 4; ++k)
  {
    pipe.AddGrid(64, 1, true, false,
      [&profile, k](double u, double v, vtkVector3d& point, vtkVector3d& normal)
      {
        const double angle = 2.0 * vtkMath::Pi() * u;
        const vtkVector3d out(std::cos(angle), std::sin(angle), 0.0);
        const vtkVector3d up(0.0, 0.0, 1.0);
        const double* from = profile[k];
        const double* to = profile[k + 1];
        const double radius = from[0] + v * (to[0] - from[0]);
        const double height = from[1] + v * (to[1] - from[1]);
        point = vtkVector3d(-1.9, -1.7, 0.0) + radius * out + height * up;
        normal = (to[1] - from[1]) * out - (to[0] - from[0]) * up;
      });
  }
  stage::AddActor(renderer, pipe, stage::Teal);

  ShadowSceneMesh poles;
  poles.AddTube({ vtkVector3d(2.6, 1.3, 0.06), vtkVector3d(1.2, 1.9, 3.4) }, 0.06, 24);
  poles.AddTube({ vtkVector3d(1.3, 0.9, 0.06), vtkVector3d(1.9, 2.2, 3.2) }, 0.06, 24);
  poles.AddTube({ vtkVector3d(1.1, 2.5, 0.06), vtkVector3d(2.2, 1.2, 3.3) }, 0.06, 24);
  stage::AddActor(renderer, poles, stage::Ochre);

  stage::AddDiskLight(renderer, vtkVector3d(-5.0, -3.5, 8.0), vtkVector3d(0.0, 0.0, 1.0), 0.7);
  stage::SetCamera(renderer, vtkVector3d(5.2, -12.2, 7.5), vtkVector3d(0.3, 0.2, 1.3));
}

//------------------------------------------------------------------------------
// Each box is dropped onto the highest of those that it may meet, and sinks in a little.
void ShadowSceneBuilders::Boxes(vtkRenderer* renderer, int)
{
  struct Placed
  {
    double X, Y, Radius, Top;
  };
  const stage::Color colors[] = { stage::Clay, stage::Ochre, stage::Sage, stage::Sky, stage::Plum,
    stage::Bone };
  constexpr int numberOfBoxes = 150;

  stage::AddFloor(renderer, 10.0);
  ShadowSceneRandom random(7);
  ShadowSceneMesh meshes[6];
  std::vector<Placed> placed;
  for (int i = 0; i < numberOfBoxes; ++i)
  {
    // Nearer to the middle than evenly spread.
    const double distance = 4.0 * std::pow(random.Between(0.0, 1.0), 0.6);
    const double angle = random.Between(0.0, 2.0 * vtkMath::Pi());
    const double large = random.Between(0.16, 0.55) * (1.1 - 0.1 * distance);
    const double depth = large * random.Between(0.4, 1.0);
    const double height = large * random.Between(0.4, 1.3);
    const vtkVector3d half(large, depth, height);
    Placed box = { distance * std::cos(angle), distance * std::sin(angle),
      0.55 * std::max(half[0], half[1]), 0.0 };
    double bottom = 0.0;
    for (const Placed& other : placed)
    {
      if (std::hypot(box.X - other.X, box.Y - other.Y) < box.Radius + other.Radius)
      {
        bottom = std::max(bottom, other.Top - 0.25 * half[2]);
      }
    }
    box.Top = bottom + 2.0 * half[2];
    placed.push_back(box);
    meshes[random.Index(6)].AddBox(
      vtkVector3d(box.X, box.Y, bottom + half[2]), half, random.Between(0.0, vtkMath::Pi()));
  }
  for (int i = 0; i < 6; ++i)
  {
    stage::AddActor(renderer, meshes[i], colors[i]);
  }

  stage::AddRectangleLight(
    renderer, vtkVector3d(-6.0, -3.0, 9.5), vtkVector3d(0.0, 0.0, 1.0), 1.6, 1.6);
  stage::SetCamera(renderer, vtkVector3d(5.5, -13.5, 9.5), vtkVector3d(0.0, 0.0, 1.0));
}
