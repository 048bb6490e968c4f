// SPDX-License-Identifier: BSD-3-Clause
// Sobol's points, the disk map, a light's samples and their weights, and which lights cast at all.

#include "ShadowTesting.h"

#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkShadowLight.h"
#include "vtkShadowSampling.h"
#include "vtkShadowTags.h"
#include "vtkTexture.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace
{
using Shape = vtkShadowLight::Shape;

//------------------------------------------------------------------------------
// 2^k points that follow each other, from a multiple of 2^k on, put exactly one into each of the
// 2^k cells of equal size, whatever the cells' proportions.
bool IsNet(const std::vector<vtkShadowSampling::Bits>& points, int first, int k)
{
  for (int a = 0; a <= k; ++a)
  {
    std::set<std::pair<std::uint64_t, std::uint64_t>> cells;
    for (int i = first; i < first + (1 << k); ++i)
    {
      cells.insert({ static_cast<std::uint64_t>(points[i].X) >> (32 - a),
        static_cast<std::uint64_t>(points[i].Y) >> (32 - (k - a)) });
    }
    if (cells.size() != std::size_t(1) << k)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void TestSobol()
{
  CHECK(vtkShadowSampling::Sobol(0).empty());
  const auto points = vtkShadowSampling::Sobol(4096);
  CHECK_EQUAL(points.size(), std::size_t(4096));
  std::set<std::pair<std::uint32_t, std::uint32_t>> distinct;
  for (const auto& point : points)
  {
    distinct.insert({ point.X, point.Y });
    const glm::dvec2 unit = vtkShadowSampling::ToUnit(point);
    CHECK(unit.x > 0.0 && unit.x < 1.0 && unit.y > 0.0 && unit.y < 1.0);
  }
  CHECK_EQUAL(distinct.size(), points.size());
  for (int k = 0; k <= 10; ++k)
  {
    CHECK(IsNet(points, 0, k));
    CHECK(IsNet(points, 1 << k, k));
    CHECK(IsNet(points, 3 << k, k));
  }
  // Few points are the first of many.
  const auto few = vtkShadowSampling::Sobol(100);
  for (std::size_t i = 0; i < few.size(); ++i)
  {
    CHECK(few[i].X == points[i].X && few[i].Y == points[i].Y);
  }
  // The ends of the range stay within the square.
  const glm::dvec2 last = vtkShadowSampling::ToUnit({ 0xffffffffu, 0xffffffffu });
  CHECK(last.x < 1.0 && last.y < 1.0);
  // A word's hash says little about the next one's: half the bits differ.
  int differing = 0;
  for (std::uint32_t i = 0; i < 1000; ++i)
  {
    std::uint32_t bits = vtkShadowSampling::Hash(i) ^ vtkShadowSampling::Hash(i + 1);
    for (; bits; bits &= bits - 1)
    {
      ++differing;
    }
  }
  CHECK_NEAR(differing / 1000.0, 16.0, 0.5);
}

//------------------------------------------------------------------------------
void TestDiskMap()
{
  using vtkShadowSampling::ConcentricDisk;
  CHECK_EQUAL(glm::length(ConcentricDisk({ 0.5, 0.5 })), 0.0);
  CHECK_NEAR(glm::length(ConcentricDisk({ 0.0, 0.3 })), 1.0, 1e-12);
  CHECK_NEAR(glm::length(ConcentricDisk({ 0.8, 1.0 })), 1.0, 1e-12);
  CHECK_NEAR(glm::length(ConcentricDisk({ 1.0, 1.0 })), 1.0, 1e-12);
  const double h = 1e-6;
  for (int i = 0; i < 40; ++i)
  {
    for (int j = 0; j < 40; ++j)
    {
      // Off the diagonals, on which the map has a kink.
      const glm::dvec2 p((i + 0.37) / 40.0, (j + 0.61) / 40.0);
      CHECK(glm::length(ConcentricDisk(p)) <= 1.0 + 1e-12);
      const glm::dvec2 dx =
        (ConcentricDisk(p + glm::dvec2(h, 0.0)) - ConcentricDisk(p - glm::dvec2(h, 0.0))) / (2 * h);
      const glm::dvec2 dy =
        (ConcentricDisk(p + glm::dvec2(0.0, h)) - ConcentricDisk(p - glm::dvec2(0.0, h))) / (2 * h);
      // The square's area, 1, becomes the disk's, pi, in the same ratio everywhere.
      CHECK_NEAR(std::abs(dx.x * dy.y - dx.y * dy.x), glm::pi<double>(), 1e-6);
    }
  }
}

//------------------------------------------------------------------------------
vtkShadowLight GatherOne(vtkAreaLight* area)
{
  vtkNew<vtkRenderer> renderer;
  renderer->AddLight(area);
  const auto lights = vtkShadowLight::Gather(renderer, 0.0);
  CHECK_EQUAL(lights.size(), std::size_t(1));
  return lights.empty() ? vtkShadowLight() : lights[0];
}

//------------------------------------------------------------------------------
bool IsOnShape(const vtkShadowLight& light, const glm::dvec3& p, const glm::dvec3& receiver)
{
  const double rounding = 1e-12;
  if (light.IsDirectional())
  {
    const double least = std::cos(std::atan(glm::length(light.U)));
    return std::abs(glm::length(p) - 1.0) < rounding &&
           glm::dot(p, -light.Direction) > least - rounding;
  }
  const glm::dvec3 d = p - light.Position;
  const double u = glm::length(light.U) > 0.0 ? glm::length(light.U) : 1.0;
  const double v = glm::length(light.V) > 0.0 ? glm::length(light.V) : 1.0;
  const double x = glm::dot(d, light.U) / (u * u);
  const double y = glm::dot(d, light.V) / (v * v);
  const bool inPlane = std::abs(glm::dot(d, light.Direction)) < rounding * (1.0 + u + v);
  switch (light.Kind)
  {
    case Shape::Point:
      return d == glm::dvec3(0.0);
    case Shape::Rectangle:
      return inPlane && std::abs(x) <= 1.0 && std::abs(y) <= 1.0;
    case Shape::Disk:
      return inPlane && x * x + y * y <= 1.0 + rounding;
    default:
      return glm::length(d) <= u * (1.0 + rounding) &&
             std::abs(glm::dot(d, glm::normalize(receiver - light.Position))) <
               rounding * (1.0 + u);
  }
}

//------------------------------------------------------------------------------
// On the shape; in the middle of it on average; weights that sum to 1.
void CheckSamples(const vtkShadowLight& light)
{
  const glm::dvec3 receiver(0.5, -2.0, 0.25);
  const glm::dvec3 centre = light.IsDirectional() ? -light.Direction : light.Position;
  const double size = std::max(glm::length(light.U), glm::length(light.V));
  for (const int count : { 1, 2, 3, 4, 7, 16, 25, 64, 100, 256, 1024 })
  {
    const auto samples = light.GetSamples(count, receiver);
    CHECK_EQUAL(samples.size(), std::size_t(light.IsPoint() ? 1 : count));
    glm::dvec3 mean(0.0);
    glm::dvec3 weight(0.0);
    for (const auto& sample : samples)
    {
      CHECK(IsOnShape(light, sample.Point, receiver));
      mean += sample.Weight * sample.Point;
      weight += sample.Weight;
    }
    for (int c = 0; c < 3; ++c)
    {
      CHECK_NEAR(weight[c], 1.0, 1e-12);
    }
    // Powers of two are stratified: their mean on a rectangle is its centre, on a disk nearly so.
    // Other counts miss it by the discrepancy of a (0,2)-sequence, some strata over count.
    // Directions lie on the unit sphere, their mean a little inside.
    const bool stratified = (count & (count - 1)) == 0;
    const double bend = light.IsDirectional() ? size * size : 0.0;
    const double strata = !stratified ? 2.0 : (light.Kind == Shape::Rectangle ? 0.0 : 0.3);
    const double tolerance = size * strata / count + bend + 1e-8;
    CHECK_NEAR(glm::length(mean - centre), 0.0, tolerance);
  }
}

//------------------------------------------------------------------------------
void TestShapes()
{
  vtkNew<vtkAreaLight> area;
  area->SetPosition(1.0, 2.0, 3.0);
  area->SetFocalPoint(0.5, 0.0, 0.0);
  area->SetRadius(0.75);
  area->SetWidth(2.0);
  area->SetHeight(0.5);
  area->SetUpVector(0.0, 0.0, 1.0);
  for (int shape = vtkAreaLight::Point; shape <= vtkAreaLight::Rectangle; ++shape)
  {
    area->SetShape(shape);
    const vtkShadowLight light = GatherOne(area);
    CHECK_EQUAL(static_cast<int>(light.Kind), shape);
    CHECK_EQUAL(light.IsPoint(), shape == vtkAreaLight::Point);
    CheckSamples(light);
  }
  area->SetShapeToSphere();
  area->SetRadius(0.0);
  CHECK(GatherOne(area).IsPoint());

  // A rectangle's width runs along direction x up; up parallel to the direction is no failure.
  area->SetShapeToRectangle();
  area->SetPosition(0.0, 0.0, 5.0);
  area->SetFocalPoint(0.0, 0.0, 0.0);
  area->SetUpVector(0.0, 3.0, 1.0);
  vtkShadowLight light = GatherOne(area);
  CHECK_NEAR(glm::length(light.U - glm::dvec3(1.0, 0.0, 0.0)), 0.0, 1e-12);
  CHECK_NEAR(glm::length(light.V - glm::dvec3(0.0, 0.25, 0.0)), 0.0, 1e-12);
  area->SetUpVector(0.0, 0.0, 1.0);
  light = GatherOne(area);
  CHECK_NEAR(glm::length(light.U), 1.0, 1e-12);
  CHECK_NEAR(glm::dot(light.U, light.Direction), 0.0, 1e-12);
  CheckSamples(light);
  area->SetWidth(0.0); // a line
  light = GatherOne(area);
  CHECK(!light.IsPoint());
  CheckSamples(light);

  area->PositionalOff();
  area->SetAngularDiameter(10.0);
  light = GatherOne(area);
  CHECK(light.IsDirectional());
  CHECK_NEAR(glm::length(light.U), std::tan(glm::radians(5.0)), 1e-12);
  CheckSamples(light);
  area->SetAngularDiameter(0.0);
  CHECK(GatherOne(area).IsPoint());
  CheckSamples(GatherOne(area));
}

//------------------------------------------------------------------------------
// A sphere's disk turns to each receiver; a receiver in its centre is no failure.
void TestSphereFacesReceiver()
{
  vtkNew<vtkAreaLight> area;
  area->SetPosition(0.0, 0.0, 2.0);
  const vtkShadowLight light = GatherOne(area);
  for (const glm::dvec3& receiver :
    { glm::dvec3(0.0, 0.0, 0.0), glm::dvec3(5.0, 0.0, 2.0), glm::dvec3(-1.0, 3.0, 7.0) })
  {
    for (const auto& sample : light.GetSamples(64, receiver))
    {
      CHECK(IsOnShape(light, sample.Point, receiver));
    }
  }
  for (const auto& sample : light.GetSamples(16, light.Position))
  {
    CHECK(sample.Point == light.Position);
  }
}

//------------------------------------------------------------------------------
// Emission: 2 x 2 texels; (0,0) red, (1,0) green, (0,1) white, (1,1) black, no blue but in white.
void TestEmission()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const double colors[4][3] = { { 255, 0, 0 }, { 0, 255, 0 }, { 255, 255, 255 }, { 0, 0, 0 } };
  for (int i = 0; i < 4; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      image->SetScalarComponentFromDouble(i % 2, i / 2, 0, c, colors[i][c]);
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  vtkNew<vtkAreaLight> area;
  area->SetShapeToRectangle();
  area->SetPosition(0.0, 0.0, 5.0);
  area->SetTexture(texture);
  const vtkShadowLight light = GatherOne(area);
  CHECK(light.Emission != nullptr);

  CHECK_NEAR(glm::length(light.GetEmission({ 0.25, 0.25 }) - glm::dvec3(1, 0, 0)), 0.0, 1e-12);
  CHECK_NEAR(glm::length(light.GetEmission({ 0.75, 0.25 }) - glm::dvec3(0, 1, 0)), 0.0, 1e-12);
  CHECK_NEAR(glm::length(light.GetEmission({ 0.0, 1.0 }) - glm::dvec3(1, 1, 1)), 0.0, 1e-12);
  CHECK_NEAR(glm::length(light.GetEmission({ 0.5, 0.25 }) - glm::dvec3(0.5, 0.5, 0)), 0.0, 1e-12);

  const auto samples = light.GetSamples(256, glm::dvec3(0.0));
  glm::dvec3 sum(0.0);
  glm::dvec3 mean(0.0);
  for (const auto& sample : samples)
  {
    const glm::dvec3 d = sample.Point - light.Position;
    const glm::dvec2 unit(0.5 + 0.5 * glm::dot(d, light.U) / glm::dot(light.U, light.U),
      0.5 + 0.5 * glm::dot(d, light.V) / glm::dot(light.V, light.V));
    // In proportion to the emission at the very place.
    const glm::dvec3 emission = light.GetEmission(unit);
    CHECK(emission.x > 0.0 || sample.Weight.x == 0.0);
    CHECK_NEAR(sample.Weight.x * 128.0, emission.x, 0.01);
    sum += sample.Weight;
    mean += sample.Weight * glm::dvec3(unit, 0.0)[0];
  }
  for (int c = 0; c < 3; ++c)
  {
    CHECK_NEAR(sum[c], 1.0, 1e-12);
  }
  CHECK(mean.x < 0.4); // red sits at -width/2
  CHECK_NEAR(mean.y, 0.5, 0.01);
  CHECK(mean.z < 0.4);

  // A channel without emission, and a black texture, still give weights that sum to 1.
  for (int i = 0; i < 4; ++i)
  {
    for (int c = 1; c < 3; ++c)
    {
      image->SetScalarComponentFromDouble(i % 2, i / 2, 0, c, 0.0);
    }
  }
  image->Modified();
  CHECK(!GatherOne(area).SameGeometry(light));
  CheckSamples(
    [&]
    {
      vtkShadowLight other = GatherOne(area);
      other.Emission = nullptr; // uniform again: the mean is the centre
      return other;
    }());
  glm::dvec3 red(0.0);
  for (const auto& sample : GatherOne(area).GetSamples(16, glm::dvec3(0.0)))
  {
    red += sample.Weight;
    CHECK_EQUAL(sample.Weight.y, 1.0 / 16);
  }
  CHECK_NEAR(glm::length(red - glm::dvec3(1.0)), 0.0, 1e-12);
}

//------------------------------------------------------------------------------
void TestGather()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkAreaLight> off;
  off->SwitchOff();
  vtkNew<vtkAreaLight> black;
  black->SetColor(0.0, 0.0, 0.0);
  vtkNew<vtkAreaLight> dark;
  dark->SetIntensity(0.0);
  vtkNew<vtkAreaLight> unattenuated;
  unattenuated->SetShadowAttenuation(0.0f);
  vtkNew<vtkAreaLight> notCasting;
  vtkShadowTags::SetLightCasting(notCasting, false);
  vtkNew<vtkLight> plain;
  plain->PositionalOn();
  plain->SetConeAngle(120.0);
  vtkNew<vtkLight> distant;
  for (vtkLight* light :
    std::vector<vtkLight*>{ off, black, dark, unattenuated, notCasting, plain, distant })
  {
    renderer->AddLight(light);
  }
  const auto lights = vtkShadowLight::Gather(renderer, 0.25);
  CHECK_EQUAL(lights.size(), std::size_t(2));
  if (lights.size() == 2)
  {
    // Slots count all lights that are on, as VTK's shaders do.
    CHECK(lights[0].Light == plain);
    CHECK_EQUAL(lights[0].Slot, 4);
    CHECK(lights[0].Kind == Shape::Sphere);
    CHECK_NEAR(glm::length(lights[0].U), 0.25, 1e-12);
    CHECK_EQUAL(lights[0].ConeAngle, 90.0);
    CHECK(lights[1].Light == distant);
    CHECK_EQUAL(lights[1].Slot, 5);
    CHECK(lights[1].IsDirectional() && lights[1].IsPoint());
  }
  const auto points = vtkShadowLight::Gather(renderer, 0.0);
  CHECK(!points.empty() && points[0].IsPoint());
  // A distant light is its direction: moving both of its points changes nothing.
  distant->SetPosition(10.0, 0.0, 1.0);
  distant->SetFocalPoint(10.0, 0.0, 0.0);
  const auto moved = vtkShadowLight::Gather(renderer, 0.0);
  CHECK(moved.size() == 2 && points.size() == 2 && moved[1].SameGeometry(points[1]));
  distant->SetPosition(11.0, 0.0, 1.0);
  CHECK(!vtkShadowLight::Gather(renderer, 0.0)[1].SameGeometry(points[1]));
}
}

//------------------------------------------------------------------------------
int TestLightSamples(int, char*[])
{
  TestSobol();
  TestDiskMap();
  TestShapes();
  TestSphereFacesReceiver();
  TestEmission();
  TestGather();
  return ShadowTesting::Result();
}
