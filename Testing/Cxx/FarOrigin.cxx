// SPDX-License-Identifier: BSD-3-Clause
// Data far from their origin, where VTK's shaders work on coordinates whose magnitude is rounded, and
// sizes that differ by far in one scene: what a position may be off is bounded for each prop.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <cmath>
#include <string>

namespace
{
enum class How
{
  Points,
  Position,
  Cancelling // the points' offset is taken back by the actor's position
};

/** A square over a floor, all moved. Gives its visibility. */
Visibility Show(const std::string& technique, const glm::dvec3& offset, How how)
{
  ShadowStage stage;
  for (const double half : { 4.0, 0.5 })
  {
    vtkActor* actor = stage.AddFloor(half, half < 1.0 ? 1.0 : 0.0);
    auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      glm::dvec3 p;
      data->GetPoint(i, &p.x);
      p += how == How::Position ? glm::dvec3(0.0) : offset;
      points->InsertNextPoint(&p.x);
    }
    data->SetPoints(points);
    const glm::dvec3 position = how == How::Points     ? glm::dvec3(0.0)
                                : how == How::Position ? offset
                                                       : -offset;
    actor->SetPosition(position.x, position.y, position.z);
  }
  const glm::dvec3 moved = how == How::Cancelling ? glm::dvec3(0.0) : offset;
  stage.AddLight(LightKind::Point, moved + glm::dvec3(0.3, 0.2, 4.0), moved);
  stage.LookAt(moved + glm::dvec3(0.0, -7.0, 5.0), moved);
  stage.SetPass(technique, { { "resolution", "512" } });
  stage.Render();
  return stage.GetVisibility();
}
}

//------------------------------------------------------------------------------
// Half decades, and a third between: VTK 9.1 to 9.7 shift data from 1000 of their diagonal on. Positions
// are off by up to 6 roundings of 2^-24 of the offset's sums, 0.02 of the 0.06 of a pixel at 11,000,
// which is just before the floor is shifted: of 120 pixels at the shadow's edge a few may turn.
SHADOW_TEST(FarOrigin, OffsetsChangeNothing, Each)
{
  const Visibility expected = Show(technique, glm::dvec3(0.0), How::Points);
  ShadowTest::CheckAtMost(GetRange(expected).first, 0.1, "there is a shadow");
  for (const double exponent : { 2.0, 3.0, 3.33, 3.5, 3.67, 4.0, 4.5, 5.0, 6.5, 8.0 })
  {
    for (const How how : { How::Points, How::Position, How::Cancelling })
    {
      const double size = std::pow(10.0, exponent);
      const Difference difference =
        Compare(Show(technique, size * glm::dvec3(1.0, -0.7, 0.4), how), expected, 0.2);
      const std::string what = "1e" + std::to_string(exponent) +
                               (how == How::Points      ? " by points"
                                 : how == How::Position ? " by position"
                                                        : " against each other");
      ShadowTest::CheckAtMost(difference.Share, 12.0 / 25600.0, what + ": pixels that differ");
      ShadowTest::CheckAtMost(difference.MaskShare, 0.005, what + ": receivers that differ");
    }
  }
}

//------------------------------------------------------------------------------
// A sky of 10^6 around a scene of 10, which receives and does not cast: the scene's shadow is what it was. But that the floor has something behind it now, which it
// can shadow, so that maps hold it: of 500 pixels at edges, those within half a texel of one may change,
// of 1024 less than a quarter.
SHADOW_TEST(FarOrigin, ASkyChangesNothing, Each)
{
  const auto show = [&](bool sky)
  {
    ShadowStage stage;
    stage.AddThings();
    stage.AddLight(LightKind::Point);
    if (sky)
    {
      vtkActor* sphere = stage.AddSphere(glm::dvec3(0.0), 1e6);
      vtkShadowPass::SetCasting(sphere, false);
    }
    // The clipping range is the scene's in both: depths are as coarse as they are.
    stage.Renderer->GetActiveCamera()->SetClippingRange(0.5, 50.0);
    stage.SetPass(technique, { { "resolution", "1024" } });
    stage.Render();
    return stage.GetVisibility();
  };
  const Visibility expected = show(false);
  ShadowTest::CheckAtMost(GetRange(expected).first, 0.1, "there is a shadow");
  const Difference difference = Compare(show(true), expected, 0.05);
  ShadowTest::CheckAtMost(difference.Share, 120.0 / 25600.0, "pixels that differ");
}
