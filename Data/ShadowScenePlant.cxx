// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSceneBuilders.h"

#include "ShadowSceneMesh.h"
#include "ShadowSceneRandom.h"
#include "ShadowSceneStage.h"

#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkShadowVTKVersion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

// An industrial plant, in metres: modules on a grid, each with a stretch of pipe rack, some equipment
// and a walkway. There are as many modules as the number of triangles allows; the bars of the
// walkways' gratings make up the rest.

namespace stage = ShadowSceneStage;

namespace
{
constexpr double Pitch = 12.0; // size of a module
constexpr double RackFront = 1.0;
constexpr double RackBack = 4.6;
constexpr double WalkwayHeight = 3.2;
const vtkVector3d Up(0.0, 0.0, 1.0);

//------------------------------------------------------------------------------
enum Material
{
  Steel,
  Pads,
  Tanks,
  Vessels,
  RedPipes,
  BluePipes,
  Rails,
  NumberOfMaterials
};

const std::array<stage::Color, NumberOfMaterials> Colors = { stage::Slate,
  stage::Color{ 0.66, 0.66, 0.64 }, stage::Bone, stage::Sage, stage::Clay, stage::Sky,
  stage::Ochre };

using Meshes = std::array<ShadowSceneMesh, NumberOfMaterials>;

//------------------------------------------------------------------------------
vtkIdType Count(const Meshes& meshes)
{
  return std::accumulate(meshes.begin(), meshes.end(), vtkIdType(0),
    [](vtkIdType sum, const ShadowSceneMesh& mesh) { return sum + mesh.GetNumberOfTriangles(); });
}

//------------------------------------------------------------------------------
// Builds one module at a time into the meshes.
class Module
{
public:
  Module(Meshes& meshes, ShadowSceneRandom& random, int sides, double x, double y)
    : Parts(meshes)
    , Random(random)
    , Sides(sides)
    , X(x)
    , Y(y)
  {
  }

  void AddAll()
  {
    this->AddRack();
    this->AddRails();
    switch (this->Random.Index(5))
    {
      case 0:
        this->AddTanks();
        break;
      case 1:
        this->AddDrums();
        break;
      case 2:
        this->AddColumns();
        break;
      case 3:
        this->AddSphereTank();
        break;
      default:
        this->AddPumps();
        break;
    }
  }

  // The grating of the walkway: that many bars of 12 triangles.
  void AddGrating(int bars)
  {
    const double spacing = Pitch / std::max(1, bars);
    const double half = std::min(0.02, 0.3 * spacing);
    for (int k = 0; k < bars; ++k)
    {
      this->Parts[Steel].AddBox(
        this->At((k + 0.5) * spacing, RackBack + 0.7, WalkwayHeight), { half, 0.6, 0.025 });
    }
  }

private:
  vtkVector3d At(double x, double y, double z) const { return { this->X + x, this->Y + y, z }; }

  ShadowSceneMesh& AnyPipe() { return this->Parts[this->Random.Index(2) ? RedPipes : BluePipes]; }

  void AddPipe(ShadowSceneMesh& mesh, const std::vector<vtkVector3d>& corners, double radius)
  {
    mesh.AddTube(
      ShadowSceneMesh::RoundPath(corners, 3.0 * radius, this->Sides / 2), radius, this->Sides);
    // A flange in each leg.
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    {
      const vtkVector3d along = (corners[i + 1] - corners[i]).Normalized();
      const vtkVector3d middle =
        corners[i] + this->Random.Between(0.4, 0.6) * (corners[i + 1] - corners[i]);
      mesh.AddTube({ middle - 0.4 * radius * along, middle + 0.4 * radius * along }, 1.6 * radius,
        this->Sides);
    }
  }

  // Portals of I beams with pipes on two decks, all along x through the module.
  void AddRack()
  {
    ShadowSceneMesh& steel = this->Parts[Steel];
    for (const double x : { 1.0, 7.0 })
    {
      for (const double y : { RackFront, RackBack })
      {
        steel.AddIBeam(this->At(x, y, 0.1), this->At(x, y, 6.2), 0.3, 0.3, { 1.0, 0.0, 0.0 });
        this->Parts[Pads].AddBox(this->At(x, y, 0.1), { 0.4, 0.4, 0.1 });
      }
      for (const double z : { 4.2, 6.0 })
      {
        steel.AddIBeam(this->At(x, RackFront, z), this->At(x, RackBack, z), 0.25, 0.3, Up);
      }
      steel.AddBeam(
        this->At(x, RackFront, 4.2), this->At(x, RackBack, 6.0), 0.12, 0.12, { 1.0, 0.0, 0.0 });
    }
    for (const double y : { RackFront, RackBack })
    {
      for (const double z : { 4.45, 6.2 })
      {
        steel.AddIBeam(this->At(0.0, y, z), this->At(Pitch, y, z), 0.2, 0.25, Up);
      }
      steel.AddBeam(this->At(1.0, y, 0.6), this->At(7.0, y, 4.2), 0.12, 0.12, Up);
    }
    for (int deck = 0; deck < 2; ++deck)
    {
      double y = RackFront + 0.45;
      while (y < RackBack - 0.45)
      {
        const double radius = this->Random.Between(0.09, 0.26);
        const double z = (deck ? 6.15 : 4.35) + radius;
        ShadowSceneMesh& pipe = this->AnyPipe();
        if (this->Random.Index(3) == 0)
        {
          // Expansion loop.
          const double x = this->Random.Between(3.0, 5.0);
          const double rise = z + this->Random.Between(0.7, 1.3);
          this->AddPipe(pipe,
            { this->At(0.0, y, z), this->At(x, y, z), this->At(x, y, rise),
              this->At(x + 2.5, y, rise), this->At(x + 2.5, y, z), this->At(Pitch, y, z) },
            radius);
        }
        else
        {
          this->AddPipe(pipe, { this->At(0.0, y, z), this->At(Pitch, y, z) }, radius);
        }
        y += 2.0 * radius + this->Random.Between(0.35, 0.7);
      }
    }
  }

  // The walkway's frame and its railings.
  void AddRails()
  {
    for (const double y : { RackBack + 0.1, RackBack + 1.3 })
    {
      this->Parts[Steel].AddBeam(
        this->At(0.0, y, WalkwayHeight), this->At(Pitch, y, WalkwayHeight), 0.06, 0.2, Up);
      for (const double z : { 0.55, 1.1 })
      {
        this->Parts[Rails].AddTube(
          { this->At(0.0, y, WalkwayHeight + z), this->At(Pitch, y, WalkwayHeight + z) }, 0.03, 5);
      }
      for (int post = 0; post < 8; ++post)
      {
        const double x = Pitch * (post + 0.5) / 8.0;
        this->Parts[Rails].AddTube(
          { this->At(x, y, WalkwayHeight), this->At(x, y, WalkwayHeight + 1.1) }, 0.03, 5);
      }
    }
    for (const double x : { 1.0, 7.0 })
    {
      this->Parts[Steel].AddBeam(this->At(x, RackBack + 1.2, 0.0), this->At(x, RackBack + 1.2, 3.1),
        0.15, 0.15, { 1.0, 0.0, 0.0 });
    }
  }

  // From a point of the equipment up and over to the rack.
  void AddFeed(const vtkVector3d& from, double height, double radius)
  {
    const double y = this->Y + this->Random.Between(RackFront + 0.6, RackBack - 0.6);
    this->AddPipe(this->AnyPipe(),
      { from, { from[0], from[1], height }, { from[0], y, height }, { from[0], y, 4.4 } }, radius);
  }

  void AddLadder(const vtkVector3d& foot, double height)
  {
    ShadowSceneMesh& rails = this->Parts[Rails];
    for (const double side : { -0.22, 0.22 })
    {
      rails.AddBeam(foot + vtkVector3d(side, 0.0, 0.0), foot + vtkVector3d(side, 0.0, height), 0.05,
        0.05, { 0.0, 1.0, 0.0 });
    }
    for (double z = 0.3; z < height; z += 0.3)
    {
      rails.AddBeam(
        foot + vtkVector3d(-0.22, 0.0, z), foot + vtkVector3d(0.22, 0.0, z), 0.03, 0.03, Up);
    }
  }

  // A round railing of a tank's roof or a column's platform.
  void AddRing(const vtkVector3d& center, double radius)
  {
    ShadowSceneMesh& rails = this->Parts[Rails];
    for (const double z : { 0.55, 1.1 })
    {
      rails.AddGrid(3 * this->Sides, 4, true, true,
        [&](double u, double v, vtkVector3d& point, vtkVector3d& normal)
        {
          const double a = 2.0 * vtkMath::Pi() * u;
          const double b = 2.0 * vtkMath::Pi() * v;
          const vtkVector3d out(std::cos(a), std::sin(a), 0.0);
          normal = std::cos(b) * out + std::sin(b) * Up;
          point = center + radius * out + z * Up + 0.03 * normal;
        });
    }
    for (int k = 0; k < 12; ++k)
    {
      const double angle = 2.0 * vtkMath::Pi() * k / 12;
      const vtkVector3d foot = center + radius * vtkVector3d(std::cos(angle), std::sin(angle), 0.0);
      rails.AddTube({ foot, foot + 1.1 * Up }, 0.03, 5);
    }
  }

  // Two upright tanks with domed roofs.
  void AddTanks()
  {
    for (const double x : { 3.0, 8.6 })
    {
      const double radius = this->Random.Between(1.6, 2.1);
      const double height = this->Random.Between(3.5, 6.0);
      const vtkVector3d foot = this->At(x, 8.9, 0.0);
      this->Parts[Pads].AddTube({ foot, foot + 0.25 * Up }, radius + 0.3, 3 * this->Sides);
      this->Parts[Tanks].AddVessel(
        foot + 0.6 * Up, foot + height * Up, radius, 0.4 * radius, 3 * this->Sides);
      this->AddRing(foot + (height - 0.05) * Up, radius + 0.02);
      this->AddLadder(foot + vtkVector3d(radius + 0.1, -0.4, 0.0), height);
      this->AddFeed(foot + (height + 0.3 * radius) * Up, height + 1.6, 0.16);
    }
  }

  // Three lying drums on saddles, one above the two others on a frame.
  void AddDrums()
  {
    for (int k = 0; k < 3; ++k)
    {
      const double radius = this->Random.Between(0.75, 0.95);
      const double y = k == 0 ? 7.5 : (k == 1 ? 10.0 : 8.75);
      const double z = k == 2 ? 4.3 : 1.5;
      this->Parts[Vessels].AddVessel(
        this->At(2.4, y, z), this->At(9.0, y, z), radius, 0.5 * radius, 3 * this->Sides);
      for (const double x : { 3.6, 7.8 })
      {
        this->Parts[Pads].AddBox(
          this->At(x, y, 0.5 * z - 0.3), { 0.2, k == 2 ? 0.2 : 0.6, 0.5 * z - 0.3 });
      }
      this->AddFeed(this->At(4.0 + 1.5 * k, y, z + 0.9 * radius), 7.6 + 0.5 * k, 0.12);
    }
  }

  // Two tall columns with platforms.
  void AddColumns()
  {
    for (const double x : { 3.2, 8.2 })
    {
      const double radius = this->Random.Between(0.6, 0.9);
      const double height = this->Random.Between(9.0, 14.0);
      const vtkVector3d foot = this->At(x, 9.0, 0.0);
      this->Parts[Pads].AddTube({ foot, foot + 0.4 * Up }, radius + 0.4, this->Sides);
      this->Parts[Tanks].AddVessel(
        foot + 0.6 * Up, foot + height * Up, radius, 0.6 * radius, 3 * this->Sides);
      for (double z = 4.0; z < height; z += 3.2)
      {
        this->Parts[Steel].AddTube(
          { foot + z * Up, foot + (z + 0.08) * Up }, radius + 0.9, 3 * this->Sides);
        this->AddRing(foot + (z + 0.08) * Up, radius + 0.85);
      }
      this->AddLadder(foot + vtkVector3d(0.0, -radius - 0.15, 0.0), height - 0.5);
      this->AddFeed(foot + (height + 0.4 * radius) * Up, height + 1.5, 0.2);
    }
  }

  // A sphere on legs.
  void AddSphereTank()
  {
    const vtkVector3d center = this->At(5.8, 9.0, 3.6);
    constexpr double radius = 2.3;
    this->Parts[Tanks].AddSphere(center, radius, 6 * this->Sides, 3 * this->Sides);
    vtkVector3d last(0.0, 0.0, 0.0);
    for (int k = 0; k <= 8; ++k)
    {
      const double angle = 2.0 * vtkMath::Pi() * (k + 0.5) / 8;
      const vtkVector3d foot(
        center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle), 0.0);
      if (k < 8)
      {
        this->Parts[Steel].AddTube({ foot, foot + 3.6 * Up }, 0.16, this->Sides);
        this->Parts[Pads].AddBox(foot + 0.1 * Up, { 0.35, 0.35, 0.1 }, angle);
      }
      if (k > 0)
      {
        this->Parts[Steel].AddTube({ last + 0.5 * Up, foot + 2.9 * Up }, 0.05, 5);
        this->Parts[Steel].AddTube({ last + 2.9 * Up, foot + 0.5 * Up }, 0.05, 5);
      }
      last = foot;
    }
    this->AddRing(center + 2.1 * Up, 0.95);
    this->AddFeed(center + (0.97 * radius) * Up, 7.4, 0.2);
  }

  // Rows of pumps on their plinths.
  void AddPumps()
  {
    for (int k = 0; k < 6; ++k)
    {
      const double x = 1.6 + 3.6 * (k % 3);
      const double y = k < 3 ? 7.4 : 10.2;
      this->Parts[Pads].AddBox(this->At(x + 0.2, y, 0.2), { 1.2, 0.6, 0.2 });
      this->Parts[Vessels].AddVessel(
        this->At(x - 0.6, y, 0.95), this->At(x + 0.3, y, 0.95), 0.42, 0.15, 3 * this->Sides);
      this->Parts[Steel].AddTube(
        { this->At(x + 0.3, y, 0.95), this->At(x + 0.8, y, 0.95) }, 0.15, this->Sides);
      this->Parts[Tanks].AddSphere(
        this->At(x + 0.95, y, 0.95), { 0.3, 0.45, 0.5 }, 2 * this->Sides, this->Sides);
      this->AddFeed(this->At(x + 0.95, y, 1.3), 2.2 + 0.5 * (k % 2), 0.12);
    }
  }

  Meshes& Parts;
  ShadowSceneRandom& Random;
  int Sides;
  double X;
  double Y;
};
}

//------------------------------------------------------------------------------
void ShadowSceneBuilders::Plant(vtkRenderer* renderer, int triangles)
{
  // More triangles go into more modules first, and also into rounder pipes.
  const double growth = std::log10(triangles / 1e5) / std::log10(20.0); // 0 to 1
  const int sides = 8 + 2 * static_cast<int>(std::lround(4.0 * growth));
  constexpr int barsPerModule = 80; // at least
  const double moduleEstimate = 8000.0 * (1.0 + 1.3 * growth);
  const int columns =
    std::max(3, static_cast<int>(std::lround(std::sqrt(1.3 * triangles / moduleEstimate))));

  Meshes meshes;
  std::vector<Module> modules;
  ShadowSceneRandom random(23);
  vtkIdType left = triangles - 2; // the floor
  for (;;)
  {
    // A trial on empty meshes tells what the next module takes; the random numbers are kept.
    const auto index = static_cast<int>(modules.size());
    const double x = Pitch * (index % columns);
    const int row = index / columns;
    const double y = 1.15 * Pitch * row;
    ShadowSceneRandom trialRandom = random;
    Meshes trial;
    Module(trial, trialRandom, sides, x, y).AddAll();
    const vtkIdType need = Count(trial) + 12 * barsPerModule;
    if (need > left)
    {
      break;
    }
    modules.emplace_back(meshes, random, sides, x, y);
    modules.back().AddAll();
    left -= need;
  }
  const auto count = static_cast<int>(modules.size());
  const auto spare = static_cast<int>(left / 12);
  for (int i = 0; i < count; ++i)
  {
    modules[i].AddGrating(barsPerModule + spare / count + (i < spare % count ? 1 : 0));
  }

  const int rows = (count + columns - 1) / columns;
  const double width = Pitch * columns;
  const double depth = 1.15 * Pitch * rows;
  stage::AddFloor(renderer, 1.5 * std::max(width, depth), 0.5 * width, 0.5 * depth);
  for (int material = 0; material < NumberOfMaterials; ++material)
  {
    stage::AddActor(renderer, meshes[material], Colors[material]);
  }

  const double size = std::max(width, depth);
  const vtkVector3d center(0.5 * width, 0.5 * depth, 2.0);
  stage::AddSphereLight(renderer, center + size * vtkVector3d(0.9, 0.3, 1.4), center, 0.05 * size);
  const double bounds[6] = { 0.0, width, 0.0, depth, 0.0, 8.0 };
  stage::FitCamera(renderer, bounds, vtkVector3d(0.45, 1.0, 0.75), Up, 1.02);
}
