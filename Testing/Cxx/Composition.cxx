// SPDX-License-Identifier: BSD-3-Clause
// The pass within VTK's other passes and around them, and with the renderer's own features.
//
// Every test holds the picture to the same law (CheckShadowed): where V is 1 it is what VTK draws in
// this way without shadows, where V is 0 what it draws so with the light all but out.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkDepthOfFieldPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkEDLShading.h"
#include "vtkGaussianBlurPass.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkOverlayPass.h"
#include "vtkProperty.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkToneMappingPass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

#include <set>

namespace
{
/** An effect on the picture: a pass that has a delegate. */
struct Effect
{
  const char* Name;
  int Reach;       // pixels by which it mixes colours
  bool InViewport; // VTK 9.1 puts others into the window's corner
  std::function<vtkSmartPointer<vtkRenderPass>(vtkRenderPass*)> Around;
};

template <typename Pass>
vtkSmartPointer<vtkRenderPass> Make(vtkRenderPass* delegate)
{
  vtkNew<Pass> pass;
  pass->SetDelegatePass(delegate);
  return pass.Get();
}

const std::vector<Effect>& GetEffects()
{
  static const std::vector<Effect> effects = {
    { "SSAO", 0, false,
      [](vtkRenderPass* delegate)
      {
        vtkNew<vtkSSAOPass> pass;
        pass->SetDelegatePass(delegate);
        pass->SetRadius(0.5);
        pass->SetBias(0.01);
        pass->SetKernelSize(16);
        pass->BlurOn();
        return vtkSmartPointer<vtkRenderPass>(pass);
      } },
    { "FXAA", 3, true, Make<vtkOpenGLFXAAPass> },
    { "tone mapping", 0, true, Make<vtkToneMappingPass> },
    { "EDL", 0, true, Make<vtkEDLShading> },
    { "depth of field", 4, false, Make<vtkDepthOfFieldPass> },
    { "blur", 2, false, Make<vtkGaussianBlurPass> },
    { "SSAA", 2, false, Make<vtkSSAAPass> },
  };
  return effects;
}

/** What makes umbrae quite dark where it is not the rule. */
const Parameters Dark = { { "combine", "bits" }, { "double-projection", "on" } };

/** A light whose shadow has an umbra that effects do not reach across. */
class ComposedStage : public ShadowStage
{
public:
  /** The renderer's viewport begins at a margin of the window. */
  explicit ComposedStage(
    const std::string& technique, int width = 160, int height = 160, int margin = 0)
    : ShadowStage(width + margin, height + margin)
  {
    this->Renderer->SetViewport(
      margin / double(width + margin), margin / double(height + margin), 1.0, 1.0);
    this->AddThings();
    this->Light = this->AddLight(
      ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point);
    ShadowStage::Shrink(this->Light, 0.3);
  }
  /** The picture of this pass, or of none. */
  Picture Draw(vtkRenderPass* pass)
  {
    this->Renderer->SetPass(pass);
    this->Render();
    int size[2];
    int origin[2];
    this->Renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
    return Crop(this->GetPicture(), origin[0], origin[1], size[0], size[1]);
  }
  /** Of this pass, with the light all but out; one that is quite out would change VTK's shading. */
  Picture DrawOut(vtkRenderPass* pass)
  {
    this->Light->SetIntensity(1e-6);
    const Picture picture = this->Draw(pass);
    this->Light->SetIntensity(1.0);
    return picture;
  }
  /** Where `reach` pixels see one surface, and it is lit or dark. */
  std::vector<Region> GetRegions(int reach, int edges)
  {
    return ::GetRegions(this->GetVisibility(), reach, ShadowOracle(*this).GetInner(edges));
  }

  vtkAreaLight* Light;
};

/**
 * What VTK and the driver say without shadows too (peeling of several samples is an error in some
 * drivers, some of VTK's shaders get warnings) is not held against the pass.
 */
class Quiet
{
public:
  void TakeOwn()
  {
    for (const auto& message : ShadowTest::TakeMessages())
    {
      this->Own.insert(message.Text);
    }
  }
  void Check(const std::string& what) const
  {
    for (const auto& message : ShadowTest::TakeMessages())
    {
      ShadowTest::Check(this->Own.count(message.Text) > 0, what + " says: " + message.Text);
    }
  }

private:
  std::set<std::string> Own;
};

/** What vtkRenderStepsPass does, with a pass for what is translucent. */
vtkSmartPointer<vtkRenderPass> MakeSteps(vtkRenderPass* translucent)
{
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(translucent);
  passes->AddItem(vtkNew<vtkVolumetricPass>());
  passes->AddItem(vtkNew<vtkOverlayPass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  return sequence.Get();
}

template <typename Pass>
vtkSmartPointer<vtkRenderPass> MakePeeling()
{
  vtkNew<Pass> peeling;
  peeling->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
  peeling->SetMaximumNumberOfPeels(8);
  return peeling.Get();
}

void CheckEffect(const std::string& technique, const Effect& effect, int width = 160,
  int height = 160, int margin = 0)
{
  ComposedStage stage(technique, width, height, margin);
  stage.Renderer->GetActiveCamera()->SetFocalDisk(4.0); // of the depth of field
  vtkNew<vtkRenderStepsPass> steps;
  stage.SetPass(technique, Dark);
  stage.Render();
  // Edges of what is in front may show a shadow behind them, in effects with several samples.
  const auto regions = stage.GetRegions(effect.Reach, effect.Reach + 1);
  const std::string what = effect.Name;

  const Picture sharp = stage.Draw(nullptr);
  const auto alone = effect.Around(steps);
  const Picture plain = stage.Draw(alone);
  const Picture out = stage.DrawOut(alone);
  alone->ReleaseGraphicsResources(stage.Window);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    changed += plain.Difference(sharp, i) > 2;
  }
  ShadowTest::CheckAtLeast(static_cast<double>(changed), 100.0, what + " changes pixels");
  Quiet quiet;
  quiet.TakeOwn();

  // Twice each: what the first frame leaves behind must not spoil the second.
  const auto within = effect.Around(steps);
  stage.Pass->SetDelegatePass(within);
  CheckShadowed(stage.Draw(stage.Pass), plain, out, regions, 3000.0, 400.0, what + " within");
  CheckShadowed(
    stage.Draw(stage.Pass), plain, out, regions, 3000.0, 400.0, what + " within, again");
  quiet.Check(what + " within");
  within->ReleaseGraphicsResources(stage.Window);

  for (vtkRenderPass* delegate : std::vector<vtkRenderPass*>{ nullptr, steps })
  {
    const std::string how = what + (delegate ? " around, with steps" : " around");
    stage.Pass->SetDelegatePass(delegate);
    const auto around = effect.Around(stage.Pass);
    stage.Draw(around);
    CheckShadowed(stage.Draw(around), plain, out, regions, 3000.0, 400.0, how);
    quiet.Check(how);
    // When the outer pass is taken off, the next frame tells.
    stage.Draw(nullptr);
    ShadowTest::CheckEqual(
      static_cast<double>(stage.GetBytes()), 0.0, how + ", bytes after the next frame");
    around->ReleaseGraphicsResources(stage.Window);
  }
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(Composition, AmbientOcclusion, Each)
{
  CheckEffect(technique, GetEffects()[0]);
}

//------------------------------------------------------------------------------
SHADOW_TEST(Composition, FXAA, Each)
{
  CheckEffect(technique, GetEffects()[1]);
}

//------------------------------------------------------------------------------
SHADOW_TEST(Composition, ToneMapping, Each)
{
  CheckEffect(technique, GetEffects()[2]);
}

//------------------------------------------------------------------------------
SHADOW_TEST(Composition, EyeDomeLighting, Each)
{
  CheckEffect(technique, GetEffects()[3]);
}

//------------------------------------------------------------------------------
SHADOW_TEST(Composition, DepthOfField, Each)
{
  CheckEffect(technique, GetEffects()[4]);
}

//------------------------------------------------------------------------------
SHADOW_TEST(Composition, Blur, Each)
{
  CheckEffect(technique, GetEffects()[5]);
}

//------------------------------------------------------------------------------
SHADOW_TEST(Composition, ManySamples, Each)
{
  CheckEffect(technique, GetEffects()[6]);
  CheckEffect(technique, GetEffects()[6], 190, 130);
}

//------------------------------------------------------------------------------
SHADOW_TEST(Composition, WithinAViewport, Each)
{
  for (const Effect& effect : GetEffects())
  {
    if (effect.InViewport)
    {
      CheckEffect(technique, effect, 160, 160, 40);
    }
  }
}

//------------------------------------------------------------------------------
// Peeling as a step of the delegate, which has a camera's pass within or around the shadows' pass:
// the translucent boxes lie over what is shadowed.
SHADOW_TEST(Composition, PeelingAsAStep, Each)
{
  for (const bool dual : { true, false })
  {
    const std::string what = dual ? "dual peeling" : "peeling";
    ComposedStage stage(technique);
    vtkActor* box = stage.AddBox({ 1.5, 1.5, 0.5 }, { 0.5, 0.5, 1.0 });
    stage.AddBox({ 1.6, 1.3, 0.6 }, { 0.5, 0.5, 0.5 })->GetProperty()->SetOpacity(0.6);
    box->GetProperty()->SetOpacity(0.4);
    vtkPropCollection* props = stage.Renderer->GetViewProps();
    auto* second = vtkActor::SafeDownCast(props->GetLastProp());
    vtkShadowPass::SetReceiving(box, false);
    vtkShadowPass::SetReceiving(second, false);
    const auto makeSteps = [&]
    {
      return MakeSteps(
        dual ? MakePeeling<vtkDualDepthPeelingPass>() : MakePeeling<vtkDepthPeelingPass>());
    };
    const auto alone = Make<vtkCameraPass>(makeSteps());
    const Picture plain = stage.Draw(alone);
    const Picture out = stage.DrawOut(alone);
    ShadowTest::CheckNoMessage(what + " without shadows");

    // Of the opaque surfaces alone: what is translucent shows them through itself.
    stage.SetPass(technique, Dark);
    stage.Render();
    const ShadowOracle oracle(stage, { box, second });
    auto use = oracle.GetInner(0);
    std::vector<unsigned char> covered;
    for (std::size_t i = 0; i < use.size(); ++i)
    {
      covered.push_back(
        oracle.GetPixels()[i].Actor == box || oracle.GetPixels()[i].Actor == second);
    }
    const auto inner = oracle.GetInner(1);
    for (std::size_t i = 0; i < use.size(); ++i)
    {
      use[i] = inner[i] && !covered[i];
    }
    const auto regions = GetRegions(stage.GetVisibility(), 0, use);

    Picture first;
    for (const int how : { 0, 1 })
    {
      const std::string name = what + (how == 0 ? " in the delegate" : ", camera around");
      const auto steps = makeSteps();
      const auto inCamera = Make<vtkCameraPass>(steps);
      stage.SetPass(technique, Dark)->SetDelegatePass(how == 0 ? inCamera : steps);
      const auto camera = Make<vtkCameraPass>(stage.Pass);
      const Picture picture = stage.Draw(how == 0 ? stage.Pass.Get() : camera.Get());
      ShadowTest::CheckNoMessage(name);
      CheckShadowed(picture, plain, out, regions, 5000.0, 1000.0, name);
      if (how == 0)
      {
        first = picture;
      }
      std::size_t differ = 0;
      std::size_t blended = 0;
      for (std::size_t i = 0; i < use.size(); ++i)
      {
        differ += picture.Difference(first, i) > 1;
        // No darker than with the light out, nor brighter than plain: of both, and of one surface
        // before another.
        for (int c = 0; covered[i] && inner[i] && c < 3; ++c)
        {
          blended += picture.RGB[3 * i + c] + 1 < out.RGB[3 * i + c] ||
                     picture.RGB[3 * i + c] > plain.RGB[3 * i + c] + 1;
        }
      }
      ShadowTest::CheckEqual(static_cast<double>(differ), 0.0, name + ", pixels that differ");
      ShadowTest::CheckEqual(
        static_cast<double>(blended), 0.0, name + ", outside of both pictures");
      stage.Renderer->SetPass(nullptr);
      camera->ReleaseGraphicsResources(stage.Window);
    }
    alone->ReleaseGraphicsResources(stage.Window);
  }
}

//------------------------------------------------------------------------------
// The renderer's own features, alone and together, with several samples a pixel or one, in a window
// that is seen or not. See also Control.RendererFeatures.
SHADOW_TEST(Composition, RendererFeatures, Each)
{
  struct Feature
  {
    const char* Name;
    bool SSAO, FXAA, Peeling, Parallel, Shown;
    int Samples;
  };
  const Feature features[] = {
    { "SSAO", true, false, false, false, false, 0 },
    { "SSAO, 4 samples", true, false, false, false, false, 4 },
    { "SSAO, FXAA and peeling, parallel", true, true, true, true, false, 0 },
    { "peeling, 4 samples", false, false, true, false, false, 4 },
    { "FXAA, 8 samples, parallel", false, true, false, true, false, 8 },
    { "shown", false, false, false, false, true, 0 },
    { "shown, 4 samples", false, false, false, false, true, 4 },
  };
  for (const Feature& feature : features)
  {
    ComposedStage stage(technique, 170, 140);
    stage.Window->SetOffScreenRendering(feature.Shown ? 0 : 1);
    stage.Window->SetMultiSamples(feature.Samples);
    stage.Renderer->SetUseSSAO(feature.SSAO);
    stage.Renderer->SetSSAORadius(0.5);
    stage.Renderer->SetSSAOBias(0.01);
    stage.Renderer->SetSSAOKernelSize(16);
    stage.Renderer->SetSSAOBlur(true);
    stage.Renderer->SetUseFXAA(feature.FXAA);
    stage.Renderer->SetUseDepthPeeling(feature.Peeling);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    camera->SetParallelProjection(feature.Parallel);
    camera->SetParallelScale(2.5);
    vtkActor* box = stage.AddBox({ 1.5, 1.5, 0.5 }, { 0.5, 0.5, 1.0 });
    box->GetProperty()->SetOpacity(0.4);
    box->SetVisibility(feature.Peeling);
    vtkShadowPass::SetReceiving(box, false);
    const Picture plain = stage.Draw(nullptr);
    const Picture out = stage.DrawOut(nullptr);
    Quiet quiet;
    quiet.TakeOwn();
    stage.SetPass(technique, Dark);
    const Picture picture = stage.Draw(stage.Pass);
    quiet.Check(feature.Name);
    const ShadowOracle oracle(stage, { box });
    auto use = oracle.GetInner(4);
    const auto covered = oracle.GetMask(box);
    for (std::size_t i = 0; i < use.size(); ++i)
    {
      use[i] = use[i] && !covered[i];
    }
    CheckShadowed(
      picture, plain, out, GetRegions(stage.GetVisibility(), 3, use), 3000.0, 300.0, feature.Name);
    ShadowTest::Check(Same(stage.Draw(stage.Pass), picture),
      std::string(feature.Name) + ": the second frame differs");
    quiet.Check(std::string(feature.Name) + ", at the end");
  }
}
