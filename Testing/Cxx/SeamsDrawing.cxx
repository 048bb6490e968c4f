// SPDX-License-Identifier: BSD-3-Clause
// What techniques to come draw with: several targets and formats, tiles of an atlas, vertices of their own,
// receivers that are chosen or reduced on the GPU.

#include "SeamPass.h"
#include "ShadowTest.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowSelection.h"
#include "vtkShadowTechnique.h"
#include "vtkShadowTiles.h"
#include "vtkShadowVertices.h"
#include "vtkVisibilityBuffer.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace
{
/**
 * Light data in two targets at once, one of them of integers, drawn from vertices of its own into a tile of
 * an atlas; and receivers that are chosen on the GPU, of those to the right of the picture's middle.
 */
class Tiles : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override
  {
    using Format = vtkShadowTexture::Format;
    if (!this->Colors.Allocate(frame.Window, Format::Byte4, 64, 64, 1) ||
        !this->Numbers.Allocate(frame.Window, Format::Integer1, 64, 64, 1))
    {
      return false;
    }
    // A place and a value each: a square over all that is drawn into.
    this->Vertices.Upload({ -1, -1, 0.25f, 1, -1, 0.25f, -1, 1, 0.25f, 1, 1, 0.25f },
      { { "testPlace", 2 }, { "testValue", 1 } });
    vtkOpenGLState* state = frame.Window->GetState();
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    vtkShadowFramebuffer::Scope target(
      frame.Window, this->Framebuffer, { &this->Colors, &this->Numbers }, nullptr, 0);
    state->vtkglDisable(GL_DEPTH_TEST);
    const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
    const GLuint zero[] = { 0, 0, 0, 0 };
    glClearBufferfv(GL_COLOR, 0, none);
    glClearBufferuiv(GL_COLOR, 1, zero);
    target.SetRectangle(32, 0, 32, 64);
    const vtkShadowPrograms::Sources sources{ VertexShader, nullptr, FragmentShader, "", false };
    this->Vertices.Draw(
      frame.Window, GL_TRIANGLE_STRIP, 0, this->Vertices.GetCount(), sources, nullptr);
    this->Selection.Start(frame, *frame.Receivers,
      "bool shadowSelect(vec4 receiverVC) { return receiverVC.x > 0.0; }\n");
    const auto& texels = frame.Receivers->Read(frame.Window);
    std::size_t wanted = 0;
    std::size_t wrong = 0;
    const auto& chosen = this->Selection.Finish();
    for (std::size_t i = 0; i < texels.size(); ++i)
    {
      if (vtkShadowReceiver::IsOne(texels[i]) && texels[i].x > 0.0f)
      {
        const bool same = wanted < chosen.size() && chosen[wanted].Number == static_cast<int>(i) &&
                          chosen[wanted].Receiver == texels[i];
        wrong += same ? 0 : 1;
        ++wanted;
      }
    }
    frame.Counts["wanted"] = static_cast<double>(wanted);
    frame.Counts["chosen"] = static_cast<double>(chosen.size());
    frame.Counts["chosenWrongly"] = static_cast<double>(wrong);
    frame.Counts["boxesWrong"] = this->CountWrongBoxes(frame, texels);
    return true;
  }
  std::string GetVisibilityGLSL() override
  {
    return "uniform sampler2DArray testColors;\nuniform usampler2DArray testNumbers;\n"
           "SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)\n{\n"
           "  float tile = texelFetch(testColors, ivec3(48, 10, 0), 0).r;\n"
           "  float beside = texelFetch(testColors, ivec3(10, 10, 0), 0).r;\n"
           "  uint number = texelFetch(testNumbers, ivec3(48, 10, 0), 0).r;\n"
           "  return SHADOW_VISIBILITY(tile + beside + (number == 4000000007u ? 0.5 : 0.0));\n}\n";
  }
  void Activate(vtkShadowFrame& frame) override
  {
    this->Colors.Activate(frame.Window);
    this->Numbers.Activate(frame.Window);
  }
  void Deactivate(vtkShadowFrame& frame) override
  {
    this->Colors.Deactivate(frame.Window);
    this->Numbers.Deactivate(frame.Window);
  }
  void SetVisibilityParameters(vtkShaderProgram* program) override
  {
    program->SetUniformi("testColors", this->Colors.GetUnit());
    program->SetUniformi("testNumbers", this->Numbers.GetUnit());
  }
  void Release(vtkOpenGLRenderWindow* window) override
  {
    this->Colors.Release(window);
    this->Numbers.Release(window);
    this->Framebuffer.Release(window);
    this->Vertices.Release();
    this->Selection.Release();
    this->Boxes.Release(window);
  }

private:
  /** Boxes of the receivers by tiles, against those that the CPU finds. */
  double CountWrongBoxes(vtkShadowFrame& frame, const std::vector<glm::vec4>& texels)
  {
    constexpr int side = vtkShadowTiles::Side;
    this->Boxes.Update(frame, *frame.Receivers);
    const int width = this->Boxes.GetWidth();
    std::vector<glm::vec4> low(static_cast<std::size_t>(width) * this->Boxes.GetHeight());
    std::vector<glm::vec4> high(low.size());
    auto& framebuffer = this->Boxes.GetFramebuffer();
    framebuffer.Read(frame.Window, this->Boxes.GetLow(), 0, &low[0].x);
    framebuffer.Read(frame.Window, this->Boxes.GetHigh(), 0, &high[0].x);
    std::vector<glm::vec4> least(low.size(), glm::vec4(3.0e38f, 3.0e38f, 3.0e38f, 0.0f));
    std::vector<glm::vec4> most(low.size(), glm::vec4(-3.0e38f, -3.0e38f, -3.0e38f, 0.0f));
    const int across = frame.Receivers->GetWidth();
    for (std::size_t i = 0; i < texels.size(); ++i)
    {
      if (vtkShadowReceiver::IsOne(texels[i]))
      {
        const int pixel = static_cast<int>(i);
        const std::size_t tile =
          static_cast<std::size_t>(pixel / across / side * width + pixel % across / side);
        const float count = least[tile].w + 1.0f;
        least[tile] = glm::vec4(glm::min(glm::vec3(least[tile]), glm::vec3(texels[i])), count);
        most[tile] = glm::vec4(glm::max(glm::vec3(most[tile]), glm::vec3(texels[i])), count);
      }
    }
    double wrong = 0.0;
    for (std::size_t i = 0; i < low.size(); ++i)
    {
      wrong += low[i] == least[i] && high[i] == most[i] ? 0.0 : 1.0;
    }
    return wrong;
  }

  static constexpr const char* VertexShader =
    "//VTK::System::Dec\nin vec2 testPlace;\nin float testValue;\nout float testValueVSOutput;\n"
    "void main()\n{\n  testValueVSOutput = testValue;\n"
    "  gl_Position = vec4(testPlace, 0.0, 1.0);\n}\n";
  static constexpr const char* FragmentShader =
    "//VTK::System::Dec\n#extension GL_ARB_explicit_attrib_location : require\n"
    "in float testValueVSOutput;\n"
    "layout(location = 0) out vec4 testColor;\nlayout(location = 1) out uint testNumber;\n"
    "void main()\n{\n  testColor = vec4(testValueVSOutput);\n  testNumber = 4000000007u;\n}\n";

  vtkShadowTexture Colors;
  vtkShadowTexture Numbers;
  vtkShadowFramebuffer Framebuffer;
  vtkShadowVertices Vertices;
  vtkShadowSelection Selection;
  vtkShadowTiles Boxes;
};
}

//------------------------------------------------------------------------------
// What light data can be drawn into, and with; and that what is chosen on the GPU is what was meant.
SHADOW_TEST(Seams, TargetsAndSelection, Once)
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  vtkShadowTraits traits;
  traits.NeedsReceivers = true;
  SetPass<Tiles>(stage, "test-tiles", traits);
  for (int frame = 0; frame < 2; ++frame)
  {
    stage.Render();
    ShadowTest::CheckAtLeast(stage.Count("wanted"), 5000.0, "receivers on the right");
    ShadowTest::CheckEqual(stage.Count("chosen"), stage.Count("wanted"), "receivers chosen");
    ShadowTest::CheckEqual(stage.Count("chosenWrongly"), 0.0, "of them others than meant");
    ShadowTest::CheckEqual(stage.Count("boxesWrong"), 0.0, "boxes of tiles other than meant");
    const Visibility visibility = stage.GetVisibility();
    int wrong = 0;
    int lit = 0;
    for (std::size_t i = 0; i < visibility.V.size(); ++i)
    {
      lit += visibility.Mask[i] != 0 && visibility.V[i] > 0.0f ? 1 : 0;
      // 0.25 in 8 bits; turned away from the light it is 0.
      wrong += visibility.Mask[i] != 0 && visibility.V[i] != 0.0f &&
                   std::abs(visibility.V[i] - (0.5f + 64.0f / 255.0f)) > 1e-6f
                 ? 1
                 : 0;
    }
    ShadowTest::CheckAtLeast(lit, 10000.0, "receivers that face the light");
    ShadowTest::CheckEqual(wrong, 0.0, "pixels of another V than the tile tells");
  }
  ShadowTest::CheckNoMessage("tiles");
}
