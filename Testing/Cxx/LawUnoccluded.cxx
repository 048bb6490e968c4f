// SPDX-License-Identifier: BSD-3-Clause
// Laws: what nothing hides is lit, exactly; visibility is a share.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkLightCollection.h"
#include "vtkShadowScenes.h"

#include <glm/geometric.hpp>

namespace
{
/** Share of receivers, of those to be used, whose V is not what it must be. */
double ShareOther(
  const Visibility& visibility, const std::vector<unsigned char>& use, float expected)
{
  std::size_t used = 0;
  std::size_t other = 0;
  for (std::size_t i = 0; i < use.size(); ++i)
  {
    if (use[i] && visibility.Mask[i])
    {
      ++used;
      other += !(visibility.V[i] == expected);
    }
  }
  return static_cast<double>(other) / static_cast<double>(used); // NaN where none is used
}

void CheckAllOne(ShadowStage& stage, const std::string& what)
{
  stage.Render();
  const Visibility visibility = stage.GetVisibility(0);
  const auto range = GetRange(visibility);
  ShadowTest::CheckAtLeast(
    static_cast<double>(visibility.GetNumberOfReceivers()), 5000.0, what + ", receivers");
  ShadowTest::CheckEqual(range.first, 1.0, what + ", lowest V");
  ShadowTest::CheckEqual(range.second, 1.0, what + ", highest V");
}

/** The box that holds the emitter: a corner of it sees what the emitter sees at least. */
std::vector<glm::dvec3> GetCorners(const glm::dvec3& centre, double reach)
{
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back(
      centre + reach * glm::dvec3(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0));
  }
  return corners;
}
}

//------------------------------------------------------------------------------
// Without an occluder V is not almost 1 but 1: a floor alone, and things whose casting is off.
SHADOW_TEST(Law, UnoccludedIsOne, Each)
{
  for (const LightKind kind : LightKinds)
  {
    if (!ShadowStage::Supports(technique, kind))
    {
      continue;
    }
    ShadowStage stage;
    stage.AddFloor();
    stage.AddLight(kind);
    stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
    stage.SetPass(technique);
    CheckAllOne(stage, std::string(GetName(kind)) + ", floor alone");

    stage.Renderer->RemoveAllViewProps();
    stage.AddThings();
    vtkPropCollection* props = stage.Renderer->GetViewProps();
    for (int i = 1; i < props->GetNumberOfItems(); ++i) // 0 is the floor
    {
      vtkShadowPass::SetCasting(vtkProp::SafeDownCast(props->GetItemAsObject(i)), false);
    }
    CheckAllOne(stage, std::string(GetName(kind)) + ", things that do not cast");
  }
}

//------------------------------------------------------------------------------
// A facet of a convex body that has the whole light in front of its plane cannot be hidden by the
// body; one that has all of it behind is dark. Both to the last bit, also where light grazes: no
// acne, no leak. Facets within 0.01 rad of the light's edge are left out, for normals of 12 bits.
SHADOW_TEST(Law, ConvexBodyIsLitOrDark, Each)
{
  for (const double height : { 6.0, 2.0, 0.4 })
  {
    for (const bool sphere : { false, true })
    {
      const LightKind kind =
        ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point;
      const glm::dvec3 position(-5.0, -3.0, height);
      ShadowStage stage;
      sphere ? stage.AddSphere({ 0.0, 0.0, 0.0 }, 1.0)
             : stage.AddBox({ 0.0, 0.0, 0.0 }, { 1.2, 1.4, 1.0 });
      vtkAreaLight* light = stage.AddLight(kind, position, { 0.0, 0.0, 0.0 });
      light->SetRadius(0.3);
      stage.LookAt({ -1.0, -6.0, 2.0 }, { 0.0, 0.0, 0.0 }, 26.0);
      stage.SetPass(technique, { { "denoise", "off" } }); // a mean over pixels is of several facets
      stage.Render();
      const Visibility visibility = stage.GetVisibility(0);
      if (ShadowStage::Describe(technique).Traits.PlanarReceivers)
      {
        ShadowTest::TakeMessages(); // nothing is flat
      }

      const ShadowOracle oracle(stage);
      const auto& pixels = oracle.GetPixels();
      const double reach = kind == LightKind::Sphere ? 0.3 : 0.0;
      std::vector<int> sides(pixels.size(), 0); // 1 sees all of the light, -1 nothing, 0 unsure
      for (std::size_t i = 0; i < pixels.size(); ++i)
      {
        int front = 0;
        int behind = 0;
        for (const auto& corner : GetCorners(position, reach))
        {
          const glm::dvec3 towards = corner - pixels[i].Position;
          const double sine = glm::dot(pixels[i].Normal, towards) / glm::length(towards);
          front += sine > 0.01;
          behind += sine < -0.01;
        }
        sides[i] = !pixels[i].Actor ? 0 : (front == 8 ? 1 : (behind == 8 ? -1 : 0));
      }
      // The rasterizer may see the next facet at a facet's border.
      std::vector<unsigned char> lit(pixels.size(), 0);
      std::vector<unsigned char> dark(pixels.size(), 0);
      const int width = visibility.Width;
      for (std::size_t i = width + 1; i + width + 1 < pixels.size(); ++i)
      {
        int sum = 0;
        for (int k = 0; k < 9; ++k)
        {
          sum += sides[i + k % 3 - 1 + (k / 3 - 1) * width];
        }
        lit[i] = sum == 9;
        dark[i] = sum == -9;
      }
      const std::string what = std::string(sphere ? "sphere" : "box") + ", light at height " +
                               std::to_string(height).substr(0, 3);
      ShadowTest::CheckEqual(ShareOther(visibility, lit, 1.0f), 0.0, what + ": lit and not 1");
      if (sphere) // the box shows no dark side
      {
        ShadowTest::CheckEqual(ShareOther(visibility, dark, 0.0f), 0.0, what + ": dark and not 0");
      }
    }
  }
}

//------------------------------------------------------------------------------
// What has the whole light and all casters on different sides of a plane is lit, exactly: the floor
// on the light's side of the box.
SHADOW_TEST(Law, FloorTowardsLightIsOne, Each)
{
  for (const LightKind kind : LightKinds)
  {
    if (!ShadowStage::Supports(technique, kind))
    {
      continue;
    }
    ShadowStage stage;
    vtkActor* floor = stage.AddFloor();
    stage.AddBox({ 0.6, 0.3, 0.6 }, { 1.0, 1.0, 1.2 });
    stage.AddLight(kind, { -2.5, 0.0, 4.0 }, { 0.0, 0.0, 0.0 });
    stage.LookAt({ -2.0, -7.0, 4.5 }, { 0.0, 0.0, 0.3 });
    // At a contact no filter of a constant width, no mean over pixels, no slices as if independent of each
    // other, which are nowhere quite dark.
    stage.SetPass(technique, { { "width", "0.05" }, { "denoise", "off" }, { "combine", "bits" },
                               { "double-projection", "on" } });
    stage.Render();
    const Visibility visibility = stage.GetVisibility(0);
    const ShadowOracle oracle(stage);
    auto use = oracle.GetMask(floor);
    for (std::size_t i = 0; i < use.size(); ++i)
    {
      // The box starts at x = 0.1; a texel of a map is 0.01.
      use[i] = use[i] && oracle.GetPixels()[i].Position.x < 0.05;
    }
    ShadowTest::CheckEqual(
      ShareOther(visibility, use, 1.0f), 0.0, std::string(GetName(kind)) + ": not 1");
    ShadowTest::CheckEqual(GetRange(visibility).first, 0.0, "the shadow itself");
  }
}

//------------------------------------------------------------------------------
// V is finite and in [0,1], wherever the light is.
SHADOW_TEST(Law, IsAShare, Each)
{
  const auto check = [](ShadowStage& stage, const std::string& what)
  {
    stage.Render();
    const Visibility visibility = stage.GetVisibility(0);
    const auto range = GetRange(visibility);
    ShadowTest::CheckAtLeast(
      static_cast<double>(visibility.GetNumberOfReceivers()), 5000.0, what + ", receivers");
    ShadowTest::CheckAtLeast(range.first, 0.0, what + ", lowest V");
    ShadowTest::CheckAtMost(range.second, 1.0, what + ", highest V");
  };
  {
    ShadowStage stage;
    vtkShadowScenes::Build("basic", stage.Renderer);
    if (!ShadowStage::Supports(technique, LightKind::Rectangle))
    {
      vtkAreaLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0))
        ->SetShapeToPoint();
    }
    stage.SetPass(technique);
    check(stage, "scene basic");
  }
  const std::pair<const char*, glm::dvec3> places[] = {
    { "among the casters", { 0.1, 0.5, 0.7 } },
    { "on the box's top", { -0.8, 0.3, 1.2 } },
    { "on a corner of the box", { -0.3, -0.2, 1.2 } },
    { "in the floor's plane", { 1.5, 1.0, 0.0 } },
    { "inside the box", { -0.8, 0.3, 0.6 } },
    { "inside the sphere", { 0.9, -0.5, 1.3 } },
    { "below the floor", { 0.5, 0.5, -2.0 } },
  };
  for (const auto& place : places)
  {
    for (const LightKind kind : { LightKind::Point, LightKind::Sphere, LightKind::Rectangle })
    {
      if (ShadowStage::Supports(technique, kind))
      {
        ShadowStage stage;
        stage.AddThings();
        stage.AddLight(kind, place.second, place.second + glm::dvec3(0.0, 0.0, 1.0));
        stage.SetPass(technique);
        const std::string what = std::string(GetName(kind)) + " " + place.first;
        check(stage, what);
        // Filters may say that the light is too near to a caster.
        for (const auto& message : ShadowTest::TakeMessages())
        {
          ShadowTest::Check(message.Source == ShadowTest::Message::Warning &&
                              message.Text.find("among its casters") != std::string::npos,
            what + ": " + message.Text);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// A closed box holds its light back. Along the floor a map may leak by a texel, which is less than a
// pixel here, and so may the seams of a cube of maps: 40 pixels of edges in 25,600.
SHADOW_TEST(Law, BoxHoldsItsLight, Each)
{
  for (const LightKind kind : { LightKind::Point, LightKind::Sphere })
  {
    if (!ShadowStage::Supports(technique, kind))
    {
      continue;
    }
    if (kind == LightKind::Sphere && (technique == "planar-fake" || technique == "virtual-maps" ||
                                       technique == "occlusion-textures"))
    {
      // The mean of blockers next to the light and far shadows; slices next to a wall: declared limits.
      continue;
    }
    ShadowStage stage;
    stage.AddThings();
    vtkAreaLight* light = stage.AddLight(kind, { -0.75, 0.35, 0.55 }, { 0.0, 0.0, 0.0 });
    light->SetRadius(0.2);
    // A filter of constant width looks as far around it at a contact: a narrow one.
    stage.SetPass(technique, { { "width", "0.003" } });
    stage.Render();
    const Visibility visibility = stage.GetVisibility(0);
    Visibility dark = visibility;
    dark.V.assign(dark.V.size(), 0.0f);
    const auto use = ShadowStage::Describe(technique).Traits.PlanarReceivers
                       ? ShadowOracle(stage).GetFlatMask()
                       : std::vector<unsigned char>();
    ShadowTest::CheckAtMost(Compare(visibility, dark, 0.01, use).Share, 0.002,
      std::string(GetName(kind)) + ": lit outside");
  }
}
