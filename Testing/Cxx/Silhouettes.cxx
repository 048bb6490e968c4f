// SPDX-License-Identifier: BSD-3-Clause
// Where the far side of a body wins VTK's depth test, at its silhouette, what is seen is its outside: rays that
// start there do not start within the body.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkAreaLight.h"
#include "vtkSphereSource.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <string>

//------------------------------------------------------------------------------
// A faceted ball alone, of which the light sees all that is left of the middle of the picture: from 57 degrees
// left of the viewer, up to the silhouette with 33 degrees to spare. From forty sides, since one picture in three
// has such a pixel. Left are those of faces that the rasterizer's grid turns, so much from the side they are seen.
SHADOW_TEST(Silhouettes, AreOutside, Once)
{
  constexpr int side = 300;
  for (const char* name : { "ray-traced", "ray-adaptive" })
  {
    ShadowStage stage(side, side);
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(1.0);
    ball->SetThetaResolution(60);
    ball->SetPhiResolution(30);
    ball->GenerateNormalsOff();
    ball->Update();
    stage.Add(ball->GetOutput());
    vtkAreaLight* light = stage.AddLight(LightKind::Point);
    stage.SetPass(name, { { "terminator", "facets" } });
    double receivers = 0.0;
    double hidden = 0.0;
    for (int i = 0; i < 40; ++i)
    {
      const double turn = 0.3 + 0.1237 * i;
      const double rise = 0.35 + 0.05 * (i % 7);
      const glm::dvec3 viewer(
        std::cos(turn) * std::cos(rise), std::sin(turn) * std::cos(rise), std::sin(rise));
      const glm::dvec3 left = glm::normalize(glm::cross(viewer, glm::dvec3(0.0, 0.0, 1.0)));
      stage.LookAt(4.3 * viewer, glm::dvec3(0.0), 30.0);
      const glm::dvec3 place = 20.0 * (std::cos(1.0) * viewer + std::sin(1.0) * left);
      light->SetPosition(place.x, place.y, place.z);
      stage.Render();
      const Visibility seen = stage.GetVisibility();
      for (int y = 0; y < side; ++y)
      {
        for (int x = 0; x < side / 2; ++x)
        {
          const bool receives = seen.Mask[static_cast<std::size_t>(y) * side + x] != 0;
          receivers += receives ? 1.0 : 0.0;
          hidden += receives && seen(x, y) < 0.5f ? 1.0 : 0.0;
        }
      }
    }
    ShadowTest::CheckAtLeast(receivers, 1e6, std::string(name) + ": receivers");
    ShadowTest::CheckAtMost(hidden, 4.0, std::string(name) + ": pixels without light"); // 13
  }
}
