// SPDX-License-Identifier: BSD-3-Clause
// The declaration of a technique: what the pass, the command, the benchmark, Python and the documentation
// know of it. A family fills one for each name and registers it with vtkShadowTechniqueRegistration.
// Elsewhere names alone are listed: see Documentation/adding-a-technique.md.

#ifndef vtkShadowDeclaration_h
#define vtkShadowDeclaration_h

#include "vtkShadowParameter.h"          // For parameters
#include "vtkSoftShadowsCastersModule.h" // For export macro

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkShadowPass;
class vtkShadowSettings;
class vtkShadowTechnique;

/**
 * How truly a technique treats a light's shape.
 */
enum class vtkShadowShapeSupport
{
  Exact,
  Approximate,
  Unsupported
};

/**
 * What a technique needs of a frame: the pass orders its stages by this, and tests hold techniques to it.
 */
struct vtkShadowTraits
{
  /** One sample of the light decides, so that the light's size does not matter. */
  bool Hard = false;
  /** Only planes receive, and visibility is 1 on all else. */
  bool PlanarReceivers = false;
  /** Light data is made from the receivers of the frame, which are drawn before it. */
  bool NeedsReceivers = false;
  /** Light data depends on the camera. Else a moving camera rebuilds nothing. */
  bool CameraDependent = false;
  /** Its GLSL can run in each prop's shader (vtkShadowTechnique::CanEvaluateForward may forbid it). */
  bool Forward = false;
  /**
   * It fills the visibility buffer by adding shares of light, positive and negative, to full
   * visibility: the pass resolves their sum (vtkVisibilityBuffer::Resolve).
   */
  bool SignedShares = false;
  /**
   * It samples the lights, from vtkShadowLight::FirstSample on: so the mean of several frames is what all
   * of their samples give (parameter accumulate). See vtkShadowTechnique::GetSamples.
   */
  bool SamplesLights = false;
};

struct VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowDeclaration
{
  std::string Name;
  std::string Title;
  std::string Paper; // citation: authors, title, year, section
  /** The pass that has it by default, and how to make one; by default vtkShadowPass itself. */
  std::string ClassName;
  vtkShadowPass* (*NewPass)() = nullptr;
  /** Makes the technique with settings that outlive it. */
  std::function<std::unique_ptr<vtkShadowTechnique>(const vtkShadowSettings&)> Make;
  vtkShadowTraits Traits;
  /** Point, sphere, disk, rectangle, directional, textured rectangle: in this order. By default exact. */
  std::array<vtkShadowShapeSupport, 6> LightShapes{};
  std::vector<vtkShadowParameter> Parameters;
  /** Beside those that all have: none, visibility, penumbra, cost. */
  std::vector<std::string> DebugViews;
  /** What it keeps on the GPU, and how much: "depth map, 4 bytes a texel, resolution^2". */
  std::vector<std::string> Resources;
  /** What it cannot do, in sentences. */
  std::vector<std::string> Limits;

  static constexpr std::array<const char*, 6> ShapeNames = { "point", "sphere", "disk", "rectangle",
    "directional", "textured" };

  /**
   * The technique's class, and the pass that is named after it. Of a class that has several techniques,
   * what it is made with beside the settings.
   */
  template <typename Technique, typename Pass, typename... Which>
  void SetClasses(const char* nameOfPass, Which... which)
  {
    this->Make = [which...](
                   const vtkShadowSettings& settings) -> std::unique_ptr<vtkShadowTechnique>
    { return std::make_unique<Technique>(settings, which...); };
    this->NewPass = []() -> vtkShadowPass* { return Pass::New(); };
    this->ClassName = nameOfPass;
  }

  /** Of the technique, or one that all have; nullptr where there is none. */
  const vtkShadowParameter* FindParameter(const std::string& name) const;
};

/**
 * Registers a technique while its library is loaded: one static object for each name.
 */
class VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowTechniqueRegistration
{
public:
  explicit vtkShadowTechniqueRegistration(vtkShadowDeclaration declaration);

  using Registry = std::map<std::string, vtkShadowDeclaration>;
  /**
   * All registered techniques by name. Passes and callers keep pointers to what stands here: an
   * entry neither moves nor changes when another family is loaded.
   */
  static const Registry& GetAll();
  /** A technique by name, nullptr where there is none. */
  static const vtkShadowDeclaration* Find(const std::string& name);
  /** What to do where there is none at all. */
  static std::string GetHint();
};

/**
 * Define in a family's module what VTK's autoinit calls, so that linking a family is enough to have
 * its techniques: the call keeps the linker from dropping the library.
 */
#define vtkShadowTechniqueAutoInit(exportMacro, library) \
  exportMacro void library##_AutoInit_Construct() {}     \
  static_assert(true, "a semicolon follows")

#endif
