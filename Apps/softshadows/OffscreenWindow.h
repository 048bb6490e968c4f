// SPDX-License-Identifier: BSD-3-Clause
// A window that nobody sees, to draw pictures in.

#ifndef OffscreenWindow_h
#define OffscreenWindow_h

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

/** Failure where there is no display that a window could be opened on: VTK would end the program. */
void CheckDisplay(vtkRenderWindow* window);

class OffscreenWindow
{
public:
  /** Failure where there is no display to draw with. */
  OffscreenWindow(const int size[2], int samplesPerPixel);

  vtkRenderer* GetRenderer() { return this->Renderer; }

  /** The window, with OpenGL ready. Failure where there is none, or it cannot draw that size. */
  vtkRenderWindow* GetOpenWindow();

  /**
   * Draw a frame and wait for it to be complete: the milliseconds that took. Failure if VTK reports
   * an error.
   */
  double Render();

  /**
   * Before the first frame: what nothing is drawn over becomes clear. Translucent props are peeled from
   * then on, without which VTK 9.1 writes a wrong alpha.
   */
  void MakeTransparent();

  /** The last frame, unsigned char RGB, or RGBA where the window is transparent. */
  vtkSmartPointer<vtkImageData> Grab();

private:
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  bool Opened = false;
  bool Transparent = false;
};

#endif
