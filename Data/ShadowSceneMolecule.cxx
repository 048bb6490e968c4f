// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSceneBuilders.h"

#include "ShadowSceneMesh.h"
#include "ShadowSceneStage.h"

#include "vtkMath.h"
#include "vtkShadowVTKVersion.h"

#include <cmath>
#include <vector>

namespace stage = ShadowSceneStage;

namespace
{
//------------------------------------------------------------------------------
// A double helix: two backbones with an atom per base, and rungs of two halves whose colours follow
// a fixed sequence of bases.
void AddHelix(vtkRenderer* renderer, const vtkVector3d& from, const vtkVector3d& to)
{
  constexpr int pairs = 22;
  constexpr int steps = 6; // backbone points per pair
  constexpr double radius = 0.62;
  constexpr double groove = 2.4; // radians between the strands, not opposite each other
  const vtkVector3d along = (to - from).Normalized();
  const vtkVector3d side = along.Cross(vtkVector3d(0.0, 0.0, 1.0)).Normalized();
  const vtkVector3d other = along.Cross(side);
  const auto strand = [&](double pair, double phase)
  {
    const double angle = 2.0 * vtkMath::Pi() * pair / 10.5 + phase;
    return from + pair / (pairs - 1) * (to - from) +
           radius * (std::cos(angle) * side + std::sin(angle) * other);
  };

  const stage::Color baseColors[4] = { stage::Ochre, stage::Sage, stage::Sky, stage::Plum };
  const int sequence[pairs] = { 0, 2, 1, 3, 0, 0, 3, 1, 2, 0, 3, 2, 2, 1, 0, 3, 1, 1, 2, 0, 3, 0 };
  ShadowSceneMesh backbones[2];
  ShadowSceneMesh bases[4];
  for (int which = 0; which < 2; ++which)
  {
    const double phase = which * groove;
    std::vector<vtkVector3d> path;
    for (int k = 0; k <= (pairs - 1) * steps; ++k)
    {
      path.push_back(strand(static_cast<double>(k) / steps, phase));
    }
    backbones[which].AddTube(path, 0.06, 12);
    for (int pair = 0; pair < pairs; ++pair)
    {
      const vtkVector3d atom = strand(pair, phase);
      const vtkVector3d middle = 0.5 * (strand(pair, 0.0) + strand(pair, groove));
      backbones[which].AddSphere(atom, 0.125, 20, 12);
      // The partners of bases 0, 1, 2, 3 are 3, 2, 1, 0.
      const int base = which == 0 ? sequence[pair] : 3 - sequence[pair];
      bases[base].AddTube({ atom, middle }, 0.055, 12);
    }
  }
  stage::AddActor(renderer, backbones[0], stage::Clay);
  stage::AddActor(renderer, backbones[1], stage::Teal);
  for (int base = 0; base < 4; ++base)
  {
    stage::AddActor(renderer, bases[base], baseColors[base]);
  }
}

//------------------------------------------------------------------------------
// C60, a truncated icosahedron: 60 atoms, 90 bonds.
void AddFullerene(vtkRenderer* renderer, const vtkVector3d& center, double radius)
{
  const double phi = 0.5 * (1.0 + std::sqrt(5.0));
  const double seeds[3][3] = { { 0.0, 1.0, 3.0 * phi }, { 1.0, 2.0 + phi, 2.0 * phi },
    { phi, 2.0, 2.0 * phi + 1.0 } };
  const double scale = radius / std::sqrt(1.0 + 9.0 * phi * phi);
  std::vector<vtkVector3d> atoms;
  for (const auto& seed : seeds)
  {
    for (int signs = 0; signs < 8; ++signs)
    {
      if (seed[0] == 0.0 && (signs & 1))
      {
        continue; // zero has no sign
      }
      for (int turn = 0; turn < 3; ++turn)
      {
        vtkVector3d atom;
        for (int axis = 0; axis < 3; ++axis)
        {
          atom[(axis + turn) % 3] = scale * ((signs >> axis) & 1 ? -seed[axis] : seed[axis]);
        }
        atoms.push_back(center + atom);
      }
    }
  }
  ShadowSceneMesh balls;
  ShadowSceneMesh bonds;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    balls.AddSphere(atoms[i], 0.115 * radius, 16, 10);
    for (std::size_t j = 0; j < i; ++j)
    {
      if ((atoms[i] - atoms[j]).Norm() < 2.01 * scale)
      {
        bonds.AddTube({ atoms[i], atoms[j] }, 0.05 * radius, 10);
      }
    }
  }
  stage::AddActor(renderer, balls, stage::Slate);
  stage::AddActor(renderer, bonds, stage::Bone);
}
}

//------------------------------------------------------------------------------
void ShadowSceneBuilders::Molecule(vtkRenderer* renderer, int)
{
  stage::AddFloor(renderer, 8.0);
  AddHelix(renderer, vtkVector3d(-2.6, 0.5, 0.9), vtkVector3d(1.9, 1.1, 3.0));
  AddFullerene(renderer, vtkVector3d(1.3, -1.5, 1.25), 1.0);
  stage::AddSphereLight(renderer, vtkVector3d(-3.5, -5.0, 8.5), vtkVector3d(0.0, 0.0, 1.0), 0.6);
  stage::SetCamera(renderer, vtkVector3d(2.6, -10.0, 6.2), vtkVector3d(0.05, 0.0, 1.3));
}
