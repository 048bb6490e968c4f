// SPDX-License-Identifier: BSD-3-Clause
// vtkLightFrusta: the views hold all that casts, and no more; no window is needed.

#include "ShadowTesting.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkLightFrusta.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkShadowCasters.h"
#include "vtkShadowLight.h"
#include "vtkShadowTags.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTrivialProducer.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr double Border = 0.02;

/** A scene without a window: a renderer, its casters and one light. */
class Scene
{
public:
  Scene() { this->Renderer->AddLight(this->Light); }
  vtkActor* AddSource(vtkPolyDataAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }
  vtkActor* AddSphere(const glm::dvec3& centre, double radius)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(radius);
    vtkActor* actor = this->AddSource(sphere);
    actor->SetPosition(centre.x, centre.y, centre.z);
    return actor;
  }
  vtkActor* AddBox(const glm::dvec3& centre, double side)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(side);
    cube->SetYLength(side);
    cube->SetZLength(side);
    vtkActor* actor = this->AddSource(cube);
    actor->SetPosition(centre.x, centre.y, centre.z);
    return actor;
  }
  vtkActor* AddFloor(const glm::dvec3& centre, double side)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-0.5 * side, -0.5 * side, 0.0);
    plane->SetPoint1(0.5 * side, -0.5 * side, 0.0);
    plane->SetPoint2(-0.5 * side, 0.5 * side, 0.0);
    vtkActor* actor = this->AddSource(plane);
    actor->SetPosition(centre.x, centre.y, centre.z);
    return actor;
  }
  void SetLight(const glm::dvec3& position, const glm::dvec3& focus)
  {
    this->Light->SetPosition(position.x, position.y, position.z);
    this->Light->SetFocalPoint(focus.x, focus.y, focus.z);
  }
  void Update()
  {
    this->Casters.Update(this->Renderer);
    this->Gathered = vtkShadowLight::Gather(this->Renderer, 0.0).at(0);
  }
  vtkLightFrusta GetFrusta(bool neighbours = false) const
  {
    vtkLightFrusta::Options options;
    options.Border = Border;
    options.Neighbours = neighbours;
    return vtkLightFrusta(this->Gathered, this->Casters, options);
  }
  /** As maps of a resolution ask for them. */
  vtkLightFrusta GetSteadyFrusta(int resolution = 512) const
  {
    vtkLightFrusta::Options options;
    options.Border = 2.0 / resolution;
    options.Texel = 1.0 / resolution;
    options.Groups = 4;
    return vtkLightFrusta(this->Gathered, this->Casters, options);
  }
  glm::dvec3 GetCentre() const
  {
    return this->Gathered.IsDirectional() ? -this->Gathered.Direction : this->Gathered.Position;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkAreaLight> Light;
  vtkShadowCasters Casters;
  vtkShadowLight Gathered;
};

//------------------------------------------------------------------------------
bool IsInside(const vtkLightView& view, const glm::dvec3& place, double border)
{
  const glm::dvec4 clip = view.SWCToClip * glm::dvec4(place, 1.0);
  const double window = clip.w * (1.0 - border);
  return clip.w > 0.0 && std::abs(clip.x) <= window && std::abs(clip.y) <= window &&
         std::abs(clip.z) <= clip.w;
}

/** Vertices of a caster, in SWC. */
std::vector<glm::dvec3> GetVertices(const vtkShadowCaster& caster)
{
  std::vector<glm::dvec3> vertices;
  for (std::size_t i = 0; i < caster.Mesh->GetNumberOfVertices(); ++i)
  {
    const float* p = &caster.Mesh->Positions[3 * i];
    vertices.emplace_back(caster.MeshToSWC * glm::dvec4(p[0], p[1], p[2], 1.0));
  }
  return vertices;
}

/** The area of a view's window at w = 1. */
double GetWindow(const vtkLightView& view)
{
  return glm::length(view.WindowX) * glm::length(view.WindowY);
}

/** The views from the light's centre, after a look whether they hold all vertices that count. */
std::vector<vtkLightView> GetHoldingViews(const Scene& scene)
{
  const vtkLightFrusta frusta = scene.GetFrusta();
  const auto views = frusta.GetViews(scene.GetCentre());
  for (const int i : frusta.GetCasters())
  {
    for (const auto& vertex : GetVertices(scene.Casters.Get().at(i)))
    {
      CHECK(std::any_of(views.begin(), views.end(),
        [&vertex](const vtkLightView& view) { return IsInside(view, vertex, 0.0); }));
    }
  }
  return views;
}

//------------------------------------------------------------------------------
// Two things over a floor, from each corner of an area light: one view that holds them with a
// border to spare, and the floor left out. Anywhere in the world.
void TestCornersInside(const glm::dvec3& origin)
{
  Scene scene;
  vtkActor* ball = scene.AddSphere(origin + glm::dvec3(0.3, 0.0, 1.0), 0.5);
  ball->RotateX(30.0);
  ball->SetScale(1.0, 2.0, 0.5);
  scene.AddBox(origin + glm::dvec3(-1.0, 0.5, 0.5), 1.0);
  vtkActor* floor = scene.AddFloor(origin, 10.0);
  scene.SetLight(origin + glm::dvec3(1.0, 2.0, 6.0), origin);
  scene.Light->SetShapeToRectangle();
  scene.Light->SetWidth(2.0);
  scene.Light->SetHeight(1.0);
  scene.Update();
  CHECK_EQUAL(scene.Casters.Get().size(), std::size_t(3));
  CHECK_NEAR(glm::length(scene.Casters.GetOrigin() - origin), 0.0,
    glm::length(origin) > 100.0 ? 10.0 : glm::length(origin) + 10.0);

  const vtkLightFrusta frusta = scene.GetFrusta();
  CHECK_EQUAL(frusta.GetCasters().size(), std::size_t(2));
  for (const int i : frusta.GetCasters())
  {
    CHECK(scene.Casters.Get().at(i).Prop != floor);
  }
  auto places = scene.Gathered.GetExtremes();
  places.push_back(scene.GetCentre());
  CHECK_EQUAL(places.size(), std::size_t(5));
  for (const auto& place : places)
  {
    const auto views = frusta.GetViews(place);
    CHECK_EQUAL(views.size(), std::size_t(1));
    for (const int i : frusta.GetCasters())
    {
      for (const auto& corner : scene.Casters.Get().at(i).Corners)
      {
        CHECK(IsInside(views.at(0), corner, Border));
      }
    }
    CHECK_NEAR(glm::length(views.at(0).Place - (place - scene.Casters.GetOrigin())), 0.0, 1e-6);
    // The window hugs: some corner comes within a tenth of the border on each side.
    glm::dvec2 low(1.0);
    glm::dvec2 high(-1.0);
    for (const int i : frusta.GetCasters())
    {
      for (const auto& corner : scene.Casters.Get().at(i).Corners)
      {
        const glm::dvec4 clip = views.at(0).SWCToClip * glm::dvec4(corner, 1.0);
        low = glm::min(low, glm::dvec2(clip) / clip.w);
        high = glm::max(high, glm::dvec2(clip) / clip.w);
      }
    }
    CHECK(low.x < -0.9 && low.y < -0.9 && high.x > 0.9 && high.y > 0.9);
  }
}

//------------------------------------------------------------------------------
// w is the distance along the axis; z rises with it; near the window's borders nothing is lost.
void TestClipSpace()
{
  Scene scene;
  scene.AddSphere(glm::dvec3(0.0), 1.0);
  scene.SetLight(glm::dvec3(0.0, 0.0, 5.0), glm::dvec3(0.0));
  scene.Light->SetShapeToPoint();
  scene.Update();
  const auto views = scene.GetFrusta().GetViews(scene.GetCentre());
  CHECK_EQUAL(views.size(), std::size_t(1));
  const glm::dvec3 origin = scene.Casters.GetOrigin();
  double last = -2.0;
  for (double z = 1.0; z >= -1.0; z -= 0.25)
  {
    const glm::dvec4 clip = views.at(0).SWCToClip * glm::dvec4(glm::dvec3(0, 0, z) - origin, 1.0);
    CHECK_NEAR(clip.w, 5.0 - z, 1e-9);
    CHECK(clip.z / clip.w > last);
    last = clip.z / clip.w;
  }
}

//------------------------------------------------------------------------------
// A floor under everything is left out, whatever its size: 200 units widen no window.
void TestHugeFloor()
{
  double windows[2];
  const double sides[2] = { 4.0, 200.0 };
  for (int i = 0; i < 2; ++i)
  {
    Scene scene;
    scene.AddBox(glm::dvec3(0.0, 0.0, 0.5), 1.0); // stands on it
    scene.AddFloor(glm::dvec3(0.0), sides[i]);
    scene.SetLight(glm::dvec3(2.0, 1.0, 5.0), glm::dvec3(0.0));
    scene.Update();
    const vtkLightFrusta frusta = scene.GetFrusta();
    CHECK_EQUAL(frusta.GetCasters().size(), std::size_t(1));
    const auto views = frusta.GetViews(scene.GetCentre());
    CHECK_EQUAL(views.size(), std::size_t(1));
    windows[i] = GetWindow(views.at(0));
  }
  CHECK_NEAR(windows[1] / windows[0], 1.0, 1e-9);
}

//------------------------------------------------------------------------------
// A huge floor that does shadow something counts, but only where that something is.
void TestFloorOverSomething()
{
  Scene scene;
  scene.AddBox(glm::dvec3(0.0, 0.0, 0.5), 1.0);
  vtkActor* floor = scene.AddFloor(glm::dvec3(0.0), 200.0);
  vtkActor* cellar = scene.AddBox(glm::dvec3(0.5, 0.0, -2.0), 1.0);
  scene.SetLight(glm::dvec3(0.0, 0.0, 8.0), glm::dvec3(0.0));
  scene.Light->SetShapeToPoint();
  scene.Update();
  const vtkLightFrusta frusta = scene.GetFrusta();
  CHECK_EQUAL(frusta.GetCasters().size(), std::size_t(3));
  const auto views = frusta.GetViews(scene.GetCentre());
  CHECK_EQUAL(views.size(), std::size_t(1));
  CHECK(GetWindow(views.at(0)) < 0.2); // the whole floor would take a window of 600
  for (const auto& corner : scene.Casters.Get().at(0).Corners)
  {
    CHECK(IsInside(views.at(0), corner, 0.0));
  }
  // Each place of the floor that the light's rays to the cellar meet is in it.
  for (const auto& corner : scene.Casters.Get().at(2).Corners)
  {
    const glm::dvec3 light = scene.GetCentre() - scene.Casters.GetOrigin();
    const double t = light.z / (light.z - corner.z);
    const glm::dvec3 onFloor =
      light + t * (corner - light) + glm::dvec3(0.0, 0.0, -scene.Casters.GetOrigin().z) * t;
    CHECK(IsInside(views.at(0), onFloor, 0.0));
  }

  // A prop that only receives needs the floor as well.
  vtkShadowTags::SetCasting(cellar, false);
  scene.Update();
  const auto counting = scene.GetFrusta().GetCasters();
  CHECK_EQUAL(counting.size(), std::size_t(2));
  CHECK(scene.Casters.Get().at(counting.at(1)).Prop == floor);
  CHECK_EQUAL(scene.Casters.GetReceivers().size(), std::size_t(1));

  // Seen from below it is the cellar that lies in front: the box above is behind the floor.
  vtkShadowTags::SetCasting(cellar, true);
  scene.SetLight(glm::dvec3(0.0, 0.0, -8.0), glm::dvec3(0.0));
  scene.Update();
  CHECK_EQUAL(scene.GetFrusta().GetCasters().size(), std::size_t(3));
}

//------------------------------------------------------------------------------
// Nothing that can shadow anything: no casters, no views.
void TestNothing()
{
  Scene scene;
  scene.AddFloor(glm::dvec3(0.0), 10.0);
  scene.SetLight(glm::dvec3(0.0, 0.0, 8.0), glm::dvec3(0.0));
  scene.Update();
  const vtkLightFrusta frusta = scene.GetFrusta();
  CHECK(frusta.GetCasters().empty());
  CHECK(frusta.GetViews(scene.GetCentre()).empty());

  Scene empty;
  empty.SetLight(glm::dvec3(0.0, 0.0, 8.0), glm::dvec3(0.0));
  empty.Update();
  CHECK(empty.GetFrusta().GetViews(empty.GetCentre()).empty());
}

//------------------------------------------------------------------------------
// A light in the plane of a flat caster: the caster stays in.
void TestEdgeOn()
{
  Scene scene;
  scene.AddFloor(glm::dvec3(0.0), 2.0);
  scene.AddBox(glm::dvec3(-4.0, 0.0, 0.0), 1.0);
  scene.SetLight(glm::dvec3(5.0, 0.0, 0.0), glm::dvec3(0.0));
  scene.Light->SetShapeToPoint();
  scene.Update();
  CHECK_EQUAL(scene.GetFrusta().GetCasters().size(), std::size_t(2));
  CHECK(!GetHoldingViews(scene).empty());
}

//------------------------------------------------------------------------------
// Among the casters: a view into each direction that holds some, and none into the others.
void TestAmongCasters()
{
  const glm::dvec3 origin(3.0, -2.0, 1.0);
  Scene scene;
  scene.AddBox(origin + glm::dvec3(4.0, 0.0, 0.0), 1.0);
  scene.AddBox(origin + glm::dvec3(-4.0, 0.0, 0.0), 1.0);
  scene.AddBox(origin + glm::dvec3(0.0, 5.0, 0.0), 1.0);
  scene.SetLight(origin, origin + glm::dvec3(0.0, 0.0, -1.0));
  scene.Light->SetShapeToPoint();
  scene.Update();
  CHECK_EQUAL(scene.GetFrusta().GetCasters().size(), std::size_t(3));
  CHECK_EQUAL(GetHoldingViews(scene).size(), std::size_t(3));

  // A box in the diagonal is cut by two faces, and none of it is counted twice.
  scene.AddBox(origin + glm::dvec3(3.0, 3.0, 0.0), 1.0);
  scene.Update();
  const auto views = GetHoldingViews(scene);
  CHECK_EQUAL(views.size(), std::size_t(3));
  const vtkShadowCaster& diagonal = scene.Casters.Get().at(3);
  for (const double x : { 0.1, 0.3, -0.3 })
  {
    const glm::dvec3 p(diagonal.MeshToSWC * glm::dvec4(x, 0.15, 0.2, 1.0));
    int seen = 0;
    for (const auto& view : views)
    {
      seen += IsInside(view, p, 0.0) ? 1 : 0;
    }
    CHECK_EQUAL(seen, 1);
  }

  // All around it, and inside a caster: no more than six, and all is held.
  scene.AddBox(origin + glm::dvec3(0.0, 0.0, 4.0), 1.0);
  scene.AddBox(origin + glm::dvec3(0.0, 0.0, -4.0), 1.0);
  scene.AddBox(origin + glm::dvec3(0.0, -4.0, 0.0), 1.0);
  scene.AddSphere(origin, 20.0);
  scene.Update();
  CHECK_EQUAL(GetHoldingViews(scene).size(), std::size_t(6));
}

//------------------------------------------------------------------------------
// A spot light sees no further than its cone.
void TestCone()
{
  Scene scene;
  scene.AddBox(glm::dvec3(0.0), 1.0);
  scene.AddBox(glm::dvec3(20.0, 0.0, 0.0), 1.0);
  scene.SetLight(glm::dvec3(0.0, 0.0, 5.0), glm::dvec3(0.0));
  scene.Light->SetShapeToPoint();
  scene.Light->SetConeAngle(20.0);
  scene.Update();
  const auto views = scene.GetFrusta().GetViews(scene.GetCentre());
  CHECK_EQUAL(views.size(), std::size_t(1));
  CHECK(glm::length(views.at(0).WindowX) < 2.0 * std::tan(20.0 / 57.29578) * 1.1);
  for (const auto& corner : scene.Casters.Get().at(0).Corners)
  {
    CHECK(IsInside(views.at(0), corner, 0.0));
  }
  // Nothing in the cone, nothing to draw.
  scene.SetLight(glm::dvec3(0.0, 0.0, 5.0), glm::dvec3(0.0, 0.0, 9.0));
  scene.Update();
  CHECK(scene.GetFrusta().GetViews(scene.GetCentre()).empty());
}

//------------------------------------------------------------------------------
// Views for look-ups around a point show as far beyond a border as the light's size carries them, and
// tell at which sides casters go on that they do not show; of a light without size they are the same.
void TestNeighbours()
{
  Scene scene;
  scene.AddBox(glm::dvec3(0.0), 1.0);
  scene.AddBox(glm::dvec3(2.2, 0.0, 0.0), 1.0);
  scene.SetLight(glm::dvec3(0.0, 0.0, 5.0), glm::dvec3(0.0));
  scene.Light->SetShapeToSphere();
  scene.Light->SetConeAngle(20.0);
  for (const double radius : { 0.0, 0.3 })
  {
    scene.Light->SetRadius(radius);
    scene.Update();
    const auto plain = scene.GetFrusta().GetViews(scene.GetCentre());
    const auto around = scene.GetFrusta(true).GetViews(scene.GetCentre());
    CHECK_EQUAL(around.size(), std::size_t(1));
    // The right one of the boxes reaches out of the window: at one of its sides.
    const auto& cut = around.at(0).Cut;
    CHECK_EQUAL(std::count(cut.begin(), cut.end(), true), 1);
    if (radius == 0.0)
    {
      CHECK(around.at(0).SWCToClip == plain.at(0).SWCToClip);
      continue;
    }
    // Its near side is 4.1 away: the light's centre sees that of a receiver within the cone's border.
    const double tangent = std::tan(20.0 / 57.29578) + radius / 4.1;
    CHECK(IsInside(around.at(0), glm::dvec3(4.5 * std::min(tangent, 0.6), 0.0, 0.5), 0.0));
    CHECK(!IsInside(plain.at(0), glm::dvec3(4.5 * std::min(tangent, 0.6), 0.0, 0.5), 0.0));
  }

  // Among casters: faces of a cube overlap, so that what lies across an edge is in both.
  Scene cube;
  cube.AddBox(glm::dvec3(3.0, 3.0, 0.0), 1.0);
  cube.AddBox(glm::dvec3(-3.0, 0.0, 0.0), 1.0);
  cube.AddBox(glm::dvec3(0.0, -3.0, 0.0), 1.0);
  cube.SetLight(glm::dvec3(0.0), glm::dvec3(0.0, 0.0, -1.0));
  cube.Light->SetShapeToSphere();
  cube.Light->SetRadius(0.5);
  cube.Update();
  int seen = 0;
  for (const auto& view : cube.GetFrusta(true).GetViews(cube.GetCentre()))
  {
    CHECK(view.Face);
    seen += IsInside(view, glm::dvec3(3.1, 2.9, 0.2), 0.0) ? 1 : 0;
  }
  CHECK_EQUAL(seen, 2);

  // A filter's width must not change as the scene turns.
  double extents[2];
  for (int i = 0; i < 2; ++i)
  {
    Scene turned;
    vtkActor* box = turned.AddBox(glm::dvec3(1.0, 2.0, 0.5), 1.0);
    box->RotateWXYZ(50.0 * i, 1.0, 2.0, 3.0);
    turned.SetLight(glm::dvec3(0.0, 0.0, 9.0), glm::dvec3(0.0));
    turned.Update();
    extents[i] = turned.GetFrusta().GetExtent();
  }
  CHECK_NEAR(extents[0], std::sqrt(3.0), 1e-6);
  CHECK_NEAR(extents[1], extents[0], 1e-6);
}

//------------------------------------------------------------------------------
void TestDirectional()
{
  Scene scene;
  scene.AddSphere(glm::dvec3(0.0, 0.0, 1.0), 0.5);
  scene.AddBox(glm::dvec3(3.0, 1.0, 0.5), 1.0);
  vtkActor* floor = scene.AddFloor(glm::dvec3(0.0), 200.0);
  scene.SetLight(glm::dvec3(1.0, 2.0, 3.0), glm::dvec3(0.0));
  scene.Light->PositionalOff();
  scene.Light->SetAngularDiameter(2.0);
  scene.Update();
  CHECK(scene.Gathered.IsDirectional());
  const vtkLightFrusta frusta = scene.GetFrusta();
  CHECK_EQUAL(frusta.GetCasters().size(), std::size_t(2));
  auto places = scene.Gathered.GetExtremes();
  places.push_back(scene.GetCentre());
  for (const auto& place : places)
  {
    const glm::dvec3 towards = glm::normalize(place);
    const auto views = frusta.GetViews(towards);
    CHECK_EQUAL(views.size(), std::size_t(1));
    for (const int i : frusta.GetCasters())
    {
      CHECK(scene.Casters.Get().at(i).Prop != floor);
      for (const auto& corner : scene.Casters.Get().at(i).Corners)
      {
        CHECK(IsInside(views.at(0), corner, Border));
        CHECK_NEAR((views.at(0).SWCToClip * glm::dvec4(corner, 1.0)).w, 1.0, 1e-12);
      }
    }
    // z rises away from the light.
    const glm::dvec4 near = views.at(0).SWCToClip * glm::dvec4(towards, 1.0);
    const glm::dvec4 far = views.at(0).SWCToClip * glm::dvec4(-towards, 1.0);
    CHECK(near.z < far.z);
    // Six units of scene in a window of ten at most, floor or no floor.
    CHECK(GetWindow(views.at(0)) < 100.0);
  }
}

//------------------------------------------------------------------------------
// What casts nothing counts nowhere: neither triangles of no area at their actor's own origin, nor a
// prop whose place is no number.
void TestNothingCounts()
{
  const glm::dvec3 far(1e7, -1e7, 1e6);
  Scene scene;
  scene.AddBox(far, 1.0);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const vtkIdType ids[] = { points->InsertNextPoint(0.0, 0.0, 0.0),
    points->InsertNextPoint(0.0, 0.0, 0.0), points->InsertNextPoint(0.0, 0.0, 0.0) };
  cells->InsertNextCell(3, ids);
  vtkNew<vtkPolyData> nothing;
  nothing->SetPoints(points);
  nothing->SetPolys(cells);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(nothing);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(producer->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  scene.AddBox(glm::dvec3(std::nan(""), 0.0, 0.0), 1.0);
  scene.SetLight(far + glm::dvec3(1.0, 2.0, 6.0), far);
  scene.Update();
  CHECK_EQUAL(scene.Casters.Get().size(), std::size_t(1));
  CHECK_EQUAL(scene.Casters.GetReceivers().size(), std::size_t(0));
  CHECK_EQUAL(scene.Casters.GetNumberOfDroppedTriangles(), std::size_t(1));
  CHECK_NEAR(scene.Casters.GetSize(), std::sqrt(3.0), 1e-6);
  CHECK_NEAR(glm::length(scene.Casters.GetOrigin() - far), 0.0, 1e-6);
}

/** The range of some casters' boxes on a directional view's plane, as a window with borders. */
glm::dvec2 GetHull(const Scene& scene, const vtkLightView& view, const std::vector<int>& casters)
{
  glm::dvec2 low(std::numeric_limits<double>::max());
  glm::dvec2 high(std::numeric_limits<double>::lowest());
  for (const int i : casters)
  {
    for (const auto& corner : scene.Casters.Get().at(i).Corners)
    {
      const glm::dvec2 p(glm::dot(corner, glm::normalize(view.WindowX)),
        glm::dot(corner, glm::normalize(view.WindowY)));
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  return high - low;
}

//------------------------------------------------------------------------------
// Any number of walls over a ground a hundred times as large: the ground is left out, and a window is
// never larger than what stands on it.
void TestManyWalls()
{
  Scene scene;
  vtkActor* ground = scene.AddFloor(glm::dvec3(0.0), 600.0);
  scene.AddBox(glm::dvec3(0.0, 0.0, 0.5), 1.0);
  scene.SetLight(glm::dvec3(3.0, -4.0, 8.0), glm::dvec3(0.0));
  scene.Light->PositionalOff();
  glm::dvec2 last(0.0);
  for (int n = 0; n < 300; ++n)
  {
    scene.Update();
    const vtkLightFrusta frusta = scene.GetFrusta();
    for (const int i : frusta.GetCasters())
    {
      CHECK(scene.Casters.Get().at(i).Prop != ground);
    }
    const auto view = frusta.GetViews(scene.GetCentre()).at(0);
    const glm::dvec2 window =
      glm::dvec2(glm::length(view.WindowX), glm::length(view.WindowY)) / (1.0 + 2.0 * Border);
    const glm::dvec2 hull = GetHull(scene, view, frusta.GetCasters());
    CHECK(window.x < hull.x + 1e-9 && window.y < hull.y + 1e-9);
    CHECK(n < 2 || (window.x < last.x + 0.2 && window.y < last.y + 0.2));
    last = window;
    vtkActor* wall = scene.AddFloor(glm::dvec3(-1.5 + 0.01 * n, 1.5, 0.2), 0.1);
    wall->RotateX(7.0 * n); // no two alike
  }
}

//------------------------------------------------------------------------------
// A ground of two thousand tiles, level or not, counts no more than one in a piece.
void TestTiles()
{
  for (const double slope : { 0.0, 20.0 })
  {
    Scene scene;
    vtkNew<vtkTransform> transform;
    transform->RotateX(slope);
    for (int i = 0; i < 2025; ++i)
    {
      scene.AddFloor(glm::dvec3(10.0 * (i % 45 - 22), 10.0 * (i / 45 - 22), 0.0), 10.0)
        ->SetUserTransform(transform);
    }
    scene.AddBox(glm::dvec3(0.0, 0.0, 0.5), 1.0)->SetUserTransform(transform);
    scene.SetLight(glm::dvec3(2.0, 1.0, 5.0), glm::dvec3(0.0));
    scene.Light->PositionalOff();
    scene.Update();
    const auto views = scene.GetFrusta().GetViews(scene.GetCentre());
    CHECK_EQUAL(views.size(), std::size_t(1));
    CHECK(GetWindow(views.at(0)) < 4.0);
  }
}

//------------------------------------------------------------------------------
// What moves far away moves no texel: groups with room between them have views of their own. Nearby
// there is one view.
void TestGroups()
{
  for (const bool positional : { false, true })
  {
    Scene scene;
    scene.AddFloor(glm::dvec3(0.0), 100.0);
    scene.AddBox(glm::dvec3(0.0, 0.0, 1.0), 2.0);
    vtkActor* ball = scene.AddSphere(glm::dvec3(0.0), 0.5);
    scene.SetLight(glm::dvec3(6.0, -8.0, 20.0), glm::dvec3(0.0));
    scene.Light->SetShapeToPoint();
    scene.Light->SetPositional(positional);
    glm::dmat4 still(0.0);
    for (int i = 0; i < 12; ++i)
    {
      ball->SetPosition(9.0 + 2.0 * std::cos(0.5 * i), 3.0 * std::sin(0.5 * i), 1.0 + 0.1 * i);
      scene.Update();
      const auto views = scene.GetSteadyFrusta().GetViews(scene.GetCentre());
      CHECK_EQUAL(views.size(), std::size_t(2));
      const vtkLightView& first = views.at(views.at(0).Casters.at(0) == 1 ? 0 : 1);
      CHECK_EQUAL(first.Casters.size(), std::size_t(1));
      CHECK_EQUAL(first.Casters.at(0), 1);
      CHECK(i == 0 || first.SWCToClip == still);
      still = first.SWCToClip;
      for (const auto& view : views)
      {
        int inside = 0;
        for (const int other : { 1, 2 })
        {
          for (const auto& corner : scene.Casters.Get().at(other).Corners)
          {
            inside += IsInside(view, corner, 0.0) ? 1 : 0;
          }
        }
        CHECK_EQUAL(inside, 8); // its own
      }
    }
    ball->SetPosition(2.0, 0.0, 1.0);
    scene.Update();
    CHECK_EQUAL(scene.GetSteadyFrusta().GetViews(scene.GetCentre()).size(), std::size_t(1));
  }
}

//------------------------------------------------------------------------------
// A window around several casters takes steps: what moves in it moves the others' texels by whole ones,
// but where its size steps, which is seldom. No step is more than 9 %, and one caster alone is hugged.
void TestSteps()
{
  constexpr int Resolution = 512;
  for (const bool positional : { false, true })
  {
    Scene scene;
    scene.AddBox(glm::dvec3(0.0, 0.0, 1.0), 2.0);
    scene.SetLight(glm::dvec3(6.0, -8.0, 20.0), glm::dvec3(0.0));
    scene.Light->SetShapeToPoint();
    scene.Light->SetPositional(positional);
    scene.Update();
    const auto alone = scene.GetSteadyFrusta(Resolution).GetViews(scene.GetCentre()).at(0);
    vtkActor* ball = scene.AddSphere(glm::dvec3(0.0), 0.3);
    int steps = 0;
    double sides[2] = { 0.0, 0.0 };
    double places[2] = { 0.0, 0.0 };
    for (int i = 0; i < 200; ++i)
    {
      const double angle = 0.01 * i;
      ball->SetPosition(1.8 * std::cos(angle), 1.8 * std::sin(angle), 1.0 + 0.002 * i);
      scene.Update();
      const auto views = scene.GetSteadyFrusta(Resolution).GetViews(scene.GetCentre());
      CHECK_EQUAL(views.size(), std::size_t(1));
      const auto& view = views.at(0);
      glm::dvec2 low(1.0);
      glm::dvec2 high(-1.0);
      for (const auto& caster : scene.Casters.Get())
      {
        for (const auto& corner : caster.Corners)
        {
          CHECK(IsInside(view, corner, 3.0 / Resolution));
          const glm::dvec4 clip = view.SWCToClip * glm::dvec4(corner, 1.0);
          low = glm::min(low, glm::dvec2(clip) / clip.w);
          high = glm::max(high, glm::dvec2(clip) / clip.w);
        }
      }
      const double least = 2.0 / std::exp2(0.125) - 8.0 / Resolution;
      CHECK(high.x - low.x > least && high.y - low.y > least);
      // A fixed point in texels.
      const glm::dvec4 clip =
        view.SWCToClip * glm::dvec4(scene.Casters.Get().at(0).Corners[0], 1.0);
      for (int axis = 0; axis < 2; ++axis)
      {
        const double side = glm::length(axis == 0 ? view.WindowX : view.WindowY);
        const double place = 0.5 * Resolution * clip[axis] / clip.w;
        const double moved = place - places[axis];
        const bool same = std::abs(side / sides[axis] - 1.0) < 1e-9;
        steps += same ? 0 : 1;
        CHECK(!same || std::abs(moved - std::round(moved)) < 1e-6);
        sides[axis] = side;
        places[axis] = place;
      }
    }
    CHECK(steps <= 16); // not once a frame
    // One of no size within the other's box takes nothing from it.
    ball->SetScale(1e-3);
    ball->SetPosition(0.0, 0.0, 1.0);
    scene.Update();
    const auto views = scene.GetSteadyFrusta(Resolution).GetViews(scene.GetCentre());
    CHECK_NEAR(GetWindow(views.at(0)) / GetWindow(alone), 1.0, 1e-9);
  }
}

//------------------------------------------------------------------------------
// A sky or a room around the light and everything else can shadow nothing: it is left out. One that is
// not closed stays, and nothing near the light is clipped for its sake.
void TestShell()
{
  const auto build = [](Scene& scene)
  {
    scene.AddBox(glm::dvec3(0.0, 0.0, 0.5), 1.0);
    scene.AddFloor(glm::dvec3(0.0), 6.0);
    scene.SetLight(glm::dvec3(0.5, 1.0, 3.0), glm::dvec3(0.0));
    scene.Light->SetShapeToSphere();
    scene.Light->SetRadius(0.2);
    scene.Update();
  };
  Scene open;
  build(open);
  const auto expected = open.GetFrusta().GetViews(open.GetCentre());
  CHECK_EQUAL(expected.size(), std::size_t(1));
  for (const double size : { 10.0, 1e6 })
  {
    for (const bool room : { false, true })
    {
      Scene scene;
      vtkActor* shell =
        room ? scene.AddBox(glm::dvec3(0.0), 2.0 * size) : scene.AddSphere(glm::dvec3(0.0), size);
      build(scene);
      const vtkLightFrusta frusta = scene.GetFrusta();
      CHECK_EQUAL(frusta.GetCasters().size(), std::size_t(2)); // the floor shadows the shell
      for (const int i : frusta.GetCasters())
      {
        CHECK(scene.Casters.Get().at(i).Prop != shell);
      }
      CHECK_NEAR(frusta.GetExtent(), open.GetFrusta().GetExtent(), 1e-6);
      // What stands out of it keeps it in.
      scene.AddBox(glm::dvec3(size, 0.0, 0.0), 1.0);
      scene.Update();
      CHECK_EQUAL(scene.GetFrusta().GetCasters().size(), std::size_t(4));
    }
    Scene dome;
    vtkNew<vtkSphereSource> most;
    most->SetRadius(size);
    most->SetEndPhi(120.0);
    dome.AddSource(most);
    build(dome);
    const auto views = dome.GetFrusta().GetViews(dome.GetCentre());
    CHECK(dome.GetFrusta().GetCasters().size() == std::size_t(3));
    for (std::size_t i = 1; i < 3; ++i)
    {
      for (const auto& corner : dome.Casters.Get().at(i).Corners)
      {
        CHECK(std::any_of(views.begin(), views.end(),
          [&corner](const vtkLightView& view) { return IsInside(view, corner, 0.0); }));
      }
    }
  }
}
}

//------------------------------------------------------------------------------
int TestLightFrusta(int, char*[])
{
  TestCornersInside(glm::dvec3(0.0));
  TestCornersInside(glm::dvec3(1e7, -1e7, 1e6));
  TestClipSpace();
  TestHugeFloor();
  TestFloorOverSomething();
  TestNothing();
  TestEdgeOn();
  TestAmongCasters();
  TestCone();
  TestNeighbours();
  TestDirectional();
  TestNothingCounts();
  TestManyWalls();
  TestTiles();
  TestGroups();
  TestSteps();
  TestShell();
  return ShadowTesting::Result();
}
