// SPDX-License-Identifier: BSD-3-Clause
// The state of a vtkShadowPass.

#ifndef vtkShadowPassInternals_h
#define vtkShadowPassInternals_h

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"
#include "vtkShadowAccumulation.h"
#include "vtkShadowErrorEstimate.h"
#include "vtkShadowInjector.h"
#include "vtkShadowMessages.h"
#include "vtkShadowPass.h"
#include "vtkShadowReadback.h"
#include "vtkShadowSettings.h"
#include "vtkShadowStages.h"
#include "vtkShadowTechnique.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <string>
#include <vector>

/**
 * Frees a pass when its context ends. VTK tells textures of it, wherever they are held, so this is one,
 * though an empty one: SetContext(window) begins, SetContext(nullptr) frees at once.
 */
class vtkShadowContextWatch : public vtkTextureObject
{
public:
  static vtkShadowContextWatch* New();
  vtkTypeMacro(vtkShadowContextWatch, vtkTextureObject);
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Superclass::ReleaseGraphicsResources(window);
    if (this->Pass)
    {
      this->Pass->ReleaseGraphicsResources(window);
    }
  }
  vtkShadowPass* Pass = nullptr;
};

class vtkShadowPass::Internals
{
public:
  explicit Internals(vtkShadowPass* pass)
    : Messages(pass)
  {
  }

  // The technique, and what the user has set.
  vtkShadowSettings Settings;
  std::unique_ptr<vtkShadowTechnique> Technique;
  std::vector<std::unique_ptr<vtkShadowTechnique>>
    Retired; // to be released when a context is there
  std::string DebugView = "none";
  vtkSmartPointer<vtkRenderPass> Delegate;
  std::string UnsupportedReason;
  vtkShadowMessages Messages;

  // The frame.
  vtkShadowStages Stages;
  vtkShadowInjector Injector;
  vtkShadowAccumulation Accumulation;
  vtkShadowReadback Readback;
  vtkShadowErrorEstimate Error;
  nlohmann::ordered_json Errors; // that were estimated of a frame, by the light's number
  unsigned long ErrorFrame = 0;  // and which frame
  std::vector<vtkSmartPointer<vtkProp>> Props; // what survived culling, while it is drawn
  int Size[2] = { 0, 0 };
  bool HasCatchers = false;    // among the props
  bool Active = false;         // shadows are drawn in this frame
  bool Advised = false;        // a pass gives advice once
  bool BufferAskedFor = false; // by GetVisibility, since the last frame
  unsigned long Frames = 0;

  /** Where the pass is: see vtkShadowPassLifetime.cxx. */
  struct Attachment
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkOpenGLRenderWindow> Window;
    vtkNew<vtkShadowContextWatch> Context;
    unsigned long Observers[2] = { 0, 0 };
    bool Seen = false;             // in the renderer's chain of passes
    bool Holding = false;          // GPU resources, perhaps
    bool Drawn = false;            // in the renderer's frame that is going on
    bool Rendering = false;        // now
    bool RemovedMeanwhile = false; // from the renderer, while it rendered

    // Further renderers: a copy of the pass for each.
    struct CopyOf
    {
      vtkWeakPointer<vtkRenderer> Renderer;
      vtkSmartPointer<vtkShadowPass> Pass;
      vtkTimeStamp Time; // of its settings
    };
    std::vector<CopyOf> Copies;
    vtkWeakPointer<vtkShadowPass> Copy; // that drew the last frame; nullptr: this pass did
    vtkShadowPass* Original = nullptr;  // of a copy
  };
  Attachment At;

  /** What the injected code is to be made for. */
  vtkShadowInjector::Use GetUse();
  /** Free the light data of techniques that were replaced, in the context that they are of. */
  void ReleaseRetired(vtkOpenGLRenderWindow* window);
};

#endif
