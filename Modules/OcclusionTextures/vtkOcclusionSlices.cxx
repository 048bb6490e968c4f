// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOcclusionSlices.h"

#include "vtkOcclusionViews.h"
#include "vtkShadowCasters.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr int Bins = 512;

/** Of more triangles, the boxes tell. */
constexpr std::size_t MostTriangles = 524288;

/** Depths that differ by less than this share are one. */
constexpr double Rounding = 1e-6;

/** So much of all slices' density is even, that none becomes too thick. */
constexpr double EvenShare = 0.2;

constexpr double Infinite = std::numeric_limits<double>::max();

struct Bin
{
  double Area = 0.0;
  double Top = Infinite;
  double Bottom = -Infinite;
  glm::dvec2 Low{ Infinite };
  glm::dvec2 High{ -Infinite };

  bool IsEmpty() const { return this->Top > this->Bottom; }
  void Add(const Bin& other)
  {
    this->Area += other.Area;
    this->Top = std::min(this->Top, other.Top);
    this->Bottom = std::max(this->Bottom, other.Bottom);
    this->Low = glm::min(this->Low, other.Low);
    this->High = glm::max(this->High, other.High);
  }
};

class Histogram
{
public:
  explicit Histogram(const vtkOcclusionView& view)
    : View(view)
    , Size((view.Farthest - view.Nearest) / Bins)
  {
  }

  /** What lies between some points, of an area. */
  template <std::size_t N>
  void Add(const std::array<glm::dvec3, N>& points, double area)
  {
    Bin all;
    bool cut = false;
    for (const auto& p : points)
    {
      cut = cut || p.z < this->View.Nearest;
      this->Include(all, p);
    }
    if (N == 3 && (cut || glm::any(glm::lessThan(all.Low, this->View.Low)) ||
                    glm::any(glm::greaterThan(all.High, this->View.High))))
    {
      // Of a floor, whose most lies outside, the depths within count.
      all = Bin();
      for (const auto& p : this->Clip({ points.begin(), points.end() }))
      {
        this->Include(all, p);
      }
      cut = false;
    }
    all.Low = cut ? this->View.Low : glm::max(all.Low, this->View.Low);
    all.High = cut ? this->View.High : glm::min(all.High, this->View.High);
    all.Top = std::max(all.Top, this->View.Nearest);
    all.Bottom = std::min(all.Bottom, this->View.Farthest);
    if (all.IsEmpty() || all.Low.x > all.High.x || all.Low.y > all.High.y)
    {
      return;
    }
    const int first = this->Find(all.Top);
    const int last = this->Find(all.Bottom);
    all.Area = area / (last - first + 1);
    for (int i = first; i <= last; ++i)
    {
      Bin part = all;
      part.Top = i == first ? all.Top : this->GetTop(i);
      part.Bottom = i == last ? all.Bottom : this->GetTop(i + 1);
      this->Values[i].Add(part);
    }
  }

  double GetTop(int bin) const { return this->View.Nearest + bin * this->Size; }
  double GetSize() const { return this->Size; }
  const std::array<Bin, Bins>& Get() const { return this->Values; }

private:
  void Include(Bin& bin, const glm::dvec3& p) const
  {
    bin.Top = std::min(bin.Top, p.z);
    bin.Bottom = std::max(bin.Bottom, p.z);
    const glm::dvec2 place = glm::dvec2(p) / this->View.GetW(p.z);
    bin.Low = glm::min(bin.Low, place);
    bin.High = glm::max(bin.High, place);
  }

  /** What of a polygon lies within the view. */
  std::vector<glm::dvec3> Clip(std::vector<glm::dvec3> polygon) const
  {
    for (int side = 0; side < 5; ++side)
    {
      const auto within = [&](const glm::dvec3& p)
      {
        const double w = this->View.GetW(p.z);
        return side == 0  ? p.z - this->View.Nearest
               : side < 3 ? p[side - 1] - this->View.Low[side - 1] * w
                          : this->View.High[side - 3] * w - p[side - 3];
      };
      std::vector<glm::dvec3> left;
      for (std::size_t i = 0; i < polygon.size(); ++i)
      {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        const double da = within(a);
        const double db = within(b);
        if (da >= 0.0)
        {
          left.push_back(a);
        }
        if ((da >= 0.0) != (db >= 0.0))
        {
          left.push_back(a + da / (da - db) * (b - a));
        }
      }
      polygon = std::move(left);
    }
    return polygon;
  }

  int Find(double depth) const
  {
    return this->Size > 0.0
             ? std::clamp(static_cast<int>((depth - this->View.Nearest) / this->Size), 0, Bins - 1)
             : 0;
  }

  const vtkOcclusionView& View;
  const double Size;
  std::array<Bin, Bins> Values;
};

void Fill(Histogram& histogram, const vtkOcclusionView& view, const vtkShadowCasters& casters)
{
  std::size_t triangles = 0;
  for (const int index : view.Casters)
  {
    triangles += casters.Get()[index].Mesh->GetNumberOfTriangles();
  }
  std::vector<glm::dvec3> points;
  for (const int index : view.Casters)
  {
    const vtkShadowCaster& caster = casters.Get()[index];
    if (triangles > MostTriangles)
    {
      std::array<glm::dvec3, 8> corners;
      std::transform(caster.Corners.begin(), caster.Corners.end(), corners.begin(),
        [&view](const glm::dvec3& corner) { return view.ToView(corner); });
      histogram.Add(corners, caster.GetRadius() * caster.GetRadius());
      continue;
    }
    const vtkShadowMesh& mesh = *caster.Mesh;
    points.resize(mesh.GetNumberOfVertices());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const float* p = &mesh.Positions[3 * i];
      points[i] = view.ToView(glm::dvec3(caster.MeshToSWC * glm::dvec4(p[0], p[1], p[2], 1.0)));
    }
    for (std::size_t i = 0; i + 2 < mesh.Indices.size(); i += 3)
    {
      const std::array<glm::dvec3, 3> t = { points[mesh.Indices[i]], points[mesh.Indices[i + 1]],
        points[mesh.Indices[i + 2]] };
      histogram.Add(t, 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0])));
    }
  }
}

/**
 * How thin slices should be, in bins: what is moved by some along the light errs by that over its distance
 * from the receiver (section 4.1 of the paper), so that the sum of errors is least where the density is the
 * root of area over distance. Casters receive too, but what lies far below them is what shows.
 */
std::vector<double> GetDensity(
  const Histogram& histogram, const vtkOcclusionView& view, int first, int last)
{
  std::vector<double> density(Bins, 0.0);
  double sum = 0.0;
  const double range = (last - first + 1) * histogram.GetSize();
  for (int i = first; i <= last; ++i)
  {
    const double distance = view.Receivers - histogram.GetTop(i) + 0.05 * range;
    density[i] = std::sqrt(histogram.Get()[i].Area / distance);
    sum += density[i];
  }
  for (int i = first; i <= last; ++i)
  {
    density[i] =
      (1.0 - EvenShare) * (sum > 0.0 ? density[i] / sum : 0.0) + EvenShare / (last - first + 1);
  }
  return density;
}
}

//------------------------------------------------------------------------------
std::vector<vtkOcclusionSlice> vtkOcclusionSlice::Place(
  const vtkOcclusionView& view, const vtkShadowCasters& casters, int count, Placement placement)
{
  Histogram histogram(view);
  Fill(histogram, view, casters);
  const auto& bins = histogram.Get();
  int first = 0;
  int last = Bins - 1;
  while (first <= last && bins[first].IsEmpty())
  {
    ++first;
  }
  while (last > first && bins[last].IsEmpty())
  {
    --last;
  }
  std::vector<vtkOcclusionSlice> slices;
  std::vector<double> density = placement == Placement::Adaptive
                                  ? GetDensity(histogram, view, first, last)
                                  : std::vector<double>(Bins, 1.0 / std::max(1, last - first + 1));
  double sum = 0.0;
  Bin content;
  int index = 0;
  const double thinnest = Rounding * std::max(std::abs(view.Farthest), std::abs(view.Nearest));
  const auto close = [&]()
  {
    if (!content.IsEmpty())
    {
      vtkOcclusionSlice slice;
      slice.Top = content.Top;
      slice.Plane = content.Bottom;
      slice.Fade = std::max(slice.Plane - slice.Top, thinnest);
      slice.Low = content.Low;
      slice.High = content.High;
      slices.push_back(slice);
    }
    content = Bin();
  };
  for (int i = first; i <= last; ++i)
  {
    content.Add(bins[i]);
    sum += density[i];
    // A bin is not cut: what is finer than a bin is as good as one.
    if (sum * count >= index + 1 - 1e-9 && index + 1 < count)
    {
      close();
      index = std::min(static_cast<int>(sum * count + 1e-9), count - 1);
    }
  }
  close();
  return slices;
}
