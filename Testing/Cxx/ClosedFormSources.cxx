// SPDX-License-Identifier: BSD-3-Clause
// Closed forms, continued: disks, the sun and textured lights.

#include "ClosedForms.h"
#include "ShadowTest.h"

#include "vtkImageData.h"
#include "vtkTexture.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
// Half of space is behind a straight edge (x = 0 at height h), under a disk of radius R parallel to
// it at height H. From the floor at x the edge lies on the disk's plane at X = x (1 - H / h), and
// covers all with a smaller coordinate: a segment of the disk.
SHADOW_TEST(ClosedForm, HalfPlane, Each)
{
  if (!ShadowStage::Supports(technique, LightKind::Disk))
  {
    return;
  }
  constexpr double h = 2.0;
  constexpr double H = 6.0;
  constexpr double R = 0.8;
  ShadowStage stage(200, 200);
  vtkActor* floor = stage.AddFloor(6.0);
  stage.AddQuad({ -16.0, -16.0, h }, { 16.0, 0.0, 0.0 }, { 0.0, 32.0, 0.0 });
  vtkAreaLight* light = stage.AddLight(LightKind::Disk, { 0.0, 0.0, H }, { 0.0, 0.0, 0.0 });
  light->SetRadius(R);
  stage.LookAt({ 3.0, -1.0, 1.8 }, { 0.0, 0.0, 0.0 }); // below the edge
  CheckClosedForm(
    technique, LightKind::Disk, stage, floor,
    [](const glm::dvec3& p)
    {
      const double edge = std::clamp(p.x * (1.0 - H / h) / R, -1.0, 1.0);
      const double covered =
        0.5 + (std::asin(edge) + edge * std::sqrt(1.0 - edge * edge)) / glm::radians(180.0);
      return 1.0 - covered;
    },
    [](const glm::dvec3& p) { return p.x > 0.0 ? 1.0 : 0.0; });
}

//------------------------------------------------------------------------------
// The same edge under a sphere: the disk through its centre that faces the floor's point p. The plane
// through p and the edge cuts the disk along a chord, whose distance from the centre is that of the
// centre from the plane, over the sine of the angle between plane and disk.
SHADOW_TEST(ClosedForm, HalfPlaneUnderASphere, Each)
{
  if (!ShadowStage::Supports(technique, LightKind::Sphere))
  {
    return;
  }
  constexpr double h = 2.0;
  constexpr double R = 0.8;
  const glm::dvec3 centre(1.0, -3.0, 5.0);
  ShadowStage stage(200, 200);
  vtkActor* floor = stage.AddFloor(6.0);
  stage.AddQuad({ -16.0, -16.0, h }, { 16.0, 0.0, 0.0 }, { 0.0, 32.0, 0.0 });
  stage.AddLight(LightKind::Sphere, centre, { 0.0, 0.0, 0.0 })->SetRadius(R);
  stage.LookAt({ 2.5, -1.0, 1.8 }, { -0.6, 0.0, 0.0 });
  const auto distance = [&](const glm::dvec3& p)
  {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(h, 0.0, p.x)); // away from the quad
    const glm::dvec3 towards = centre - p;
    const double cosine = glm::dot(normal, towards) / glm::length(towards);
    return glm::dot(normal, towards) / std::sqrt(1.0 - cosine * cosine);
  };
  CheckClosedForm(
    technique, LightKind::Sphere, stage, floor,
    [&](const glm::dvec3& p)
    {
      const double chord = std::clamp(distance(p) / R, -1.0, 1.0);
      return 0.5 +
             (std::asin(chord) + chord * std::sqrt(1.0 - chord * chord)) / glm::radians(180.0);
    },
    [&](const glm::dvec3& p) { return distance(p) > 0.0 ? 1.0 : 0.0; });
}

//------------------------------------------------------------------------------
// A sphere over a floor under the sun, a disk of 10 degrees. The truth is quadrature: directions
// over the disk at distance 1, of even area, each against the sphere's own equation. 4096 of them
// err by 0.5 * 4096^-0.75 = 0.001 in the penumbra; the tessellated sphere is smaller by
// (pi / 128)^2 / 2 of its radius, 0.0003, of a penumbra that is 0.35 wide: 0.001. Over all pixels that
// is a third: slack for it.
SHADOW_TEST(ClosedForm, SphereUnderTheSun, Each)
{
  if (!ShadowStage::Supports(technique, LightKind::Directional))
  {
    return;
  }
  const glm::dvec3 centre(0.0, 0.0, 1.8);
  const double radius = 0.9;
  const glm::dvec3 towards = glm::normalize(glm::dvec3(-1.0, -0.4, 2.0));
  const glm::dvec3 u = glm::normalize(glm::cross(towards, glm::dvec3(0.0, 0.0, 1.0)));
  const glm::dvec3 v = glm::cross(towards, u);
  const double extent = std::tan(glm::radians(5.0));
  std::vector<glm::dvec3> directions;
  for (int ring = 0; ring < 64; ++ring)
  {
    for (int k = 0; k < 64; ++k)
    {
      const double r = extent * std::sqrt((ring + 0.5) / 64.0);
      const double angle = glm::radians(360.0) * (k + 0.5 + 0.618 * ring) / 64.0;
      directions.push_back(
        glm::normalize(towards + r * (std::cos(angle) * u + std::sin(angle) * v)));
    }
  }
  const auto misses = [&](const glm::dvec3& p, const glm::dvec3& direction)
  {
    const glm::dvec3 to = centre - p;
    const double along = glm::dot(to, direction);
    return along < 0.0 || glm::dot(to, to) - along * along > radius * radius;
  };

  ShadowStage stage(160, 160);
  vtkActor* floor = stage.AddFloor();
  stage.AddSphere(centre, radius, 128);
  const glm::dvec3 from = 5.0 * towards;
  vtkAreaLight* light = stage.AddLight(LightKind::Directional, from, { 0.0, 0.0, 0.0 });
  light->SetAngularDiameter(10.0);
  stage.LookAt({ 3.0, -6.5, 4.0 }, { 0.3, 0.2, 0.6 });
  CheckClosedForm(
    technique, LightKind::Directional, stage, floor,
    [&](const glm::dvec3& p)
    {
      // Far from the shadow there is nothing to count.
      const double off = glm::length(glm::cross(centre - p, towards));
      if (off > radius + 0.3 * glm::length(centre - p))
      {
        return 1.0;
      }
      const auto seen = std::count_if(directions.begin(), directions.end(),
        [&](const glm::dvec3& direction) { return misses(p, direction); });
      return static_cast<double>(seen) / static_cast<double>(directions.size());
    },
    [&](const glm::dvec3& p) { return misses(p, towards) ? 1.0 : 0.0; }, 0.0007);
}

//------------------------------------------------------------------------------
// A red half and a blue half: each channel is the visibility of its half. A blocker with an edge
// across the light shows which half is which. Texels are 1/64 of the light, and the emission is
// interpolated over one where the halves meet: an error of 1/64 of a half, in the penumbra alone.
SHADOW_TEST(ClosedForm, TexturedRectangle, Each)
{
  const auto& description = ShadowStage::Describe(technique);
  if (description.Traits.Hard || description.LightShapes[5] == vtkShadowShapeSupport::Unsupported)
  {
    return;
  }
  constexpr double h = 2.0;
  constexpr double H = 6.0;
  ShadowStage stage(160, 160);
  vtkActor* floor = stage.AddFloor(6.0);
  stage.AddQuad({ -16.0, -16.0, h }, { 16.0, 0.0, 0.0 }, { 0.0, 32.0, 0.0 });
  vtkAreaLight* light = stage.AddLight(LightKind::Rectangle, { 0.0, 0.0, H }, { 0.0, 0.0, 0.0 });
  light->SetWidth(2.0);
  light->SetHeight(2.0);
  vtkNew<vtkImageData> emission;
  emission->SetDimensions(64, 2, 1);
  emission->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 128; ++i)
  {
    const bool right = i % 64 >= 32;
    auto* texel = static_cast<unsigned char*>(emission->GetScalarPointer(i % 64, i / 64, 0));
    texel[0] = right ? 0 : 255;
    texel[1] = 0;
    texel[2] = right ? 255 : 0;
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(emission);
  light->SetTexture(texture);
  stage.LookAt({ 3.0, -1.0, 1.8 }, { 0.0, 0.0, 0.0 });
  stage.SetPass(technique, { { "samples", "256" }, { "resolution", "512" } });
  stage.Render();
  const Visibility visibility = stage.GetVisibility();
  if (!ShadowTest::CheckEqual(visibility.Components, 3, "components"))
  {
    return;
  }
  const ShadowOracle oracle(stage);
  const auto mask = oracle.GetMask(floor);
  const auto inner = oracle.GetInner(1);
  double sum[2] = { 0.0, 0.0 };
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    if (!mask[i] || !inner[i])
    {
      continue;
    }
    // Width runs along -z x y = x: red is from -1 to 0, blue from 0 to 1. What is left of the edge
    // is covered.
    const double edge = oracle.GetPixels()[i].Position.x * (1.0 - H / h);
    const double red = 1.0 - std::clamp(edge + 1.0, 0.0, 1.0);
    const double blue = 1.0 - std::clamp(edge, 0.0, 1.0);
    sum[0] += std::pow(visibility.V[3 * i] - red, 2.0);
    sum[1] += std::pow(visibility.V[3 * i + 2] - blue, 2.0);
    ++pixels;
  }
  ShadowTest::CheckAtLeast(static_cast<double>(pixels), 5000.0, "pixels");
  // Half of the samples for each channel: 0.5 * 128^-0.75 = 0.013 in the penumbra, of a share of a
  // sixth, and the texel. A technique that takes the light for evenly bright is off by half at most.
  const bool exact = description.LightShapes[5] == vtkShadowShapeSupport::Exact;
  const double bound = exact ? 0.006 : 0.5 * std::sqrt(1.0 / 6.0);
  ShadowTest::CheckAtMost(std::sqrt(sum[0] / static_cast<double>(pixels)), bound, "red: RMSE");
  ShadowTest::CheckAtMost(std::sqrt(sum[1] / static_cast<double>(pixels)), bound, "blue: RMSE");
}
