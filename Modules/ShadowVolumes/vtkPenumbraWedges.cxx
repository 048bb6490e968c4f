// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPenumbraWedges.h"

#include "vtkPenumbraCoverFS.h"
#include "vtkPenumbraEmission.h"
#include "vtkPenumbraLightFS.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
using Shape = vtkShadowLight::Shape;

/** What the box around receivers is larger by: a share of its own size. */
constexpr double Slack = 1e-5;

template <typename Vector>
void Append(std::vector<float>& values, const Vector& vector)
{
  for (int c = 0; c < Vector::length(); ++c)
  {
    values.push_back(static_cast<float>(vector[c]));
  }
}
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> vtkPenumbraWedges::GetReceivers(const vtkShadowCasters& casters)
{
  constexpr double most = std::numeric_limits<double>::max();
  glm::dvec3 low(most);
  glm::dvec3 high(-most);
  const auto add = [&](const std::array<glm::dvec3, 8>& corners)
  {
    for (const auto& corner : corners)
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
  };
  std::for_each(casters.GetReceivers().begin(), casters.GetReceivers().end(), add);
  for (const auto& caster : casters.Get())
  {
    if (caster.Receives)
    {
      add(caster.Corners);
    }
  }
  if (!(low.x <= high.x))
  {
    return {};
  }
  const double slack = Slack * glm::length(high - low);
  return { { 1.0, 0.0, 0.0, slack - low.x }, { -1.0, 0.0, 0.0, high.x + slack },
    { 0.0, 1.0, 0.0, slack - low.y }, { 0.0, -1.0, 0.0, high.y + slack },
    { 0.0, 0.0, 1.0, slack - low.z }, { 0.0, 0.0, -1.0, high.z + slack } };
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::Start(const vtkShadowFrame& frame, bool ofEdges)
{
  this->OfEdges = ofEdges;
  this->Parts.clear();
  this->Values.clear();
  this->Wedges = this->Culled = 0;
  this->Receivers = GetReceivers(*frame.Casters);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::StartPart(int caster)
{
  const std::size_t first =
    this->Parts.empty() ? 0 : this->Parts.back().First + this->Parts.back().Count;
  this->Parts.push_back({ caster, first, 0, 0 });
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::AddWedge(const vtkShadowWedgeEdge& edge, vtkShadowWedge::Bounds bounds)
{
  vtkShadowWedge wedge;
  if (!this->Receivers.empty())
  {
    wedge.Bound(this->Light, edge.Ends, bounds, this->Receivers);
  }
  if (wedge.Faces.empty() && !wedge.Whole)
  {
    ++this->Culled;
    return;
  }
  std::size_t corners = 0;
  const auto add = [&](const glm::dvec3& place, bool ofPicture)
  {
    Append(this->Values, glm::dvec4(place, ofPicture ? 1.0 : 0.0));
    Append(this->Values, edge.Ends[0]);
    Append(this->Values, edge.Ends[1]);
    Append(this->Values, edge.Plane);
    Append(this->Values, edge.Width);
    this->Values.push_back(static_cast<float>(edge.Times));
    if (this->OfEdges)
    {
      Append(this->Values, edge.Faces[0]);
      Append(this->Values, edge.Faces[1]);
    }
    ++corners;
  };
  for (const auto& face : wedge.Faces)
  {
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
    {
      for (const std::size_t i : { std::size_t(0), k, k + 1 })
      {
        add(glm::dvec3(face[i]), false);
      }
    }
  }
  if (wedge.Whole)
  {
    // The picture, both ways round: one of them is seen from behind.
    for (const int i : { 0, 1, 2, 2, 1, 3, 0, 2, 1, 1, 2, 3 })
    {
      add({ i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, 0.0 }, true);
    }
  }
  ++this->Wedges;
  ++this->Parts.back().Wedges;
  this->Parts.back().Count += corners;
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::Upload()
{
  glBindVertexArray(0);
  std::vector<vtkShadowVertices::Attribute> attributes = { { "wedgeCornerSWC", 4 },
    { "wedgeFromSWC", 3 }, { "wedgeToSWC", 3 }, { "wedgePlaneSWC", 4 }, { "wedgeWidthSWC", 4 },
    { "wedgeTimes", 1 } };
  if (this->OfEdges)
  {
    attributes.push_back({ "wedgeFirstFaceSWC", 4 });
    attributes.push_back({ "wedgeSecondFaceSWC", 4 });
  }
  this->Vertices.Upload(this->Values, attributes);
  std::vector<float>().swap(this->Values);
  this->Receivers.clear();
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::MakeOfSilhouette(vtkShadowFrame& frame, vtkShadowWedge::Bounds bounds)
{
  this->Start(frame, false);
  const auto& lines = this->Lines.Get();
  for (const auto& part : this->Lines.GetParts())
  {
    const vtkShadowCaster& caster = frame.Casters->Get()[part.Caster];
    this->StartPart(part.Caster);
    for (std::size_t i = part.First; i < part.First + part.Count;)
    {
      vtkShadowWedgeEdge edge;
      edge.Ends[0] = vtkPenumbraLines::GetVertex(caster, lines[i]);
      edge.Ends[1] = vtkPenumbraLines::GetVertex(caster, lines[i + 1]);
      edge.SetPlane(this->Light);
      edge.Times = 0;
      for (const std::size_t same = i; i < part.First + part.Count && lines[i] == lines[same] &&
                                       lines[i + 1] == lines[same + 1];
           i += 2)
      {
        ++edge.Times;
      }
      if (edge.Plane != glm::dvec4(0.0))
      {
        this->AddWedge(edge, bounds);
      }
    }
  }
  this->Upload();
}

//------------------------------------------------------------------------------
int vtkPenumbraWedges::FindSide(const glm::dvec4& plane) const
{
  const double reach = this->Light.GetReach(glm::dvec3(plane));
  const double side = glm::dot(plane, this->Light.Place);
  // A hair more for the rounding of both.
  const double slack =
    1e-3 * reach + 1e-6 * (glm::length(glm::dvec3(this->Light.Place)) + std::abs(plane.w));
  return std::abs(side) <= reach + slack ? 0 : (side > 0.0 ? 1 : -1);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::AddEdges(
  const vtkShadowCaster& caster, const vtkShadowAdjacency& adjacency, vtkShadowWedge::Bounds bounds)
{
  const vtkShadowFacePlanes planes(caster, adjacency);
  std::vector<signed char> sides(adjacency.Planes.size());
  for (std::size_t f = 0; f < sides.size(); ++f)
  {
    sides[f] = static_cast<signed char>(this->FindSide(planes.Get(static_cast<std::uint32_t>(f))));
  }
  const int turn = planes.IsMirrored() ? -1 : 1;
  const auto faces = [&](std::uint32_t face) // the light's centre, as silhouettes tell
  { return glm::dot(planes.Get(face), this->Light.Place) > 0.0; };
  // Along the silhouette's line, which counts so often from the light's centre; no plane without
  // one.
  const auto add = [&](std::uint32_t from, std::uint32_t to, int ofCentre, int times,
                     const glm::dvec4& first, const glm::dvec4& second)
  {
    const bool reverse = turn * ofCentre < 0;
    vtkShadowWedgeEdge edge;
    edge.Ends[0] = vtkPenumbraLines::GetVertex(caster, reverse ? to : from);
    edge.Ends[1] = vtkPenumbraLines::GetVertex(caster, reverse ? from : to);
    edge.Times = reverse ? -turn * times : turn * times;
    edge.Faces[0] = first;
    edge.Faces[1] = second;
    if (ofCentre != 0)
    {
      edge.SetPlane(this->Light);
    }
    this->AddWedge(edge, bounds);
  };
  for (const auto& edge : adjacency.Edges)
  {
    const std::uint32_t* both = edge.Faces;
    if (sides[both[0]] == 0 || sides[both[0]] != sides[both[1]])
    {
      const int ofCentre = (faces(both[0]) ? 1 : 0) - (faces(both[1]) ? 1 : 0);
      const int times = adjacency.Flags[both[0]] & vtkShadowAdjacency::Closed ? 1 : 2;
      add(edge.From, edge.To, ofCentre, times, planes.Get(both[0]), planes.Get(both[1]));
    }
  }
  for (const auto& edge : adjacency.IrregularEdges)
  {
    int ofCentre = 0;
    for (std::uint32_t k = edge.First; k < edge.First + edge.Count; ++k)
    {
      const auto& face = adjacency.IrregularFaces[k];
      ofCentre += faces(face.Face) != face.Backward ? 1 : -1;
    }
    for (std::uint32_t k = edge.First; k < edge.First + edge.Count; ++k)
    {
      const auto& face = adjacency.IrregularFaces[k];
      add(edge.From, edge.To, ofCentre, face.Backward ? -2 : 2, planes.Get(face.Face),
        glm::dvec4(0.0));
    }
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::MakeOfEdges(vtkShadowFrame& frame, const vtkShadowAdjacencies& adjacencies,
  const std::vector<int>& casters, vtkShadowWedge::Bounds bounds)
{
  this->Start(frame, true);
  for (const int i : casters)
  {
    const vtkShadowCaster& caster = frame.Casters->Get()[i];
    this->StartPart(i);
    this->AddEdges(caster, adjacencies.Get(caster.Mesh), bounds);
  }
  this->Upload();
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> vtkPenumbraWedges::GetExtremes() const
{
  const bool sphere = this->Light.Kind == Shape::Sphere;
  const double radius = glm::length(this->Light.U);
  std::vector<glm::dvec4> extremes;
  for (int i = 0; i < (sphere ? 8 : 4); ++i)
  {
    const double x = i & 1 ? 1.0 : -1.0;
    const double y = i & 2 ? 1.0 : -1.0;
    const glm::dvec3 reach = sphere ? radius * glm::dvec3(x, y, i & 4 ? 1.0 : -1.0)
                                    : x * this->Light.U + y * this->Light.V;
    extremes.push_back(this->Light.Place + glm::dvec4(reach, 0.0));
  }
  return extremes;
}

//------------------------------------------------------------------------------
std::string vtkPenumbraWedges::GetLightGLSL() const
{
  const int shape = this->Light.Kind == Shape::Rectangle ? 0
                    : this->Light.Kind == Shape::Disk    ? 1
                    : this->Light.Kind == Shape::Sphere  ? 2
                                                         : 3;
  return "#define SHADOW_WEDGE_SHAPE " + std::to_string(shape) + "\n" + vtkPenumbraLightFS +
         (this->Emission ? vtkPenumbraEmission::GetGLSL() : "") + vtkPenumbraCoverFS;
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::Activate(vtkOpenGLRenderWindow* window) const
{
  if (this->Emission)
  {
    this->Emission->GetTexture().Activate(window);
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::Deactivate(vtkOpenGLRenderWindow* window) const
{
  if (this->Emission)
  {
    this->Emission->GetTexture().Deactivate(window);
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::SetLight(const vtkShadowFrame& frame, vtkShaderProgram* program) const
{
  const glm::dmat4 SWCToVC = frame.GetSWCToVC();
  const auto turn = [&](const glm::dvec3& v) { return glm::dvec3(SWCToVC * glm::dvec4(v, 0.0)); };
  const glm::vec4 placeVC(SWCToVC * this->Light.Place);
  const glm::dvec3& u = this->Light.U;
  const glm::dvec3& v = this->Light.V;
  const glm::vec3 uVC(turn(u / glm::dot(u, u)));
  const glm::vec3 vVC(turn(v / glm::dot(v, v)));
  const glm::vec3 normalVC(turn(glm::normalize(glm::cross(glm::normalize(u), glm::normalize(v)))));
  glm::mat4 VCToSWC(frame.VCToSWC);
  // Half a pixel at a place, which is even in a parallel view.
  const double pixel = std::min(glm::length(frame.GetPixelVC(0)), glm::length(frame.GetPixelVC(1)));
  const glm::vec4 halfPixel(0.5 * pixel * glm::row(frame.VCToClip, 3));
  program->SetUniform4f("shadowHalfPixel", glm::value_ptr(halfPixel));
  program->SetUniform4f("shadowAreaPlaceVC", glm::value_ptr(placeVC));
  program->SetUniform3f("shadowAreaUVC", glm::value_ptr(uVC));
  program->SetUniform3f("shadowAreaVVC", glm::value_ptr(vVC));
  program->SetUniform3f("shadowAreaNormalVC", glm::value_ptr(normalVC));
  program->SetUniformMatrix4x4("shadowVCToSWC", glm::value_ptr(VCToSWC));
  if (this->Emission)
  {
    program->SetUniformi("shadowEmission", this->Emission->GetTexture().GetUnit());
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::Draw(vtkShadowFrame& frame, const vtkShadowVolumes& volumes,
  const glm::dmat4& SWCToDraw, float farthest, const glm::vec2& retreat,
  const vtkShadowPrograms::Sources& sources,
  const std::function<void(vtkShaderProgram*)>& setParameters, const std::vector<int>* some)
{
  const auto extremes = this->GetExtremes();
  glm::mat4 SWCToClip(SWCToDraw);
  glm::mat4 SWCToVC(frame.GetSWCToVC());
  std::vector<std::pair<std::size_t, std::size_t>> runs; // of corners, one after another
  for (std::size_t k = 0; k < (some ? some->size() : this->Parts.size()); ++k)
  {
    const Part& part = this->Parts[some ? static_cast<std::size_t>((*some)[k]) : k];
    const vtkShadowCaster& caster = frame.Casters->Get()[part.Caster];
    if (part.Count == 0)
    {
      continue;
    }
    if (volumes.IsOutOfView(caster, extremes))
    {
      frame.Counts["wedgesCulled"] += static_cast<double>(part.Wedges);
      continue;
    }
    frame.Counts["wedgesDrawn"] += static_cast<double>(part.Wedges);
    if (!runs.empty() && runs.back().first + runs.back().second == part.First)
    {
      runs.back().second += part.Count;
    }
    else
    {
      runs.emplace_back(part.First, part.Count);
    }
  }
  frame.Counts["wedgesCulled"] += static_cast<double>(this->Culled);
  for (const auto& run : runs)
  {
    this->Vertices.Draw(frame.Window, GL_TRIANGLES, run.first, run.second, sources,
      [&](vtkShaderProgram* program)
      {
        program->SetUniformMatrix4x4("shadowSWCToClip", glm::value_ptr(SWCToClip));
        program->SetUniformMatrix4x4("shadowSWCToVC", glm::value_ptr(SWCToVC));
        program->SetUniformf("shadowFarthest", farthest);
        program->SetUniform2f("shadowRetreat", glm::value_ptr(retreat));
        this->SetLight(frame, program);
        setParameters(program);
      });
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedges::Release(vtkOpenGLRenderWindow* window)
{
  this->Vertices.Release();
  this->Lines.Release(window);
  this->Parts.clear();
  this->Wedges = this->Culled = 0;
}
