// SPDX-License-Identifier: BSD-3-Clause
// The viewer's window and its frames.

#include "Viewer.h"

#include "Errors.h"
#include "Inputs.h"
#include "OffscreenWindow.h"
#include "Outputs.h"
#include "References.h"
#include "ViewKeys.h"
#include "ViewSnapshot.h"

#include "vtkAreaLight.h"
#include "vtkInteractorEventRecorder.h"
#include "vtkVisibilityMetrics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace
{
using Clock = std::chrono::steady_clock;

double GetMilliseconds(Clock::time_point since)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
}
}

//------------------------------------------------------------------------------
Viewer::Viewer(const ViewOptions& options)
  : Options(options)
  , Left(std::make_unique<ViewModel>(options.Parameters, options.Technique))
  , LightsShown(options.Scene.ShowLights)
{
  options.Parameters.CheckSettings({ options.Technique });
  if (!options.DebugView.empty())
  {
    this->Left->SetDebugView(options.DebugView);
  }
  Messages::Check();
}

//------------------------------------------------------------------------------
Viewer::~Viewer() = default;

//------------------------------------------------------------------------------
void Viewer::Open()
{
  this->Window = vtkSmartPointer<vtkRenderWindow>::New();
  CheckDisplay(this->Window);
  this->Window->SetMultiSamples(this->Options.Scene.SamplesPerPixel);
  this->Window->SetSize(this->Options.Scene.Size[0], this->Options.Scene.Size[1]);
  this->Window->SetWindowName("softshadows");
  this->Blank->SetBackground(0.87, 0.88, 0.90);
  this->Window->AddRenderer(this->Blank);
  this->Overlay.PutOn(this->Window);
  this->Interactor = vtkSmartPointer<vtkRenderWindowInteractor>::New();
  this->Interactor->SetRenderWindow(this->Window);
  this->Interactor->SetInteractorStyle(nullptr); // what it would do, the table of keys says
  this->Overlay.SetHelp("Loading");
  this->Interactor->Initialize();
  this->Listen();
}

//------------------------------------------------------------------------------
void Viewer::Load()
{
  auto start = Clock::now();
  std::string before;
  const auto tell = [&]()
  {
    if (!before.empty())
    {
      std::printf("%s: %.0f ms\n", before.c_str(), GetMilliseconds(start));
    }
    start = Clock::now();
  };
  SceneOptions scene = this->Options.Scene;
  scene.Progress = [&](const std::string& what, std::size_t number, std::size_t count)
  {
    tell();
    before = "loaded " + Messages::GetPrintable(what);
    this->Overlay.SetHelp(
      "Loading " + what +
      (count > 1 ? " (" + std::to_string(number) + " of " + std::to_string(count) + ")" : ""));
    this->Window->Render();
  };
  this->Stage = std::make_unique<ViewStage>(scene);
  tell();
  this->Figures.Triangles = this->Stage->GetScene().Triangles;
  this->Overlay.SetHelp("");
  // Beneath comes first: where both fill the window the other is not seen.
  this->Window->RemoveRenderer(this->Blank);
  this->Window->AddRenderer(this->Stage->GetOther());
  this->Window->AddRenderer(this->Stage->GetRenderer());
  this->Stage->GetOther()->SetDraw(false);
}

//------------------------------------------------------------------------------
double Viewer::RenderWindow()
{
  const auto start = Clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  return GetMilliseconds(start);
}

//------------------------------------------------------------------------------
// At a whole pixel, so that both sides' pixels are those of one picture.
double Viewer::GetDivider() const
{
  const int width = std::max(this->Window->GetSize()[0], 2);
  return std::clamp(std::round(this->Divider * width), 1.0, width - 1.0) / width;
}

//------------------------------------------------------------------------------
std::string Viewer::GetStatus() const
{
  if (!this->Message.empty())
  {
    return this->Message;
  }
  if (this->IsSplit && this->TextShown)
  {
    return "right: " + this->Right->GetTechnique();
  }
  return this->TextShown && this->Averages.empty() ? "? shows all keys" : "";
}

//------------------------------------------------------------------------------
void Viewer::Draw()
{
  if (!this->Stage)
  {
    return;
  }
  const double divider = this->IsSplit ? this->GetDivider() : 1.0;
  this->Stage->ShowLights(this->LightsShown, Techniques::GetLightSamples(this->Left->GetPass()));
  this->Stage->Prepare(divider);
  this->Stage->GetRenderer()->SetPass(this->Left->GetPass());
  this->Stage->GetOther()->SetDraw(this->IsSplit);
  this->Stage->GetOther()->SetPass(this->IsSplit ? this->Right->GetPass() : nullptr);
  std::copy_n(this->Window->GetSize(), 2, this->Figures.Size);
  this->Overlay.SetDivider(this->IsSplit, divider);
  this->Overlay.SetInfo(this->TextShown ? ViewText::DescribeFrame(*this->Left, this->Figures) : "");
  this->Overlay.SetStatus(this->GetStatus());
  this->Overlay.SetHelp(this->HelpShown ? ViewKeys::GetHelp() : "");

  const double taken = this->RenderWindow();
  this->Figures.Milliseconds = taken;
  constexpr std::size_t few = 10;
  this->Recent.push_back(taken);
  if (this->Recent.size() > few)
  {
    this->Recent.erase(this->Recent.begin());
  }
  const double sum = std::accumulate(this->Recent.begin(), this->Recent.end(), 0.0);
  this->Figures.Rate = sum > 0.0 ? 1000.0 * static_cast<double>(this->Recent.size()) / sum : 0.0;
  Average& average = this->Averages[this->Left->GetTechnique()];
  ++average.Frames;
  average.Milliseconds += taken;
  vtkShadowPass* pass = this->Left->GetPass();
  this->Figures.Statistics =
    pass ? nlohmann::ordered_json::parse(pass->GetStatistics()) : nlohmann::ordered_json();
  this->Figures.Error = nullptr;
  this->Unsettled = true;
  if (pass && this->LightChanged)
  {
    this->LightData = this->Figures.Statistics["milliseconds"].value("light data", 0.0);
  }
  const std::string error = Messages::TakeError();
  if (!error.empty())
  {
    this->Say(error);
  }
  const double most = this->Options.LeastRate > 0.0 ? 1000.0 / this->Options.LeastRate : 0.0;
  if (this->Dragging != Drag::None && most > 0.0 && taken > most)
  {
    this->Left->Lower();
    if (this->IsSplit)
    {
      this->Right->Lower();
    }
  }
}

//------------------------------------------------------------------------------
// At rest: at full quality, with figures of a frame in which nothing moves.
void Viewer::Settle()
{
  if (!this->Stage || !this->Unsettled)
  {
    return;
  }
  const bool lowered = this->Left->Restore();
  const bool other = this->Right && this->Right->Restore();
  this->Recent.clear();
  if (lowered || other)
  {
    this->Draw(); // its light data anew
  }
  if (this->LightChanged && this->Left->GetPass())
  {
    std::printf("%s: light data in %.1f ms\n", this->Left->GetTechnique().c_str(), this->LightData);
    std::fflush(stdout);
  }
  this->LightChanged = false;
  this->Recent.clear();
  if (this->ErrorsShown && this->Left->GetPass())
  {
    this->DrawErrors();
  }
  else
  {
    this->Draw();
  }
  this->Unsettled = false;
}

//------------------------------------------------------------------------------
// The reference is drawn beneath, and what both see of the light is subtracted.
void Viewer::DrawErrors()
{
  vtkAreaLight* light = this->Stage->GetScene().Light;
  vtkShadowPass* pass = this->Left->GetPass();
  ViewModel reference(TechniqueOptions(), ReferenceTechnique);
  reference.SetValue("terminator", this->Left->GetValue("terminator"));
  this->Draw();
  this->Stage->GetOther()->SetDraw(true);
  this->Stage->GetOther()->SetPass(reference.GetPass());
  this->RenderWindow();
  vtkNew<vtkVisibilityMetrics> metrics;
  metrics->SetImage(References::GetVisibility(pass, light, nullptr));
  metrics->SetReference(References::GetVisibility(reference.GetPass(), light, nullptr));
  metrics->Update();
  const std::string estimate = pass->GetErrorEstimate(light);
  this->Stage->GetOther()->SetPass(nullptr);
  Messages::Check("no error can be shown");
  this->Figures.Error = nlohmann::ordered_json::parse(estimate);
  this->Overlay.SetPicture(metrics->GetDifferenceImage());
  this->Draw();
  this->Overlay.SetPicture(nullptr); // of the next frame no more
}

//------------------------------------------------------------------------------
void Viewer::PrintAverages() const
{
  for (const auto& [technique, average] : this->Averages)
  {
    std::printf("%s: %lld frames, %.1f a second, %.1f ms on average\n", technique.c_str(),
      average.Frames, 1000.0 * static_cast<double>(average.Frames) / average.Milliseconds,
      average.Milliseconds / static_cast<double>(average.Frames));
  }
}

//------------------------------------------------------------------------------
void Viewer::Play()
{
  vtkNew<vtkInteractorEventRecorder> recorder;
  recorder->SetInteractor(this->Interactor);
  recorder->SetFileName(this->Options.Play.c_str());
  recorder->Play();
  recorder->SetInteractor(nullptr);
  Messages::Check("\"" + this->Options.Play + "\"");
}

//------------------------------------------------------------------------------
void Viewer::Run()
{
  Outputs outputs({});
  if (!this->Options.Screenshot.empty())
  {
    outputs.PlanPicture(this->Options.Screenshot, 3);
  }
  if (!this->Options.Play.empty())
  {
    Inputs::Check(this->Options.Play);
  }
  this->Open();
  std::unique_ptr<Failure> failed;
  try
  {
    this->Load();
    vtkShadowPass* pass = this->Left->GetPass();
    if (pass && !pass->IsSupported(this->Window))
    {
      this->Say(this->Left->GetTechnique() + " cannot run here: " + pass->GetUnsupportedReason());
    }
    Messages::ShowWarnings();
    this->LightChanged = true;
    this->Draw();
    this->Settle();
  }
  catch (const Failure& failure)
  {
    failed = std::make_unique<Failure>(failure);
    this->Stage.reset();
    this->Overlay.SetHelp(std::string(failure.what()) + "\nEsc ends.");
    this->Window->Render();
  }
  if (!this->Options.Play.empty())
  {
    this->Play();
    this->Settle();
  }
  else if (!this->Ended)
  {
    vtkNew<vtkInteractorEventRecorder> recorder;
    if (!this->Options.Record.empty())
    {
      recorder->KeyPressActivationOff();
      recorder->SetInteractor(this->Interactor);
      recorder->SetFileName(this->Options.Record.c_str());
      recorder->On();
      recorder->Record();
    }
    constexpr int period = 20; // milliseconds
    this->Interactor->CreateRepeatingTimer(period);
    this->Interactor->Start();
    recorder->Stop();
    recorder->SetInteractor(nullptr);
  }
  if (!this->Options.Screenshot.empty())
  {
    outputs.StagePicture(this->Options.Screenshot,
      this->LastPicture ? this->LastPicture.Get() : ViewSnapshot::Grab(this->Window).Get());
    outputs.Commit();
  }
  if (this->Stage)
  {
    this->Stage->GetRenderer()->SetPass(nullptr);
    this->Stage->GetOther()->SetPass(nullptr);
  }
  this->PrintAverages();
  if (failed)
  {
    throw Failure(*failed);
  }
}
