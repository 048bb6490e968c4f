// SPDX-License-Identifier: BSD-3-Clause
// The mouse, keys and time in the viewer's window.

#include "Errors.h"
#include "ViewKeys.h"
#include "Viewer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace
{
constexpr double DegreesOfWindow = 180.0; // that a drag over all of it turns
constexpr int Grip = 6;                   // pixels around the divider that take hold of it
constexpr double Rest = 250.0;            // milliseconds without an event
}

//------------------------------------------------------------------------------
void Viewer::Listen()
{
  static constexpr std::array<unsigned long, 12> events = { vtkCommand::LeftButtonPressEvent,
    vtkCommand::LeftButtonReleaseEvent, vtkCommand::MiddleButtonPressEvent,
    vtkCommand::MiddleButtonReleaseEvent, vtkCommand::RightButtonPressEvent,
    vtkCommand::MouseMoveEvent, vtkCommand::MouseWheelForwardEvent,
    vtkCommand::MouseWheelBackwardEvent, vtkCommand::KeyPressEvent, vtkCommand::TimerEvent,
    vtkCommand::ExposeEvent, vtkCommand::ConfigureEvent };
  for (const unsigned long event : events)
  {
    this->Interactor->AddObserver(event, this, &Viewer::Handle);
  }
}

//------------------------------------------------------------------------------
// What goes wrong is said in the window; the user goes on.
void Viewer::Handle(vtkObject*, unsigned long event, void*)
{
  if (this->Ended)
  {
    return;
  }
  try
  {
    this->Act(event);
  }
  catch (const std::exception& failure)
  {
    this->Say(failure.what());
    this->Draw();
  }
}

//------------------------------------------------------------------------------
void Viewer::Act(unsigned long event)
{
  if (event != vtkCommand::TimerEvent)
  {
    this->LastEvent = std::chrono::steady_clock::now();
  }
  if (!this->Stage) // all that is left to do is to end
  {
    const char* key = this->Interactor->GetKeySym();
    if (event == vtkCommand::KeyPressEvent && key && std::string(key) == "Escape")
    {
      this->End(0);
    }
    else if (event == vtkCommand::ExposeEvent)
    {
      this->Window->Render();
    }
    return;
  }
  switch (event)
  {
    case vtkCommand::LeftButtonPressEvent:
      this->Overlay.IsMenuOpen() ? this->ChooseInMenu() : this->Press(Drag::Camera);
      break;
    case vtkCommand::MiddleButtonPressEvent:
      this->Press(Drag::Light);
      break;
    case vtkCommand::RightButtonPressEvent:
      this->Overlay.IsMenuOpen() ? this->ChooseInMenu() : this->OpenMenu();
      break;
    case vtkCommand::LeftButtonReleaseEvent:
    case vtkCommand::MiddleButtonReleaseEvent:
      this->Release();
      break;
    case vtkCommand::MouseMoveEvent:
      this->Move();
      break;
    case vtkCommand::MouseWheelForwardEvent:
      this->Zoom(1);
      this->Draw();
      break;
    case vtkCommand::MouseWheelBackwardEvent:
      this->Zoom(-1);
      this->Draw();
      break;
    case vtkCommand::KeyPressEvent:
      this->PressKey();
      break;
    case vtkCommand::TimerEvent:
      this->Tick();
      break;
    default: // uncovered, or another size
      this->Draw();
  }
}

//------------------------------------------------------------------------------
void Viewer::Press(Drag drag)
{
  this->Message.clear();
  this->Interactor->GetEventPosition(this->Last);
  const double line = this->Divider * this->Window->GetSize()[0];
  const bool held = this->IsSplit && std::abs(this->Last[0] - line) <= Grip;
  this->Dragging = held && drag == Drag::Camera ? Drag::Divider : drag;
}

//------------------------------------------------------------------------------
void Viewer::Move()
{
  int place[2];
  this->Interactor->GetEventPosition(place);
  if (this->Overlay.IsMenuOpen())
  {
    this->Overlay.Point(place);
    this->Draw();
    return;
  }
  const int* size = this->Window->GetSize();
  const double right = static_cast<double>(place[0] - this->Last[0]) / size[0];
  const double up = static_cast<double>(place[1] - this->Last[1]) / size[1];
  std::copy_n(place, 2, this->Last);
  switch (this->Dragging)
  {
    case Drag::Camera:
      this->Stage->Turn(DegreesOfWindow * right, DegreesOfWindow * up);
      break;
    case Drag::Light:
      this->Stage->MoveLight(right, up);
      this->LightChanged = true;
      break;
    case Drag::Divider:
      this->Divider = std::clamp(static_cast<double>(place[0]) / size[0], 0.0, 1.0);
      break;
    default:
      return;
  }
  this->Draw();
}

//------------------------------------------------------------------------------
void Viewer::Release()
{
  if (this->Dragging != Drag::None)
  {
    this->Dragging = Drag::None;
    this->Settle();
  }
}

//------------------------------------------------------------------------------
void Viewer::PressKey()
{
  const char* key = this->Interactor->GetKeySym();
  const ViewKey* found = key ? ViewKeys::Find(key, this->Interactor->GetShiftKey() != 0) : nullptr;
  if (!found)
  {
    return;
  }
  this->Message.clear();
  this->Overlay.CloseMenu();
  (this->*found->Action)(found->Amount);
  if (!this->Ended)
  {
    this->Draw();
  }
}

//------------------------------------------------------------------------------
void Viewer::OpenMenu()
{
  this->Message.clear();
  std::vector<std::string> lines;
  this->MenuActions.clear();
  const auto add = [&](const std::string& line, bool now, std::function<void()> action)
  {
    lines.push_back((now ? " * " : "   ") + line + " ");
    this->MenuActions.push_back(std::move(action));
  };
  for (const std::string& name : ViewModel::GetTechniques())
  {
    add(name, name == this->Left->GetTechnique(),
      [this, name]
      {
        this->Left->SetTechnique(name);
        this->LightChanged = true;
      });
  }
  for (const std::string& view : this->Left->GetDebugViews())
  {
    if (this->Left->GetPass())
    {
      add("view " + view, view == this->Left->GetDebugView(),
        [this, view] { this->Left->SetDebugView(view); });
    }
  }
  int place[2];
  this->Interactor->GetEventPosition(place);
  this->Overlay.OpenMenu(lines, place);
  this->Draw();
}

//------------------------------------------------------------------------------
// Beside the menu nothing is chosen.
void Viewer::ChooseInMenu()
{
  int place[2];
  this->Interactor->GetEventPosition(place);
  const int line = this->Overlay.Point(place);
  this->Overlay.CloseMenu();
  if (line >= 0)
  {
    this->MenuActions[line]();
    this->Recent.clear();
  }
  this->Draw();
}

//------------------------------------------------------------------------------
// A degree a frame, so that all techniques go the same way.
void Viewer::Tick()
{
  if (this->Spins == Spinning::Camera)
  {
    this->Stage->Turn(-1.0, 0.0);
    this->Draw();
  }
  else if (this->Spins == Spinning::Casters)
  {
    this->Stage->TurnCasters(1.0);
    this->LightChanged = true;
    this->Draw();
  }
  else if (this->Dragging == Drag::None && !this->Overlay.IsMenuOpen())
  {
    const std::chrono::duration<double, std::milli> still =
      std::chrono::steady_clock::now() - this->LastEvent;
    if (still.count() > Rest)
    {
      this->Settle();
    }
  }
}
