// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPenumbraLines.h"

#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowVolumes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace
{
/** Lines of a run turn from it by at most this (as a cosine), so that no loop falls in on itself. */
constexpr double LeastCosine = 0.866;

/** So many lines are one at most: to try a longer run costs its length. */
constexpr std::size_t LongestRun = 64;

/** A light's half width, as the tangent that a place in a distance from its centre sees. */
double GetTangent(const vtkShadowWedgeLight& light, double distance)
{
  const double radius = light.Kind == vtkShadowLight::Shape::Rectangle
                          ? glm::length(light.U + light.V)
                          : std::max(glm::length(light.U), glm::length(light.V));
  return light.Place.w == 0.0 ? radius : radius / std::max(distance, 1e-3 * radius);
}

/** A directed line of a silhouette. */
struct Line
{
  std::uint32_t From;
  std::uint32_t To;
  int Times;
};

/** The silhouette of a caster, or a loop of it. */
class Runs
{
public:
  Runs(const vtkShadowCaster& caster, const vtkShadowWedgeLight& light, double move)
    : Caster(caster)
    , Light(light)
    , Move(move)
  {
  }

  void Add(std::uint32_t from, std::uint32_t to, int times)
  {
    Vertex& first = this->Vertices[from];
    first.Next = this->Lines.size();
    ++first.Out;
    ++this->Vertices[to].In;
    this->Lines.push_back({ from, to, times });
  }

  /** Those that are left, in the order of chains. */
  std::vector<Line> Merge()
  {
    std::vector<Line> merged;
    std::vector<bool> done(this->Lines.size(), false);
    // Chains from where they begin or branch; then what is left, which are loops.
    for (const bool loops : { false, true })
    {
      for (std::size_t i = 0; i < this->Lines.size(); ++i)
      {
        if (done[i] || (!loops && this->IsPassed(this->Lines[i].From, this->Lines[i].Times)))
        {
          continue;
        }
        this->Chain.clear();
        std::size_t at = i;
        do
        {
          done[at] = true;
          this->Chain.push_back(at);
          const Line& line = this->Lines[at];
          at = this->IsPassed(line.To, line.Times) ? this->Vertices[line.To].Next : i;
        } while (!done[at]);
        this->MergeChain(merged);
      }
    }
    return merged;
  }

private:
  struct Vertex
  {
    std::size_t Next = 0;
    int In = 0;
    int Out = 0;
  };

  /** One line comes, and one goes on. */
  bool IsPassed(std::uint32_t vertex, int times) const
  {
    const Vertex& v = this->Vertices.at(vertex);
    return v.In == 1 && v.Out == 1 && this->Lines[v.Next].Times == times;
  }

  void MergeChain(std::vector<Line>& merged)
  {
    this->Places.clear();
    this->Places.push_back(
      vtkPenumbraLines::GetVertex(this->Caster, this->Lines[this->Chain[0]].From));
    for (const std::size_t i : this->Chain)
    {
      this->Places.push_back(vtkPenumbraLines::GetVertex(this->Caster, this->Lines[i].To));
    }
    for (std::size_t first = 0; first < this->Chain.size();)
    {
      std::size_t last = first + 1;
      while (last < this->Chain.size() && last - first < LongestRun &&
             this->IsNearlyStraight(first, last + 1))
      {
        ++last;
      }
      const Line& begin = this->Lines[this->Chain[first]];
      merged.push_back({ begin.From, this->Lines[this->Chain[last - 1]].To, begin.Times });
      first = last;
    }
  }

  /** What lies between two places of the chain, as the light sees it, against the line between them. */
  bool IsNearlyStraight(std::size_t first, std::size_t last) const
  {
    const glm::dvec3& from = this->Places[first];
    const glm::dvec3 along = this->Places[last] - from;
    for (std::size_t k = first; k < last; ++k)
    {
      const glm::dvec3& place = this->Places[k];
      const glm::dvec3 away = place * this->Light.Place.w - glm::dvec3(this->Light.Place);
      const double distance = glm::length(away);
      const glm::dvec3 ray = away / distance;
      const auto seen = [&](const glm::dvec3& v) { return v - glm::dot(v, ray) * ray; };
      const glm::dvec3 line = seen(along);
      const glm::dvec3 part = seen(this->Places[k + 1] - place);
      const double length = glm::length(line);
      if (!(glm::dot(part, line) >= LeastCosine * glm::length(part) * length) || length == 0.0)
      {
        return false;
      }
      const double share =
        std::clamp(glm::dot(seen(place - from), line) / (length * length), 0.0, 1.0);
      const glm::dvec3 gap = place - from - share * along;
      // Towards the caster alone: what of its own surface comes out of its shadow turns away from the
      // light, and no more of it comes in.
      if (glm::dot(glm::cross(along, away), gap) > 1e-9 * length * distance * glm::length(gap))
      {
        return false;
      }
      // Nearer or farther on the same ray moves what the rest of the light sees.
      const double move =
        glm::length(seen(gap)) + std::abs(glm::dot(gap, ray)) * GetTangent(this->Light, distance);
      if (!(move <= this->Move * (this->Light.Place.w == 0.0 ? 1.0 : distance)))
      {
        return false;
      }
    }
    return true;
  }

  const vtkShadowCaster& Caster;
  const vtkShadowWedgeLight& Light;
  double Move;
  std::vector<Line> Lines;
  std::unordered_map<std::uint32_t, Vertex> Vertices;
  std::vector<std::size_t> Chain;
  std::vector<glm::dvec3> Places; // of the chain
};
}

//------------------------------------------------------------------------------
glm::dvec3 vtkPenumbraLines::GetVertex(const vtkShadowCaster& caster, std::uint32_t vertex)
{
  const float* p = &caster.Mesh->Positions[3 * static_cast<std::size_t>(vertex)];
  return glm::dvec3(caster.MeshToSWC * glm::dvec4(p[0], p[1], p[2], 1.0));
}

//------------------------------------------------------------------------------
std::vector<double> vtkPenumbraLines::FindMoves(const vtkShadowFrame& frame,
  const vtkShadowVolumes& volumes, const std::vector<int>& casters,
  const vtkShadowWedgeLight& light, double pixels)
{
  const auto& all = frame.Casters->Get();
  std::vector<double> moves(all.size(), 0.0);
  const glm::dmat4 SWCToClip = frame.VCToClip * frame.GetSWCToVC();
  const glm::dvec4 depth = glm::row(SWCToClip, 3); // w of clip coordinates
  const double steepest = glm::length(glm::dvec3(depth));
  const double pixel =
    std::min(glm::length(frame.GetPixelVC(0)), glm::length(frame.GetPixelVC(1))); // per w
  const bool directional = light.Place.w == 0.0;
  const glm::dvec3 centre(light.Place);
  const double nearest = volumes.GetNearest();
  // What receives lies no farther from the light, or behind a caster, than this.
  double farthest = 0.0;
  const auto reach = [&](const std::array<glm::dvec3, 8>& corners)
  {
    for (const auto& corner : corners)
    {
      farthest = std::max(farthest, glm::length(directional ? corner : corner - centre));
    }
  };
  std::for_each(frame.Casters->GetReceivers().begin(), frame.Casters->GetReceivers().end(), reach);
  for (const auto& caster : all)
  {
    reach(caster.Corners);
  }
  for (const int i : casters)
  {
    const vtkShadowCaster& caster = all[i];
    if (volumes.HasCaps(caster, light.Place))
    {
      continue;
    }
    double least = std::numeric_limits<double>::max();
    for (const auto& corner : caster.Corners)
    {
      // Along the ray through the corner w is linear in the way from the light, so that the quotient
      // of both is least at an end of what is seen of it.
      const glm::dvec3 away = directional ? -centre : corner - centre;
      const double distance = glm::length(away);
      const double start = directional ? 0.0 : distance;
      const double end = directional ? 2.0 * farthest : farthest;
      const double w = glm::dot(depth, glm::dvec4(corner, 1.0));
      const double slope =
        glm::dot(glm::dvec3(depth), away) / distance - steepest * GetTangent(light, distance);
      double from = start;
      double to = std::max(start, end);
      const double enters = slope != 0.0 ? start + (nearest - w) / slope : start;
      (slope > 0.0 ? from : to) = slope > 0.0 ? std::max(from, enters) : std::min(to, enters);
      if (from > to || (slope == 0.0 && w < nearest))
      {
        continue;
      }
      for (const double way : { from, to })
      {
        const double size = (w + (way - start) * slope) / (directional ? 1.0 : way);
        least = std::min(least, size);
      }
    }
    const double unit = directional ? glm::length(caster.Corners[7] - caster.Corners[0]) : 1.0;
    const double move = pixels * pixel * least / unit;
    moves[i] =
      move > 0.0 && std::isfinite(move) ? unit * std::exp2(std::floor(std::log2(move))) : 0.0;
  }
  return moves;
}

//------------------------------------------------------------------------------
void vtkPenumbraLines::Make(vtkShadowFrame& frame, const vtkShadowSilhouetteCache::Batch& batch,
  int place, const vtkShadowWedgeLight& light, const std::vector<double>& moves)
{
  const auto& lines = batch.Silhouettes.GetLines();
  this->Lines.clear();
  this->Parts.clear();
  std::vector<glm::vec4> planes;
  std::size_t before = 0;
  for (const auto& part : vtkShadowSilhouetteCache::Get(batch, place).Parts)
  {
    const vtkShadowCaster& caster = frame.Casters->Get()[part.Caster];
    const double move = moves.empty() ? 0.0 : moves[part.Caster];
    Runs runs(caster, light, move);
    std::vector<Line> merged;
    for (std::size_t i = part.First; i < part.First + part.Count;)
    {
      // Edges that count several times stand one after another.
      Line line = { lines[i], lines[i + 1], 0 };
      for (; i < part.First + part.Count && lines[i] == line.From && lines[i + 1] == line.To;
           i += 2)
      {
        ++line.Times;
      }
      ++before;
      move > 0.0 ? runs.Add(line.From, line.To, line.Times) : merged.push_back(line);
    }
    if (move > 0.0)
    {
      merged = runs.Merge();
    }
    this->Parts.push_back({ part.Caster, this->Lines.size(), 0 });
    before -= merged.size();
    for (const Line& line : merged)
    {
      vtkShadowWedgeEdge edge;
      edge.Ends[0] = GetVertex(caster, line.From);
      edge.Ends[1] = GetVertex(caster, line.To);
      edge.SetPlane(light);
      for (int k = 0; k < line.Times; ++k)
      {
        this->Lines.insert(this->Lines.end(), { line.From, line.To });
        planes.emplace_back(edge.Plane);
        planes.emplace_back(edge.Width);
      }
    }
    this->Parts.back().Count = this->Lines.size() - this->Parts.back().First;
  }
  this->Merged = before;
  glBindVertexArray(0); // or the buffer would become that array's
  this->Buffer->Upload(this->Lines, vtkOpenGLBufferObject::ElementArrayBuffer);
  const int rows = std::max<int>(1, static_cast<int>((planes.size() + Width - 1) / Width));
  planes.resize(static_cast<std::size_t>(rows) * Width);
  this->Planes.Allocate(frame.Window, vtkShadowTexture::Format::Float4, Width, rows, 1);
  this->Planes.UploadLayer(frame.Window, 0, &planes[0].x);
}

//------------------------------------------------------------------------------
std::size_t vtkPenumbraLines::GetBytes() const
{
  return this->Planes.GetBytes() + this->Lines.size() * sizeof(std::uint32_t);
}

//------------------------------------------------------------------------------
void vtkPenumbraLines::Release(vtkOpenGLRenderWindow* window)
{
  this->Buffer->ReleaseGraphicsResources();
  this->Planes.Release(window);
  this->Lines.clear();
  this->Parts.clear();
}
