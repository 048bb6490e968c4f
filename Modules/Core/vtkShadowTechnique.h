// The declaration of a technique: what the command, the viewer, the benchmark, Python and the
// documentation know of it. A family module fills one of these per name and registers it with
// vtkShadowTechniqueRegistration; nothing else in the project repeats what stands here.

#ifndef vtkShadowTechnique_h
#define vtkShadowTechnique_h

#include "vtkSoftShadowsCoreModule.h" // For export macro

#include <array>
#include <map>
#include <string>
#include <vector>

class vtkShadowPass;

/**
 * A parameter that vtkShadowPass::SetParameter understands.
 */
struct vtkShadowParameter
{
  enum class Type
  {
    Integer,
    Real,
    Boolean, // "on" or "off"
    Choice
  };

  std::string Name;
  Type ValueType = Type::Integer;
  std::string Default;
  double Minimum = 0.0; // inclusive, for Integer and Real
  double Maximum = 0.0; // inclusive
  std::vector<std::string> Choices;
  std::string Unit;
  std::string Meaning;
  /** Values at quality low, medium, high, reference; empty where quality does not matter. */
  std::vector<std::string> Presets;
};

/**
 * How truly a technique treats a light's shape.
 */
enum class vtkShadowShapeSupport
{
  Exact,
  Approximate,
  Unsupported
};

struct vtkShadowTechnique
{
  std::string Name;
  std::string Title;
  std::string Paper; // citation: authors, title, year, section
  std::string ClassName;
  vtkShadowPass* (*New)() = nullptr;
  /** Point, sphere, disk, rectangle, directional, textured rectangle: in this order. */
  std::array<vtkShadowShapeSupport, 6> LightShapes{};
  std::vector<vtkShadowParameter> Parameters;
  /** What it keeps on the GPU, and how much: "depth map, 4 bytes a texel, resolution^2". */
  std::vector<std::string> Resources;
  /** What it cannot do, in sentences. */
  std::vector<std::string> Limits;
  /** True where one sample of the light decides, so that the light's size does not matter. */
  bool Hard = false;
  /** True where only planes receive, and visibility is 1 on all else. */
  bool PlanarReceivers = false;

  static constexpr std::array<const char*, 6> ShapeNames = { "point", "sphere", "disk", "rectangle",
    "directional", "textured" };
};

/**
 * Registers a technique while its library is loaded: one static object for each name.
 */
class VTKSOFTSHADOWSCORE_EXPORT vtkShadowTechniqueRegistration
{
public:
  explicit vtkShadowTechniqueRegistration(vtkShadowTechnique technique);

  using Registry = std::map<std::string, vtkShadowTechnique>;
  /**
   * All registered techniques by name. Passes and callers keep pointers to what stands here: an
   * entry neither moves nor changes when another family is loaded.
   */
  static const Registry& GetAll();
  /** A technique by name, nullptr where there is none. */
  static const vtkShadowTechnique* Find(const std::string& name);
};

/**
 * Define in a family's module what VTK's autoinit calls, so that linking a family is enough to have
 * its techniques: the call keeps the linker from dropping the library.
 */
#define vtkShadowTechniqueAutoInit(exportMacro, library) \
  exportMacro void library##_AutoInit_Construct() {}

#endif
