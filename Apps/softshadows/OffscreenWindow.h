// A window that nobody sees, to draw pictures in.

#ifndef OffscreenWindow_h
#define OffscreenWindow_h

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

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

  /** The last frame, unsigned char RGB. */
  vtkSmartPointer<vtkImageData> Grab();

private:
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  bool Opened = false;
};

#endif
