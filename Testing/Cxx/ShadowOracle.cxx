// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowOracle.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
ShadowOracle::ShadowOracle(ShadowStage& stage, const std::set<vtkActor*>& ignored)
{
  vtkRenderer* renderer = stage.Renderer;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (!actor || !actor->GetVisibility())
    {
      continue;
    }
    actor->GetMapper()->Update();
    auto* polygons = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
    Body body{ actor, ignored.count(actor) == 0, true, glm::dvec3(0.0), 0.0, {} };
    std::vector<glm::dvec3> points;
    for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
    {
      double p[4] = { 0.0, 0.0, 0.0, 1.0 };
      polygons->GetPoint(i, p);
      actor->GetMatrix()->MultiplyPoint(p, p);
      points.emplace_back(p[0], p[1], p[2]);
      body.Centre += points.back() / static_cast<double>(polygons->GetNumberOfPoints());
    }
    vtkNew<vtkIdList> ids;
    vtkCellArray* cells = polygons->GetPolys();
    for (cells->InitTraversal(); cells->GetNextCell(ids);)
    {
      for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k)
      {
        const glm::dvec3 a = points[ids->GetId(0)];
        body.Triangles.push_back({ a, points[ids->GetId(k - 1)] - a, points[ids->GetId(k)] - a });
      }
    }
    for (const auto& p : points)
    {
      body.Radius = std::max(body.Radius, 1.000001 * glm::length(p - body.Centre));
    }
    for (const auto& triangle : body.Triangles)
    {
      const glm::dvec3 normal = glm::cross(body.Triangles.front().AB, body.Triangles.front().AC);
      const glm::dvec3 from = triangle.A - body.Triangles.front().A;
      for (const auto& p : { from, from + triangle.AB, from + triangle.AC })
      {
        body.Flat =
          body.Flat && std::abs(glm::dot(normal, p)) <= 1e-6 * body.Radius * glm::length(normal);
      }
    }
    this->Size = std::max(this->Size, body.Radius);
    this->Bodies.push_back(std::move(body));
  }

  int origin[2];
  renderer->GetTiledSizeAndOrigin(&this->Width, &this->Height, &origin[0], &origin[1]);
  vtkCamera* camera = renderer->GetActiveCamera();
  glm::dvec3 eye, focus, up;
  camera->GetPosition(&eye.x);
  camera->GetFocalPoint(&focus.x);
  camera->GetViewUp(&up.x);
  const glm::dvec3 ahead = glm::normalize(focus - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, up));
  const glm::dvec3 above = glm::cross(right, ahead);
  const double tangent = std::tan(glm::radians(0.5 * camera->GetViewAngle()));
  this->Pixels.resize(static_cast<std::size_t>(this->Width) * this->Height);
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      const double sx = (2.0 * (x + 0.5) - this->Width) / this->Height;
      const double sy = (2.0 * (y + 0.5) - this->Height) / this->Height;
      const glm::dvec3 aside = sx * right + sy * above;
      const bool parallel = camera->GetParallelProjection();
      const glm::dvec3 from = parallel ? eye + camera->GetParallelScale() * aside : eye;
      const glm::dvec3 direction = parallel ? ahead : ahead + tangent * aside;
      SurfacePoint& pixel = this->Pixels[static_cast<std::size_t>(y) * this->Width + x];
      double nearest = std::numeric_limits<double>::max();
      this->ForEachHit(from, direction,
        [&](const Body& body, const Triangle& triangle, double t)
        {
          if (t < nearest)
          {
            nearest = t;
            const glm::dvec3 normal = glm::normalize(glm::cross(triangle.AB, triangle.AC));
            pixel = { body.Actor, from + t * direction,
              glm::dot(normal, direction) < 0.0 ? normal : -normal };
          }
          return false;
        });
    }
  }
}

//------------------------------------------------------------------------------
template <typename Visit>
void ShadowOracle::ForEachHit(
  const glm::dvec3& origin, const glm::dvec3& direction, Visit visit) const
{
  const double square = glm::dot(direction, direction);
  for (const auto& body : this->Bodies)
  {
    const glm::dvec3 centre = body.Centre - origin;
    const double along = glm::dot(centre, direction) / square;
    const glm::dvec3 off = centre - along * direction;
    if (glm::dot(off, off) > body.Radius * body.Radius)
    {
      continue;
    }
    for (const auto& triangle : body.Triangles)
    {
      // Moeller and Trumbore.
      const glm::dvec3 p = glm::cross(direction, triangle.AC);
      const double determinant = glm::dot(triangle.AB, p);
      const glm::dvec3 s = origin - triangle.A;
      const double u = glm::dot(s, p) / determinant;
      const glm::dvec3 q = glm::cross(s, triangle.AB);
      const double v = glm::dot(direction, q) / determinant;
      const double t = glm::dot(triangle.AC, q) / determinant;
      if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && visit(body, triangle, t))
      {
        return;
      }
    }
  }
}

//------------------------------------------------------------------------------
bool ShadowOracle::IsBlocked(const glm::dvec3& from, const glm::dvec3& to, bool directional) const
{
  bool blocked = false;
  this->ForEachHit(from, directional ? to : to - from,
    [&](const Body& body, const Triangle&, double t)
    {
      blocked = body.Casts && (directional || t < 1.0);
      return blocked;
    });
  return blocked;
}

//------------------------------------------------------------------------------
bool ShadowOracle::IsBlocked(const SurfacePoint& from, const glm::dvec3& to, bool directional) const
{
  return this->IsBlocked(from.Position + 1e-9 * this->Size * from.Normal, to, directional);
}

//------------------------------------------------------------------------------
Visibility ShadowOracle::GetHard(vtkLight* light, const std::string& technique) const
{
  Visibility result;
  result.Width = this->Width;
  result.Height = this->Height;
  glm::dvec3 position, focus;
  light->GetTransformedPosition(&position.x);
  light->GetTransformedFocalPoint(&focus.x);
  const bool planar = !technique.empty() && ShadowStage::Describe(technique).Traits.PlanarReceivers;
  for (const auto& pixel : this->Pixels)
  {
    bool blocked =
      pixel.Actor && (light->GetPositional() ? this->IsBlocked(pixel, position)
                                             : this->IsBlocked(pixel, position - focus, true));
    if (planar && pixel.Actor && !this->GetBody(pixel)->Flat)
    {
      const glm::dvec3 towards = position - (light->GetPositional() ? pixel.Position : focus);
      blocked = this->GetBody(pixel)->Casts && glm::dot(pixel.Normal, towards) < 0.0;
    }
    result.V.push_back(blocked ? 0.0f : 1.0f);
    result.Mask.push_back(pixel.Actor ? 1 : 0);
  }
  return result;
}

//------------------------------------------------------------------------------
const ShadowOracle::Body* ShadowOracle::GetBody(const SurfacePoint& pixel) const
{
  const auto body = std::find_if(this->Bodies.begin(), this->Bodies.end(),
    [&pixel](const Body& b) { return b.Actor == pixel.Actor; });
  return body == this->Bodies.end() ? nullptr : &*body;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> ShadowOracle::GetFlatMask() const
{
  std::vector<unsigned char> mask;
  for (const auto& pixel : this->Pixels)
  {
    const Body* body = this->GetBody(pixel);
    mask.push_back(body && body->Flat);
  }
  return mask;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> ShadowOracle::GetMask(vtkActor* actor) const
{
  std::vector<unsigned char> mask;
  for (const auto& pixel : this->Pixels)
  {
    mask.push_back(pixel.Actor == actor);
  }
  return mask;
}

//------------------------------------------------------------------------------
std::vector<unsigned char> ShadowOracle::GetInner(int pixels) const
{
  std::vector<unsigned char> inner(this->Pixels.size(), 0);
  for (int y = pixels; y < this->Height - pixels; ++y)
  {
    for (int x = pixels; x < this->Width - pixels; ++x)
    {
      bool same = true;
      for (int dy = -pixels; dy <= pixels; ++dy)
      {
        for (int dx = -pixels; dx <= pixels; ++dx)
        {
          same = same && this->Pixels[(y + dy) * this->Width + x + dx].Actor ==
                           this->Pixels[y * this->Width + x].Actor;
        }
      }
      inner[y * this->Width + x] = same;
    }
  }
  return inner;
}
