// SPDX-License-Identifier: BSD-3-Clause
// What the viewer shows over the scene: texts, the menu, the line between two sides, a picture.

#ifndef ViewOverlay_h
#define ViewOverlay_h

#include "vtkActor2D.h"
#include "vtkImageData.h"
#include "vtkImageMapper.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"

#include <string>
#include <vector>

class vtkRenderWindow;

class ViewOverlay
{
public:
  ViewOverlay();

  /** Onto a window, above all else. */
  void PutOn(vtkRenderWindow* window);
  void SetShown(bool shown);

  void SetInfo(const std::string& text);   // above left
  void SetStatus(const std::string& text); // below left
  void SetHelp(const std::string& text);   // in the middle
  void SetDivider(bool shown, double share);
  void SetPicture(vtkImageData* picture); // nullptr: none

  ///@{ A menu, from a place of the window on.
  void OpenMenu(const std::vector<std::string>& lines, const int place[2]);
  void CloseMenu();
  bool IsMenuOpen() const { return !this->Lines.empty(); }
  /** The line at a place, -1 beside all; it is shown as chosen. */
  int Point(const int place[2]);
  ///@}

private:
  void Fill(vtkTextActor* actor, const std::string& text);
  int GetLineHeight() const;

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkTextActor> Info;
  vtkNew<vtkTextActor> Status;
  vtkNew<vtkTextActor> Help;
  std::vector<vtkSmartPointer<vtkTextActor>> Menu;
  std::vector<std::string> Lines;
  int Top[2] = { 0, 0 };
  vtkNew<vtkActor2D> Divider;
  vtkNew<vtkPoints> Ends;
  vtkNew<vtkActor2D> Picture;
  vtkNew<vtkImageMapper> PictureMapper;
};

#endif
