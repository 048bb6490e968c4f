// The state of a vtkShadowPass.

#ifndef vtkShadowPassInternals_h
#define vtkShadowPassInternals_h

#include "vtkAbstractMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkRenderPass.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowGL.h"
#include "vtkShadowInjection.h"
#include "vtkShadowPass.h"
#include "vtkShadowTechnique.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"
#include "vtkVisibilityBuffer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

/** Draws nothing; see Internals::CatcherMark. */
class vtkShadowCatcherMark : public vtkOpenGLRenderPass
{
public:
  static vtkShadowCatcherMark* New();
  vtkTypeMacro(vtkShadowCatcherMark, vtkOpenGLRenderPass);
  void Render(const vtkRenderState*) override {}
};

/** A parameter's value, read once, when it is set. */
struct vtkShadowValue
{
  std::string Text;    // as it was set; a whole number or a boolean in its plain form
  double Number = 0.0; // 1 for on
};

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
    this->Pass->ReleaseGraphicsResources(window);
  }
  vtkShadowPass* Pass = nullptr;
};

class vtkShadowPass::Internals
{
public:
  /** As many as uniforms are sure to hold. */
  static constexpr int MaximumLights = 16;

  // Settings.
  const vtkShadowTechnique* Technique = nullptr;
  std::map<std::string, vtkShadowValue> Values;
  vtkTimeStamp ParameterTime;
  std::string DebugView = "none";
  vtkSmartPointer<vtkRenderPass> Delegate;
  std::string UnsupportedReason;
  std::set<std::string> Said;

  // The frame.
  vtkShadowFrame Frame;
  vtkShadowCasters Casters;
  vtkVisibilityBuffer Buffer;
  vtkVisibilityBuffer Glass;              // of the nearest translucent surfaces
  vtkVisibilityBuffer* Written = nullptr; // whose receivers are being drawn
  vtkShadowTimers Timers;
  vtkShadowQuad Quad;
  std::vector<std::string> LightNotes; // how each light was treated
  bool Active = false;                 // shadows are drawn in this frame
  bool BufferValid = false;            // the buffer holds the last frame
  bool GlassValid = false;
  bool BufferAskedFor = false; // by GetVisibility, since the last frame
  bool Rendering = false;
  bool RemovedMeanwhile = false; // from the renderer, while it rendered
  bool HasCatchers = false;      // among the props
  bool ScreenSpace = false;
  bool WritesReceivers = false; // what is drawn now fills the receivers' buffer
  int Size[2] = { 0, 0 };
  std::vector<vtkSmartPointer<vtkProp>> Props; // what survived culling, while it is drawn
  std::vector<vtkSmartPointer<vtkInformation>>
    Marked; // keys of these and their parts: with the pass
  std::set<vtkShaderProgram*> UpToDatePrograms;
  std::array<int, 4> Viewport{}; // that they were set for
  unsigned long Frames = 0;

  /** Stands in a catcher's keys, so that mappers make it a shader of its own. */
  vtkNew<vtkShadowCatcherMark> CatcherMark;

  // What is injected; a change makes the mappers build their shaders anew.
  vtkShadowInjection::Code Injected;
  vtkTimeStamp StageTime;
  /** Of shaders that were made for flat data. */
  std::vector<vtkWeakPointer<vtkAbstractMapper>> FlatMappers;

  // Release when removed: see vtkShadowPassLifetime.cxx.
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkNew<vtkShadowContextWatch> Context;
  unsigned long Observers[2] = { 0, 0 };
  bool Seen = false;    // in the renderer's chain of passes
  bool Holding = false; // GPU resources, perhaps
  bool Drawn = false;   // in the renderer's frame that is going on

  /** The last that GetVisibility gave of each light. */
  std::map<const vtkLight*, vtkSmartPointer<vtkImageData>> VisibilityImages;

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

  /** The lights in the order of their numbers, as GetVisibility takes them. */
  std::vector<vtkLight*> GetLights() const;
  /** Lights' uniforms of vtkShadowLightsFS.glsl. */
  void SetLights(vtkShaderProgram* program);
  /** What turns a fragment's place into the buffers' pixel: a larger picture shows it elsewhere. */
  void SetToPixel(vtkShaderProgram* program, const std::array<int, 4>& viewport);
  /** How far a prop's positions in VC may be off by what VTK computes them with: a power of two. */
  double GetRounding(vtkAbstractMapper* mapper, vtkProp* prop) const;
  /** `#define`s and GLSL that both ways of evaluation start with. */
  std::string GetPreamble() const;
};

#endif
