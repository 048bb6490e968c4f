// SPDX-License-Identifier: BSD-3-Clause
// The viewer: a window on a scene, and what the user does in it. Keys act by the table of ViewKeys.

#ifndef Viewer_h
#define Viewer_h

#include "ViewModel.h"
#include "ViewOverlay.h"
#include "ViewStage.h"
#include "ViewText.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct ViewOptions
{
  SceneOptions Scene;
  TechniqueOptions Parameters;
  std::string Technique;
  std::string DebugView;
  double LeastRate = 15.0; // frames a second that are kept while the user drags; 0: whatever it is
  std::string Play;
  std::string Record;
  std::string Screenshot;
};

class Viewer
{
public:
  explicit Viewer(const ViewOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  void operator=(const Viewer&) = delete;

  /** Until the user ends it. Failure where the scene cannot be had, after the window has said so. */
  void Run();

  ///@{ Actions, as the table of keys names them.
  void RaiseLight(int step);
  void ScaleLight(int step);
  void Zoom(int step);
  void ResetCamera(int);
  void StepTechnique(int step);
  void Spin(int casters);
  void SetQuality(int level);
  void Choose(int step);
  void Change(int step);
  void SwitchMidpoint(int);
  void SwitchSamples(int);
  void StepDebugView(int step);
  void SplitReference(int);
  void SplitTechnique(int);
  void MoveDivider(int step);
  void SwitchErrors(int);
  void SwitchLights(int);
  void SwitchText(int);
  void SwitchHelp(int);
  void TakeSnapshot(int);
  void PrintOptions(int);
  void End(int);
  ///@}

private:
  enum class Drag
  {
    None,
    Camera,
    Light,
    Divider
  };
  enum class Spinning
  {
    None,
    Camera,
    Casters
  };
  struct Average
  {
    long long Frames = 0;
    double Milliseconds = 0.0;
  };

  // Viewer.cxx: the window and its frames.
  void Open();
  void Load();
  void Draw();
  void Settle();
  void DrawErrors();
  double RenderWindow();
  double GetDivider() const;
  std::string GetStatus() const;
  void PrintAverages() const;
  void Play();

  // ViewerEvents.cxx: the mouse, keys and time.
  void Listen();
  void Handle(vtkObject* caller, unsigned long event, void* data);
  void Act(unsigned long event);
  void Press(Drag drag);
  void Move();
  void Release();
  void PressKey();
  void OpenMenu();
  void ChooseInMenu();
  void Tick();

  // ViewerActions.cxx.
  void Split(bool on, const std::string& technique);
  std::vector<std::string> GetOptions() const;
  void Say(const std::string& text);

  ViewOptions Options;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  std::unique_ptr<ViewStage> Stage;
  std::unique_ptr<ViewModel> Left;
  std::unique_ptr<ViewModel> Right;
  ViewOverlay Overlay;
  vtkNew<vtkRenderer> Blank; // beneath the overlay, before there is a scene

  bool Ended = false;
  vtkSmartPointer<vtkImageData> LastPicture; // of the window, where a screenshot is asked for
  bool TextShown = true;
  bool HelpShown = false;
  bool LightsShown = false;
  bool IsSplit = false;
  bool ErrorsShown = false;
  double Divider = 0.5;
  Spinning Spins = Spinning::None;
  Drag Dragging = Drag::None;
  int Last[2] = { 0, 0 }; // the pointer's place at the event before
  std::vector<std::function<void()>> MenuActions;

  std::string Message; // said until the next key or button
  ViewFigures Figures;
  std::vector<double> Recent; // milliseconds of the last frames
  std::map<std::string, Average> Averages;
  bool Unsettled = false; // something was drawn since it was at rest
  bool LightChanged = false;
  double LightData = 0.0; // milliseconds
  std::chrono::steady_clock::time_point LastEvent;
};

#endif
