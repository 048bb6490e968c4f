// SPDX-License-Identifier: BSD-3-Clause
// Debug views show something, and leave no trace.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

//------------------------------------------------------------------------------
SHADOW_TEST(DebugViews, EachShowsSomething, Each)
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(ShadowStage::Supports(technique, LightKind::Rectangle) ? LightKind::Rectangle
                                                                        : LightKind::Point);
  stage.SetPass(technique);
  stage.Render();
  const Picture plain = stage.GetPicture();
  std::istringstream views(stage.Pass->GetDebugViews());
  std::set<std::string> names;
  for (std::string view; views >> view;)
  {
    names.insert(view);
    ShadowTest::Check(stage.Pass->SetDebugView(view), "cannot set view " + view);
    ShadowTest::Check(stage.Pass->GetDebugView() == view, "view is not what was set: " + view);
    stage.Render();
    const Picture picture = stage.GetPicture();
    std::set<int> colors;
    for (std::size_t i = 0; i < picture.RGB.size(); i += 3)
    {
      colors.insert(picture.RGB[i] * 65536 + picture.RGB[i + 1] * 256 + picture.RGB[i + 2]);
    }
    // Background and two values at least: more than a constant over the receivers.
    ShadowTest::CheckAtLeast(static_cast<double>(colors.size()), 3.0, "view " + view + ", colours");
    ShadowTest::Check(
      Same(picture, plain) == (view == "none"), "view " + view + " against the picture");
  }
  for (const char* name : { "none", "visibility", "penumbra", "cost" })
  {
    ShadowTest::Check(names.count(name) == 1, std::string("there is no view ") + name);
  }
  stage.Pass->SetDebugView("none");
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), plain), "the picture after the views differs");
}

//------------------------------------------------------------------------------
// The view of visibility shows V as grey, 8 bits.
SHADOW_TEST(DebugViews, VisibilityIsV, Each)
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(ShadowStage::Supports(technique, LightKind::Rectangle) ? LightKind::Rectangle
                                                                        : LightKind::Point);
  stage.SetPass(technique);
  stage.Pass->SetDebugView("visibility");
  stage.Render();
  const Picture picture = stage.GetPicture();
  const Visibility visibility = stage.GetVisibility();
  int worst = 0;
  for (std::size_t i = 0; i < visibility.V.size(); ++i)
  {
    if (visibility.Mask[i])
    {
      worst =
        std::max(worst, std::abs(int(picture.RGB[3 * i]) - int(255.0f * visibility.V[i] + 0.5f)));
    }
  }
  ShadowTest::CheckAtMost(worst, 1.0, "largest difference, of 255");
  ShadowTest::CheckEqual(GetRange(visibility).first, 0.0, "there is a shadow");
}
