// SPDX-License-Identifier: BSD-3-Clause
// What a pass puts into the shaders of VTK's mappers, and its uniforms there: see vtkShadowInjection for
// the text. A mapper knows of it by the pass's key in its prop's keys (Marks).

#ifndef vtkShadowInjector_h
#define vtkShadowInjector_h

#include "vtkAbstractMapper.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"
#include "vtkShadowInjection.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <set>
#include <string>
#include <vector>

class vtkShaderProgram;
class vtkShadowTechnique;
struct vtkShadowFrame;
struct vtkShadowScreen;

/** Draws nothing; stands in a catcher's keys, so that mappers make it a shader of its own. */
class vtkShadowCatcherMark : public vtkOpenGLRenderPass
{
public:
  static vtkShadowCatcherMark* New();
  vtkTypeMacro(vtkShadowCatcherMark, vtkOpenGLRenderPass);
  void Render(const vtkRenderState*) override {}
};

class vtkShadowInjector
{
public:
  /** What is drawn with it. */
  struct Use
  {
    const vtkShadowFrame* Frame = nullptr;
    vtkShadowTechnique* Technique = nullptr; // nullptr: there are no shadows
    bool ScreenSpace = false;
    bool Smooth = false; // the terminator: see vtkShadowTerminatorFS.glsl
    vtkShadowScreen* Opaque = nullptr;
    vtkShadowScreen* Translucent = nullptr; // nullptr where nothing translucent has its own
    vtkShadowScreen* Written = nullptr;     // whose receivers are drawn; nullptr: the picture is
  };

  /** Choose the code for what is drawn next. A change makes the mappers build their shaders anew. */
  void Update(const Use& use);
  /** When the code changed: vtkOpenGLRenderPass::GetShaderStageMTime. */
  vtkMTimeType GetTime() const { return this->Time; }

  ///@{ The pass's part in a mapper's shader. Fill gives what keeps it from being shadowed, or "".
  static void Mark(const vtkShadowInjection::Shaders& shaders, vtkProp* prop);
  std::string Fill(
    const vtkShadowInjection::Shaders& shaders, vtkAbstractMapper* mapper, vtkProp* prop);
  void SetParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop);
  ///@}

  /** While it lives, a pass is drawing props and their parts. */
  class Marks
  {
  public:
    Marks(vtkShadowInjector& injector, vtkOpenGLRenderPass* pass,
      const std::vector<vtkSmartPointer<vtkProp>>& props);
    ~Marks();
    Marks(const Marks&) = delete;
    void operator=(const Marks&) = delete;

    /** The keys of all of them. */
    const std::vector<vtkSmartPointer<vtkInformation>>& Get() const { return this->Keys; }

  private:
    void Add(vtkProp* prop);

    vtkShadowInjector& Injector;
    vtkOpenGLRenderPass* Pass;
    std::vector<vtkSmartPointer<vtkInformation>> Keys;
  };

private:
  /** What turns a fragment's place into the buffers' pixel: a larger picture shows it elsewhere. */
  void SetToPixel(vtkShaderProgram* program, const std::array<int, 4>& viewport) const;
  /** How far a prop's positions in VC may be off by what VTK computes them with: a power of two. */
  double GetRounding(vtkAbstractMapper* mapper, vtkProp* prop) const;
  /** What is the same for all props that are drawn to one viewport. */
  void SetFrameParameters(vtkShaderProgram* program, const std::array<int, 4>& viewport);

  Use Current;
  const vtkShadowFrame* Frame = nullptr;
  glm::dmat4 WorldToVTK{ 1.0 }; // to VTK's view coordinates
  vtkShadowInjection::Code Code;
  vtkTimeStamp Time;
  /** Of shaders that were made for flat data. */
  std::vector<vtkWeakPointer<vtkAbstractMapper>> FlatMappers;
  std::set<vtkShaderProgram*> UpToDatePrograms;
  std::array<int, 4> Viewport{}; // that they were set for
  vtkNew<vtkShadowCatcherMark> CatcherMark;
};

#endif
