// SPDX-License-Identifier: BSD-3-Clause
// The harness itself: that it sees what it is there to see.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkObject.h"
#include "vtkShadowOpenGL.h"

#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
SHADOW_TEST(Harness, CatchesErrors, Once)
{
  ShadowStage stage(32, 32);
  stage.AddFloor();
  stage.Render();
  ShadowTest::CheckNoMessage("plain frame");

  glEnable(0x1234); // no such state
  auto messages = ShadowTest::TakeMessages();
  ShadowTest::Check(!messages.empty() && messages[0].Source == ShadowTest::Message::GL,
    "an OpenGL error was not seen");
  while (glGetError() != GL_NO_ERROR)
  {
  }

  vtkGenericWarningMacro("of the test");
  ShadowTest::CheckOneMessage(ShadowTest::Message::Warning, { "of the test" }, "a warning");
  vtkErrorWithObjectMacro(stage.Renderer, "of the test");
  ShadowTest::CheckOneMessage(ShadowTest::Message::Error, { "of the test" }, "an error");
}

//------------------------------------------------------------------------------
SHADOW_TEST(Harness, ChecksFail, Once)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ShadowTest::ExpectFailures();
  int wrong = 0;
  wrong += ShadowTest::CheckAtMost(2.0, 1.0, "meant to fail");
  wrong += ShadowTest::CheckAtMost(nan, 1.0, "meant to fail");
  wrong += ShadowTest::CheckAtLeast(nan, 1.0, "meant to fail");
  wrong += ShadowTest::CheckEqual(nan, 1.0, "meant to fail");
  wrong += ShadowTest::CheckOneMessage(ShadowTest::Message::Error, {}, "meant to fail");

  Visibility a{ 2, 1, 1, { 0.0f, 1.0f }, { 1, 1 } };
  Visibility b = a;
  b.V[1] = std::nanf("");
  wrong += Same(a, b);
  wrong += ShadowTest::CheckAtMost(Compare(a, b).RMSE, 0.1, "meant to fail");
  wrong += ShadowTest::CheckAtMost(GetRange(b).second, 1.0, "meant to fail");
  b.Mask = { 0, 0 };
  wrong += ShadowTest::CheckAtMost(Compare(a, b).RMSE, 0.1, "meant to fail");
  b = { 1, 1, 1, { 0.0f }, { 1 } };
  wrong += ShadowTest::CheckAtMost(Compare(a, b).RMSE, 0.1, "meant to fail");
  const int failures = ShadowTest::TakeFailures();
  ShadowTest::Check(wrong == 0 && failures == 10, "a check held that must not");
}

//------------------------------------------------------------------------------
// The rays of the oracle and VTK's rasterizer see the same surface at all pixels but those that an
// edge cuts: its colour tells which actor a pixel shows.
SHADOW_TEST(Harness, OracleSeesThePicture, Once)
{
  ShadowStage stage(200, 120);
  vtkActor* box = stage.AddThings();
  stage.Render();
  const Picture with = stage.GetPicture();
  const ShadowOracle oracle(stage);
  box->VisibilityOff();
  stage.Render();
  const Picture without = stage.GetPicture();
  const auto mask = oracle.GetMask(box);
  std::size_t boxPixels = 0;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    boxPixels += mask[i];
    wrong += (with.Difference(without, i) > 0) != (mask[i] != 0);
  }
  ShadowTest::CheckAtLeast(static_cast<double>(boxPixels), 500.0, "pixels of the box");
  // Centres of pixels lie on an edge by rounding alone.
  ShadowTest::CheckAtMost(static_cast<double>(wrong), 2.0, "pixels that differ");
}
