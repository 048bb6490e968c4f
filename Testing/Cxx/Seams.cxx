// SPDX-License-Identifier: BSD-3-Clause
// Where techniques of another kind than those that there are join: each of these is one, made here in a
// few lines.

#include "SeamPass.h"
#include "ShadowOracle.h"
#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterDrawing.h"
#include "vtkShadowCasters.h"
#include "vtkShadowChanges.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowPass.h"
#include "vtkShadowTechnique.h"
#include "vtkShadowTechniques.h"
#include "vtkVisibilityBuffer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace
{
using ShadowTest::Message;

/**
 * Light data from receivers, for each camera: a hard map of each directional light, through a window that
 * hugs what the picture shows.
 */
class FittedMap : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override
  {
    this->Changes.Update(frame, frame.VCToSWC != this->VCToSWC || !this->Maps.GetHandle());
    this->VCToSWC = frame.VCToSWC;
    frame.Counts["fittedMaps"] = 0;
    if (!this->Changes.IsAny())
    {
      return true;
    }
    const auto& receivers = frame.Receivers->Read(frame.Window);
    const int layers = static_cast<int>(frame.Parts.size());
    if (!this->Maps.Allocate(frame.Window, vtkShadowTexture::Format::Depth, Side, Side, layers))
    {
      return false;
    }
    this->Maps.SetSampling(frame.Window, vtkShadowTexture::Sampling::CompareNearest);
    this->VCToLC.clear();
    vtkOpenGLState* state = frame.Window->GetState();
    vtkOpenGLState::ScopedglDepthMask depthMask(state);
    vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglDepthFunc(GL_LESS);
    state->vtkglEnable(GL_DEPTH_TEST);
    vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, nullptr, &this->Maps, 0);
    for (int i = 0; i < layers; ++i)
    {
      const glm::dmat4 SWCToClip = this->Fit(frame, i, receivers);
      this->VCToLC.emplace_back(glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)) *
                                glm::scale(glm::dmat4(1.0), glm::dvec3(0.5)) * SWCToClip *
                                frame.VCToSWC);
      target.SetLayer(i);
      const float farthest = 1.0f;
      glClearBufferfv(GL_DEPTH, 0, &farthest);
      std::vector<int> casters(frame.Casters->Get().size());
      for (std::size_t k = 0; k < casters.size(); ++k)
      {
        casters[k] = static_cast<int>(k);
      }
      frame.Drawing->Draw(frame.Window, SWCToClip, casters);
      frame.Counts["fittedMaps"] += 1;
    }
    return true;
  }

  std::string GetVisibilityGLSL() override
  {
    return "uniform sampler2DArrayShadow testMaps;\n"
           "uniform mat4 testVCToLC[SHADOW_LIGHTS];\n"
           "SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)\n"
           "{\n"
           "  vec3 p = (testVCToLC[light] * vec4(positionVC, 1.0)).xyz;\n"
           "  return SHADOW_VISIBILITY(texture(testMaps, vec4(p.xy, light, p.z - 0.01)));\n"
           "}\n";
  }
  void Activate(vtkShadowFrame& frame) override { this->Maps.Activate(frame.Window); }
  void Deactivate(vtkShadowFrame& frame) override { this->Maps.Deactivate(frame.Window); }
  void SetVisibilityParameters(vtkShaderProgram* program) override
  {
    program->SetUniformi("testMaps", this->Maps.GetUnit());
    for (std::size_t i = 0; i < this->VCToLC.size(); ++i)
    {
      program->SetUniformMatrix4x4(
        ("testVCToLC[" + std::to_string(i) + "]").c_str(), glm::value_ptr(this->VCToLC[i]));
    }
  }
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override
  {
    return { { "fitted", this->Maps.GetBytes() } };
  }
  void Release(vtkOpenGLRenderWindow* window) override
  {
    this->Maps.Release(window);
    this->Framebuffer.Release(window);
    this->Changes.Reset();
  }

private:
  static constexpr int Side = 512;

  /** An orthographic view along the light: as wide as the receivers, as deep as casters too. */
  static glm::dmat4 Fit(
    const vtkShadowFrame& frame, int part, const std::vector<glm::vec4>& receivers)
  {
    const glm::dvec3 along = frame.Parts[part].Light.Direction;
    const glm::dvec3 x = vtkShadowLight::Perpendicular(along);
    const glm::dmat4 turn(
      glm::transpose(glm::dmat3(x, glm::cross(along, x), along))); // depth rises along the light
    glm::dvec3 low(1e30);
    glm::dvec3 high(-1e30);
    for (const auto& texel : receivers)
    {
      if (vtkShadowReceiver::IsOne(texel))
      {
        const glm::dvec3 p(turn * frame.VCToSWC * glm::dvec4(glm::dvec3(texel), 1.0));
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    for (const auto& caster : frame.Casters->Get())
    {
      for (const auto& corner : caster.Corners)
      {
        const double depth = glm::dvec3(turn * glm::dvec4(corner, 1.0)).z;
        low.z = std::min(low.z, depth);
        high.z = std::max(high.z, depth);
      }
    }
    const glm::dvec3 size = glm::max(high - low, glm::dvec3(1e-6));
    return glm::scale(glm::dmat4(1.0), 2.0 / (1.02 * size)) *
           glm::translate(glm::dmat4(1.0), -0.5 * (low + high)) * turn;
  }

  vtkShadowChanges Changes;
  glm::dmat4 VCToSWC{ 0.0 };
  std::vector<glm::mat4> VCToLC;
  vtkShadowTexture Maps;
  vtkShadowFramebuffer Framebuffer;
};

/** Signed shares, by thirds of the picture: -0.75 twice; +0.5; -0.25. */
class Thirds : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  bool UpdateLightData(vtkShadowFrame&) override { return true; }
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override
  {
    vtkOpenGLState* state = frame.Window->GetState();
    vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    vtkShadowFramebuffer::Scope target(
      frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, 0);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    const int width = buffer.GetWidth() / 3;
    for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
    {
      target.SetLayer(i);
      for (const auto& [third, share] :
        { std::pair(0, -0.75f), { 0, -0.75f }, { 1, 0.5f }, { 2, -0.25f } })
      {
        target.SetRectangle(third * width, 0, width, buffer.GetHeight());
        frame.Quad->Draw(frame.Window,
          "//VTK::System::Dec\n//VTK::Output::Dec\nuniform float testShare;\n"
          "void main() { gl_FragData[0] = vec4(vec3(testShare), 0.0); }\n",
          [share = share](vtkShaderProgram* program) { program->SetUniformf("testShare", share); });
      }
    }
  }
  void Release(vtkOpenGLRenderWindow*) override {}
};

/** Two techniques in one frame: visibility is 1 less how far theirs differ. */
class Comparison : public vtkShadowTechnique
{
public:
  explicit Comparison(const vtkShadowSettings& settings)
    : vtkShadowTechnique(settings)
  {
    for (const char* name : { "map-hard", "volume-hard" })
    {
      const vtkShadowDeclaration* declaration = vtkShadowTechniqueRegistration::Find(name);
      this->Others.push_back({});
      this->Others.back().Settings = std::make_unique<vtkShadowSettings>(*declaration);
      this->Others.back().Technique = declaration->Make(*this->Others.back().Settings);
      this->Others.back().Buffer = std::make_unique<vtkVisibilityBuffer>();
    }
  }
  bool UpdateLightData(vtkShadowFrame& frame) override
  {
    return std::all_of(this->Others.begin(), this->Others.end(),
      [&frame](const Other& other) { return other.Technique->UpdateLightData(frame); });
  }
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override
  {
    for (const Other& other : this->Others)
    {
      other.Buffer->Allocate(
        frame.Window, buffer.GetReceivers(), static_cast<int>(frame.Parts.size()), frame.Color);
      other.Technique->Evaluate(frame, *other.Buffer);
    }
    vtkShadowTexture& first = this->Others[0].Buffer->GetTarget();
    vtkShadowTexture& second = this->Others[1].Buffer->GetTarget();
    first.Activate(frame.Window);
    second.Activate(frame.Window);
    vtkOpenGLState* state = frame.Window->GetState();
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    vtkShadowFramebuffer::Scope target(
      frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, 0);
    frame.Quad->Draw(frame.Window,
      "//VTK::System::Dec\n//VTK::Output::Dec\n"
      "uniform sampler2DArray testFirst;\nuniform sampler2DArray testSecond;\n"
      "void main() {\n  ivec3 p = ivec3(gl_FragCoord.xy, 0);\n"
      "  gl_FragData[0] = 1.0 - abs(texelFetch(testFirst, p, 0) - texelFetch(testSecond, p, 0));\n"
      "}\n",
      [&](vtkShaderProgram* program)
      {
        program->SetUniformi("testFirst", first.GetUnit());
        program->SetUniformi("testSecond", second.GetUnit());
      });
    first.Deactivate(frame.Window);
    second.Deactivate(frame.Window);
  }
  void Release(vtkOpenGLRenderWindow* window) override
  {
    for (const Other& other : this->Others)
    {
      other.Technique->Release(window);
      other.Buffer->Release(window);
    }
  }

private:
  struct Other
  {
    std::unique_ptr<vtkShadowSettings> Settings;
    std::unique_ptr<vtkShadowTechnique> Technique;
    std::unique_ptr<vtkVisibilityBuffer> Buffer;
  };
  std::vector<Other> Others;
};

/** Throws where it is asked for GLSL. */
class FailingForward : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;
  bool UpdateLightData(vtkShadowFrame&) override { return true; }
  std::string GetVisibilityGLSL() override
  {
    throw std::runtime_error("the technique's own reason");
  }
  void Release(vtkOpenGLRenderWindow*) override {}
};

/** Throws where it is asked for visibility. */
class Failing : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;
  bool UpdateLightData(vtkShadowFrame&) override { return true; }
  void FillVisibility(vtkShadowFrame&, vtkVisibilityBuffer&) override
  {
    throw std::runtime_error("the technique's own reason");
  }
  void Release(vtkOpenGLRenderWindow*) override {}
};

}

//------------------------------------------------------------------------------
// Light data from the receivers of the picture, made anew for each camera and kept for the same one.
SHADOW_TEST(Seams, LightDataFromReceivers, Once)
{
  ShadowStage stage;
  stage.AddThings();
  vtkAreaLight* light = stage.AddLight(LightKind::Directional);
  ShadowStage::Shrink(light);
  vtkShadowTraits traits;
  traits.Hard = traits.NeedsReceivers = traits.CameraDependent = true;
  vtkShadowPass* pass = SetPass<FittedMap>(stage, "test-fitted", traits);
  const std::pair<glm::dvec3, glm::dvec3> cameras[] = { { { 4.0, -5.0, 6.0 }, { 0.0, 0.2, 0.3 } },
    { { 1.0, -2.5, 1.5 }, { -0.8, 0.3, 0.3 } } };
  for (const auto& camera : cameras)
  {
    stage.LookAt(camera.first, camera.second);
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("fittedMaps"), 1.0, "maps for a camera");
    const Visibility visibility = stage.GetVisibility();
    const ShadowOracle oracle(stage);
    ShadowTest::CheckAtMost(
      Compare(visibility, oracle.GetHard(light), 0.5, oracle.GetInner(2)).Share, 0.03,
      "pixels other than the truth");
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("fittedMaps"), 0.0, "maps for the same camera");
    ShadowTest::Check(Same(stage.GetVisibility(), visibility), "the kept map shows another V");
  }
  // What it cannot do is said.
  ShadowTest::Check(pass->SetParameter("evaluation", "forward"), "forward is no value");
  stage.Render();
  ShadowTest::CheckOneMessage(Message::Warning, { "forward", "screen space" }, "forward");
}

//------------------------------------------------------------------------------
// Sums of signed shares end within 0 and 1, the same for the picture, a debug view and whoever reads.
SHADOW_TEST(Seams, SignedShares, Once)
{
  ShadowStage stage(150, 150);
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  vtkShadowTraits traits;
  traits.SignedShares = true;
  vtkShadowPass* pass = SetPass<Thirds>(stage, "test-thirds", traits);
  stage.Render();
  const Visibility visibility = stage.GetVisibility();
  const Picture picture = stage.GetPicture();
  pass->SetDebugView("visibility");
  stage.Render();
  const Picture view = stage.GetPicture();
  stage.Renderer->SetPass(nullptr);
  stage.Render();
  const Picture plain = stage.GetPicture();
  const float expected[] = { 0.0f, 1.0f, 0.75f };
  int lit = 0;
  int wrong = 0;
  int unlikeView = 0;
  int unlikePicture = 0;
  for (int i = 0; i < 150 * 150; ++i)
  {
    const float third = expected[i % 150 / 50];
    if (visibility.Mask[i] == 0)
    {
      continue;
    }
    // A surface that turns away from the light sees none of it, whatever the shares say.
    const bool away = visibility.V[i] == 0.0f && third != 0.0f;
    lit += away ? 0 : 1;
    wrong += !away && visibility.V[i] != third ? 1 : 0;
    unlikeView += std::abs(view.RGB[3 * i] - 255.0 * visibility.V[i]) > 1.0 ? 1 : 0;
    unlikePicture +=
      !away && third == 1.0f && picture.Difference(plain, static_cast<std::size_t>(i)) > 1 ? 1 : 0;
  }
  ShadowTest::CheckAtLeast(lit, 10000.0, "receivers that face the light");
  ShadowTest::CheckEqual(wrong, 0.0, "pixels of another V than the sum within its bounds");
  ShadowTest::CheckEqual(unlikeView, 0.0, "pixels that the debug view shows otherwise");
  ShadowTest::CheckEqual(unlikePicture, 0.0, "lit pixels that are not lit in the picture");
}

//------------------------------------------------------------------------------
// Two techniques at once, one of them by signed shares.
SHADOW_TEST(Seams, TwoInOneFrame, Once)
{
  if (!vtkShadowTechniqueRegistration::Find("map-hard") ||
      !vtkShadowTechniqueRegistration::Find("volume-hard"))
  {
    return;
  }
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  vtkShadowTraits traits;
  traits.Hard = true;
  SetPass<Comparison>(stage, "test-comparison", traits);
  stage.Render();
  const Visibility same = stage.GetVisibility();
  int differ = 0;
  int receivers = 0;
  for (std::size_t i = 0; i < same.V.size(); ++i)
  {
    receivers += same.Mask[i] != 0 ? 1 : 0;
    differ += same.Mask[i] != 0 && same.V[i] < 0.5f ? 1 : 0;
  }
  ShadowTest::CheckAtLeast(differ, 1.0, "pixels in which maps and volumes differ");
  ShadowTest::CheckAtMost(differ, 0.02 * receivers, "pixels in which maps and volumes differ");
}

//------------------------------------------------------------------------------
// What a technique throws does not leave the pass: one error with its text, and a picture.
SHADOW_TEST(Seams, Exceptions, Once)
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  stage.Render();
  const Picture plain = stage.GetPicture();
  vtkShadowTraits forward;
  forward.Forward = true;
  for (int frame = 0; frame < 4; ++frame)
  {
    if (frame == 0)
    {
      SetPass<Failing>(stage, "test-failing", {});
    }
    else if (frame == 2)
    {
      SetPass<FailingForward>(stage, "test-failing-forward", forward);
    }
    stage.Render();
    if (frame % 2 == 0)
    {
      ShadowTest::CheckOneMessage(
        Message::Error, { "the technique's own reason" }, "what it threw");
    }
    ShadowTest::CheckNoMessage("after it");
    ShadowTest::Check(Same(stage.GetPicture(), plain), "the picture is not that without shadows");
  }
}
