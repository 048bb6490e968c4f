// SPDX-License-Identifier: BSD-3-Clause
#include "OffscreenWindow.h"

#include "Errors.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtkWindowToImageFilter.h"

#include <chrono>
#include <cstdlib>
#include <string>

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

namespace
{
const char* const HowToGetADisplay =
  " Start an X server such as Xvfb (\"xvfb-run -a softshadows ...\") or set DISPLAY.";
}

//------------------------------------------------------------------------------
// VTK's X window ends the program where it cannot open the display, so that is tried here before. By
// the library that VTK has loaded: only it knows all forms of DISPLAY and who may connect.
void CheckDisplay(vtkRenderWindow* window)
{
  if (!window->IsA("vtkXOpenGLRenderWindow"))
  {
    return; // EGL, OSMesa and other systems' windows report by themselves
  }
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    throw Failure(std::string("there is no display: DISPLAY is not set.") + HowToGetADisplay);
  }
#if __has_include(<dlfcn.h>)
  void* library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
  if (!library)
  {
    return;
  }
  const auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(library, "XOpenDisplay"));
  const auto query = reinterpret_cast<int (*)(void*, const char*, int*, int*, int*)>(
    dlsym(library, "XQueryExtension"));
  if (open && query)
  {
    // Left open: an X server starts over when its last client goes, and would refuse VTK meanwhile.
    void* display = open(name);
    int codes[3];
    if (!display || !query(display, "GLX", &codes[0], &codes[1], &codes[2]))
    {
      const std::string which = "display \"" + std::string(name) + "\" ";
      throw Failure((display ? which + "has no OpenGL (no GLX)." : which + "cannot be opened.") +
                    HowToGetADisplay);
    }
  }
#endif
}

//------------------------------------------------------------------------------
OffscreenWindow::OffscreenWindow(const int size[2], int samplesPerPixel)
  : Window(vtkSmartPointer<vtkRenderWindow>::New())
{
  CheckDisplay(this->Window);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(samplesPerPixel);
  this->Window->SetSize(size[0], size[1]);
  this->Window->AddRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
vtkRenderWindow* OffscreenWindow::GetOpenWindow()
{
  if (this->Opened)
  {
    return this->Window;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Window);
  if (!window)
  {
    throw Failure("this VTK draws without OpenGL; the shadow passes need it.");
  }
  window->Initialize();
  Messages::Check("no OpenGL");
  // VTK draws into nothing where the GPU cannot hold the picture.
  const int* size = window->GetSize();
  const int largest = vtkTextureObject::GetMaximumTextureSize(window);
  if (largest > 0 && (size[0] > largest || size[1] > largest))
  {
    throw Failure("--size " + std::to_string(size[0]) + "x" + std::to_string(size[1]) +
                  ": this OpenGL draws up to " + std::to_string(largest) + " pixels a side.");
  }
  this->Opened = true;
  return window;
}

//------------------------------------------------------------------------------
double OffscreenWindow::Render()
{
  vtkRenderWindow* window = this->GetOpenWindow();
  const auto start = std::chrono::steady_clock::now();
  window->Render();
  window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  Messages::Check();
  return taken.count();
}

//------------------------------------------------------------------------------
void OffscreenWindow::MakeTransparent()
{
  this->Transparent = true;
  this->Window->SetAlphaBitPlanes(1);
  this->Renderer->GradientBackgroundOff();
  this->Renderer->SetBackground(0.0, 0.0, 0.0);
  this->Renderer->SetBackgroundAlpha(0.0);
  this->Renderer->UseDepthPeelingOn();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> OffscreenWindow::Grab()
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(this->Window);
  if (this->Transparent)
  {
    grabber->SetInputBufferTypeToRGBA();
  }
  else
  {
    grabber->SetInputBufferTypeToRGB();
  }
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  grabber->Update();
  Messages::Check("the picture cannot be read back");
  vtkSmartPointer<vtkImageData> picture = grabber->GetOutput();
  return picture;
}
