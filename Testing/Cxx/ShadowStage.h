// SPDX-License-Identifier: BSD-3-Clause
// A window with a scene in it, one pass, and what the tests ask of them. See also ShadowOracle.h.

#ifndef ShadowStage_h
#define ShadowStage_h

#include "ShadowImages.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowPass.h"
#include "vtkSmartPointer.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkPolyData;

/** Where a scene of the tests lies: canonical coordinates are scaled, turned, then moved. */
struct Placement
{
  double Scale = 1.0;
  glm::dmat3 Turn{ 1.0 };
  glm::dvec3 Offset{ 0.0 };
  bool ByActor = false; // by the actors' matrices instead of the points
  glm::dvec3 operator()(const glm::dvec3& p) const
  {
    return this->Turn * (this->Scale * p) + this->Offset;
  }
};

/** The kinds of light the laws run over. */
enum class LightKind
{
  Point,
  Sphere,
  Disk,
  Rectangle,
  Directional,
  Spot
};
constexpr LightKind LightKinds[] = { LightKind::Point, LightKind::Sphere, LightKind::Disk,
  LightKind::Rectangle, LightKind::Directional, LightKind::Spot };
const char* GetName(LightKind kind);

using Parameters = std::map<std::string, std::string>;

class ShadowStage
{
public:
  explicit ShadowStage(int width = 160, int height = 160, const Placement& place = {});
  ~ShadowStage();
  ShadowStage(const ShadowStage&) = delete;
  void operator=(const ShadowStage&) = delete;

  ///@{ Scene; coordinates and lengths are canonical.
  vtkActor* Add(vtkPolyData* polygons, const glm::dvec3& color = glm::dvec3(0.8));
  vtkActor* AddFloor(double halfSide = 4.0, double height = 0.0);
  vtkActor* AddQuad(const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b);
  vtkActor* AddBox(const glm::dvec3& centre, const glm::dvec3& size);
  vtkActor* AddSphere(const glm::dvec3& centre, double radius, int resolution = 24);
  /** Aimed at the origin from up left; its angular diameter or sides fit that. */
  vtkAreaLight* AddLight(LightKind kind);
  vtkAreaLight* AddLight(LightKind kind, const glm::dvec3& position, const glm::dvec3& focus);
  /** One of VTK's own that shines all around, or a directional one; aimed at the origin. */
  vtkLight* AddPlainLight(bool positional, const glm::dvec3& position);
  /** Make it a light of no size, but of its kind. */
  static void Shrink(vtkAreaLight* light, double factor = 0.0);
  void LookAt(const glm::dvec3& position, const glm::dvec3& focus, double viewAngle = 35.0);
  /** Floor, box, sphere and post, and the camera on them: what most laws use. Gives the box. */
  vtkActor* AddThings();
  ///@}

  /**
   * A new pass, and parameters of it that suit a test: few samples, small maps. Parameters that
   * the technique has not are left out, so that the same call serves all.
   */
  vtkShadowPass* SetPass(const std::string& technique, const Parameters& parameters = {});
  static bool HasParameter(const std::string& technique, const std::string& name);
  /** Whether the technique takes this kind of light at all. */
  static bool Supports(const std::string& technique, LightKind kind);
  static const vtkShadowDeclaration& Describe(const std::string& technique);

  void Render();
  Visibility GetVisibility(int light = 0);
  Visibility GetVisibility(vtkLight* light);
  /** Of the whole window, as last rendered. */
  Picture GetPicture();
  nlohmann::json GetStatistics();
  /** statistics["counts"][name]; -1 where there is none. */
  double Count(const std::string& name);
  std::size_t GetBytes() { return this->GetStatistics()["bytes"]["total"]; }
  /** Textures, buffers and framebuffers that live in the context. */
  int CountGLObjects();

  Placement Place;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkShadowPass> Pass;
};

/** The picture's light: Render, then V of light 0, of a scene that `build` makes. */
Visibility RenderVisibility(const std::string& technique, const Parameters& parameters,
  const std::function<void(ShadowStage&)>& build, const Placement& place = {});

#endif
