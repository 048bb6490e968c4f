// SPDX-License-Identifier: BSD-3-Clause
// Laws: a scene's unit, place and direction change nothing.
//
// Moving a scene rounds all its coordinates anew, by 1e-7 of its size in floats. That can turn what a
// pixel or a texel on an edge sees, no more: edges take some 500 of the 25,600 pixels, and one in ten
// thousand of these lies so close to its edge. Bounds allow ten pixels.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace
{
constexpr double PixelShare = 10.0 / 25600.0;

std::vector<LightKind> GetKinds(const std::string& technique)
{
  std::vector<LightKind> kinds;
  // A rectangle's samples turn with it; those of other shapes are free to lie elsewhere.
  for (const LightKind kind : { LightKind::Rectangle, LightKind::Point, LightKind::Directional })
  {
    if (ShadowStage::Supports(technique, kind))
    {
      kinds.push_back(kind);
    }
  }
  return kinds;
}

/**
 * The directional light's disk has no axes that turn with it, so it is a point here. A step of a
 * pattern that the map's texels shift is to be less than a pixel may differ by: 1/15 of a kernel, a
 * few samples of 64. What a filter of constant width finds at a contact depends on whether the map has
 * the floor: a narrow one.
 */
Visibility Show(const std::string& technique, LightKind kind, const Placement& place)
{
  // Faces of a cube show 1.6 as much either way where look-ups go around a point.
  const bool around = ShadowStage::HasParameter(technique, "skipping");
  return RenderVisibility(
    technique,
    { { "kernel", "15" }, { "samples", "64" }, { "width", "0.1" },
      { "resolution", around ? "410" : "256" } },
    [kind](ShadowStage& stage)
    {
      stage.AddThings();
      vtkAreaLight* light = stage.AddLight(kind);
      if (kind == LightKind::Directional)
      {
        light->SetAngularDiameter(0.0);
      }
    },
    place);
}

void CheckSame(const std::string& technique, LightKind kind, const Visibility& expected,
  const Placement& place, const std::string& name, double share = PixelShare)
{
  ShadowTest::CheckEqual(GetRange(expected).first, 0.0, "there is a shadow");
  const Visibility visibility = Show(technique, kind, place);
  const Difference difference = Compare(visibility, expected, 0.1);
  const std::string what = name + ", " + GetName(kind);
  ShadowTest::CheckAtMost(difference.Share, share, what + ": pixels that differ");
  ShadowTest::CheckAtMost(difference.MaskShare, PixelShare, what + ": receivers that differ");
  // Those that differ may do so by 1, the others by one sample of 16 on a hundred times as many.
  ShadowTest::CheckAtMost(
    difference.RMSE, std::sqrt(share + 100.0 * share / 256.0), what + ": RMSE");
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(Law, ScaleChangesNothing, Each)
{
  for (const LightKind kind : GetKinds(technique))
  {
    const Visibility expected = Show(technique, kind, {});
    for (const int exponent : { -6, -3, 3, 6, 9 })
    {
      Placement place;
      place.Scale = std::pow(10.0, exponent);
      CheckSame(technique, kind, expected, place, "1e" + std::to_string(exponent));
      if (kind == LightKind::Rectangle)
      {
        place.ByActor = true;
        CheckSame(technique, kind, expected, place, "1e" + std::to_string(exponent) + " by actor");
      }
    }
  }
}

//------------------------------------------------------------------------------
// Coordinates near 1e7 are doubles of 2e-9: exact compared with a float of a scene of size 10.
SHADOW_TEST(Law, OffsetChangesNothing, Each)
{
  for (const LightKind kind : GetKinds(technique))
  {
    const Visibility expected = Show(technique, kind, {});
    for (const bool byActor : { false, true })
    {
      Placement place;
      place.Offset = 1e7 * glm::dvec3(1.0, -0.7, 0.4);
      place.ByActor = byActor;
      CheckSame(technique, kind, expected, place, byActor ? "by actor" : "by points");
    }
  }
}

//------------------------------------------------------------------------------
// Maps turn with the scene but for the roll of their texels, which is free, and for the boxes around
// casters, which follow the axes of their points: edges move by up to a texel, here a third of a
// pixel, and so may a third of the 500 pixels at edges change. Nothing else may.
SHADOW_TEST(Law, RotationChangesNothing, Each)
{
  for (const LightKind kind : GetKinds(technique))
  {
    const Visibility expected = Show(technique, kind, {});
    for (const bool byActor : { false, true })
    {
      Placement place;
      place.Turn =
        glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1.0, 2.0, 3.0))));
      place.ByActor = byActor;
      CheckSame(technique, kind, expected, place, byActor ? "by actor" : "by points",
        ShadowStage::HasParameter(technique, "resolution") ? 0.007 : PixelShare);
    }
  }
}
