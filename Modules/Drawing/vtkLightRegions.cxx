// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLightRegions.h"

#include "vtkShadowCasters.h"
#include "vtkShadowLight.h"
#include "vtkShadowRoom.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace
{
/**
 * So many boxes are looked at, by all flat casters together, for whether something lies behind one;
 * and in a view, for what does. The largest come first, so that those for which nothing is left, and
 * which then count whole, are the smallest.
 */
constexpr std::size_t MostBoxes = 1048576;
constexpr std::size_t MostBoxesInView = 262144;

/** Of a caster of so many vertices, its box tells what lies behind a plane; else they do. */
constexpr std::size_t MostVertices = 65536;

/** So many vertices take as long to look at as a box. */
constexpr std::size_t VerticesOfBox = 16;

/** What sizes may differ by and still count as the same. */
constexpr double Rounding = 1e-6;

/**
 * Of each caster, what is nearer to the light than this share of its own depth may be clipped. With a
 * sky around them, things at arm's length keep the depth's precision; what is a thousand times as far
 * loses it.
 */
constexpr double NearestShare = 0.03;

using Box = vtkLightRegions::Box;
using Range = vtkLightRegions::Range;
using Group = vtkLightRegions::Group;

/** Windows in a tree, to find those that meet another one. */
class WindowTree
{
public:
  explicit WindowTree(const std::vector<Range>& windows)
    : Windows(windows)
  {
    for (std::size_t i = 0; i < windows.size(); ++i)
    {
      if (!windows[i].IsEmpty())
      {
        this->Order.push_back(static_cast<int>(i));
      }
    }
    this->Nodes.reserve(this->Order.size());
    if (!this->Order.empty())
    {
      this->Build(0, static_cast<int>(this->Order.size()));
    }
  }
  /** `visit` those whose part within a window, they being that much larger, `adds` something. */
  template <typename Adds, typename Visit>
  void ForEach(Adds adds, Visit visit) const
  {
    for (std::size_t n = 0; n < this->Nodes.size();)
    {
      const Node& node = this->Nodes[n];
      const bool enter = adds(node.Window);
      for (int k = node.First; enter && node.Leaf && k < node.End; ++k)
      {
        if (adds(this->Windows[this->Order[k]]))
        {
          visit(this->Order[k]);
        }
      }
      n = enter ? n + 1 : node.Next;
    }
  }

private:
  struct Node
  {
    Range Window;
    int First;
    int End;
    bool Leaf;
    std::size_t Next; // behind its children
  };
  void Build(int first, int end)
  {
    const std::size_t index = this->Nodes.size();
    this->Nodes.push_back({ {}, first, end, end - first <= 4, 0 });
    Range window;
    for (int k = first; k < end; ++k)
    {
      window.Add(this->Windows[this->Order[k]]);
    }
    if (!this->Nodes[index].Leaf)
    {
      const glm::dvec3 size = window.High - window.Low;
      const int axis = size.x < size.y ? 1 : 0;
      const int middle = (first + end) / 2;
      std::nth_element(this->Order.begin() + first, this->Order.begin() + middle,
        this->Order.begin() + end,
        [this, axis](int a, int b)
        {
          const auto at = [this, axis](int i)
          { return this->Windows[i].Low[axis] + this->Windows[i].High[axis]; };
          return at(a) < at(b);
        });
      this->Build(first, middle);
      this->Build(middle, end);
    }
    this->Nodes[index].Window = window;
    this->Nodes[index].Next = this->Nodes.size();
  }

  const std::vector<Range>& Windows;
  std::vector<int> Order;
  std::vector<Node> Nodes; // children behind their parents
};

struct Item
{
  Range Needed;
  Range Whole;
  int Caster;
  bool Plane;
};

void AddGroups(std::vector<Item> items, double leastRoom, int most, std::vector<Group>& groups)
{
  std::vector<vtkShadowRoom::Rectangle> windows;
  for (const Item& item : items)
  {
    windows.emplace_back(item.Needed.Low, item.Needed.High);
  }
  const vtkShadowRoom room = most > 1 ? vtkShadowRoom::Find(windows, leastRoom) : vtkShadowRoom();
  if (room.Share > 0.0)
  {
    const auto middle = std::stable_partition(items.begin(), items.end(),
      [&room](const Item& item) { return item.Needed.Low[room.Axis] < room.End; });
    AddGroups({ items.begin(), middle }, leastRoom, most / 2, groups);
    AddGroups({ middle, items.end() }, leastRoom, most / 2, groups);
    return;
  }
  groups.emplace_back();
  const auto largest =
    std::find_if(items.begin(), items.end(), [](const Item& i) { return !i.Plane; });
  groups.back().Anchor = (largest != items.end() ? *largest : items.front()).Needed;
  for (const auto& item : items)
  {
    groups.back().Needed.Add(item.Needed);
    groups.back().Whole.Add(item.Whole);
    groups.back().Nearest =
      std::min(groups.back().Nearest, std::max(item.Whole.Low.z, NearestShare * item.Whole.High.z));
    groups.back().Casters.push_back(item.Caster);
  }
}
}

//------------------------------------------------------------------------------
bool vtkLightRegions::Range::IsEmpty() const
{
  return this->Low.x > this->High.x || this->Low.y > this->High.y || this->Low.z > this->High.z;
}

//------------------------------------------------------------------------------
void vtkLightRegions::Range::Add(const glm::dvec3& p)
{
  this->Low = glm::min(this->Low, p);
  this->High = glm::max(this->High, p);
}

//------------------------------------------------------------------------------
void vtkLightRegions::Range::Add(const Range& other)
{
  if (!other.IsEmpty())
  {
    this->Add(other.Low);
    this->Add(other.High);
  }
}

//------------------------------------------------------------------------------
bool vtkLightRegions::Range::ReachesOver(const Range& other) const
{
  return this->Low.x < other.Low.x || this->Low.y < other.Low.y || this->High.x > other.High.x ||
         this->High.y > other.High.y;
}

//------------------------------------------------------------------------------
vtkLightRegions::Range vtkLightRegions::Range::Window(const Range& other, double overlap) const
{
  Range result = *this;
  result.Low.x = std::max(this->Low.x, other.Low.x - overlap);
  result.Low.y = std::max(this->Low.y, other.Low.y - overlap);
  result.High.x = std::min(this->High.x, other.High.x + overlap);
  result.High.y = std::min(this->High.y, other.High.y + overlap);
  return result;
}

//------------------------------------------------------------------------------
bool vtkLightRegions::Region::IsBefore(const Box& box, double tolerance) const
{
  const double reach = 0.5 * (std::abs(glm::dot(this->Normal, box[1] - box[0])) +
                               std::abs(glm::dot(this->Normal, box[2] - box[0])) +
                               std::abs(glm::dot(this->Normal, box[4] - box[0])));
  return glm::dot(this->Normal, 0.5 * (box[0] + box[7]) - this->Point) < reach - tolerance;
}

//------------------------------------------------------------------------------
bool vtkLightRegions::Region::IsBefore(const Box& box) const
{
  // Touching is not behind: floors under things that stand on them.
  return this->IsBefore(box, Rounding * glm::length(box[7] - box[0]));
}

//------------------------------------------------------------------------------
bool vtkLightRegions::Region::IsBefore(const vtkShadowCaster& caster) const
{
  if (caster.Mesh->GetNumberOfVertices() > MostVertices)
  {
    return true;
  }
  const double tolerance = Rounding * glm::length(caster.Corners[7] - caster.Corners[0]);
  const glm::dvec4 row(this->Normal, tolerance - glm::dot(this->Normal, this->Point));
  const glm::dvec4 rowMC = row * caster.MeshToSWC; // the row times the matrix
  const auto& positions = caster.Mesh->Positions;
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3)
  {
    if (glm::dot(rowMC, glm::dvec4(positions[i], positions[i + 1], positions[i + 2], 1.0)) < 0.0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkLightRegions::FindPlane(
  Region& region, const vtkShadowLight& light, const vtkShadowCasters& casters) const
{
  const vtkShadowCaster& caster = casters.Get()[region.Caster];
  const glm::dmat3 linear(caster.MeshToSWC);
  const glm::dvec3 normal = glm::transpose(glm::inverse(linear)) * caster.Mesh->Normal;
  const double length = glm::length(normal);
  if (!caster.Mesh->Flat || !(length > 0.0) || !std::isfinite(length))
  {
    return false;
  }
  region.Normal = normal / length;
  region.Point = glm::dvec3(caster.MeshToSWC * glm::dvec4(caster.Mesh->PlanePoint, 1.0));
  double lowest = std::numeric_limits<double>::max();
  double highest = std::numeric_limits<double>::lowest();
  for (const auto& place : light.GetExtremes())
  {
    const double distance = glm::dot(
      region.Normal, light.IsDirectional() ? place : place - casters.GetOrigin() - region.Point);
    lowest = std::min(lowest, distance);
    highest = std::max(highest, distance);
  }
  region.Normal *= lowest > 0.0 ? 1.0 : -1.0;
  return lowest > 0.0 || highest < 0.0;
}

//------------------------------------------------------------------------------
bool vtkLightRegions::IsShell(
  int index, const vtkShadowLight& light, const vtkShadowCasters& casters) const
{
  const vtkShadowCaster& caster = casters.Get()[index];
  const vtkShadowMesh& mesh = *caster.Mesh;
  if (light.IsDirectional() || mesh.GetNumberOfTriangles() * this->Boxes.size() > MostBoxes)
  {
    return false;
  }
  const glm::dmat4 SWCToMesh = glm::inverse(caster.MeshToSWC);
  for (const auto& extreme : light.GetExtremes())
  {
    const glm::dvec3 place = extreme - casters.GetOrigin();
    const glm::dvec3 p(SWCToMesh * glm::dvec4(place, 1.0));
    if (!(glm::all(glm::lessThan(mesh.Minimum, p)) && glm::all(glm::lessThan(p, mesh.Maximum))))
    {
      return false;
    }
    // It is seen once in each direction where all triangles turn the same side to the place and fill a
    // sphere around it.
    double solidAngle = 0.0;
    for (std::size_t i = 0; i < mesh.Indices.size(); i += 3)
    {
      glm::dvec3 v[3];
      for (int k = 0; k < 3; ++k)
      {
        const float* position = &mesh.Positions[3 * mesh.Indices[i + k]];
        v[k] =
          glm::dvec3(caster.MeshToSWC * glm::dvec4(position[0], position[1], position[2], 1.0));
      }
      Region face;
      face.Point = v[0];
      const glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
      const double turned = glm::dot(normal, place - v[0]) < 0.0 ? -1.0 : 1.0;
      face.Normal = turned * normal / std::max(glm::length(normal), 1e-300);
      for (std::size_t box = 0; box < this->Boxes.size(); ++box)
      {
        if (static_cast<int>(box) != index && face.IsBefore(this->Boxes[box]))
        {
          return false;
        }
      }
      const double sides[] = { glm::length(v[0] - place), glm::length(v[1] - place),
        glm::length(v[2] - place) };
      const glm::dvec3 a = (v[0] - place) / sides[0];
      const glm::dvec3 b = (v[1] - place) / sides[1];
      const glm::dvec3 c = (v[2] - place) / sides[2];
      const double angle = 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                                   1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
      if (angle * solidAngle < 0.0)
      {
        return false;
      }
      solidAngle += angle;
    }
    if (!(std::abs(std::abs(solidAngle) - 4.0 * glm::pi<double>()) < 1e-3))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkLightRegions::vtkLightRegions(const vtkShadowLightPart& part, const vtkShadowCasters& casters)
{
  const auto& all = casters.Get();
  for (const auto& caster : all)
  {
    this->Boxes.push_back(caster.Corners);
  }
  const auto& receivers = casters.GetReceivers();
  this->Boxes.insert(this->Boxes.end(), receivers.begin(), receivers.end());
  Range whole;
  for (const auto& box : this->Boxes)
  {
    for (const auto& corner : box)
    {
      whole.Add(corner);
    }
  }
  Box scene;
  for (std::size_t k = 0; k < scene.size(); ++k)
  {
    scene[k] = glm::mix(whole.Low, whole.High, glm::bvec3(k & 1, k & 2, k & 4));
  }

  std::vector<std::pair<float, int>> order; // the largest first; rounding is not to choose
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (all[i].IsSeenBy(part)) // else it is something to be shadowed for this part of the light
    {
      order.emplace_back(-static_cast<float>(all[i].GetRadius()), static_cast<int>(i));
    }
  }
  std::sort(order.begin(), order.end());
  std::size_t looked = 0;
  int last = 0; // the box that was found last, and often hits again
  for (const auto& entry : order)
  {
    Region region;
    region.Caster = entry.second;
    region.Plane = this->FindPlane(region, part.Light, casters);
    const auto isBehind = [&](int box)
    {
      if (box == region.Caster || !region.IsBefore(this->Boxes[box]))
      {
        return false;
      }
      looked += box < static_cast<int>(all.size())
                  ? static_cast<std::size_t>(all[box].Mesh->GetNumberOfVertices()) / VerticesOfBox
                  : 0;
      return box >= static_cast<int>(all.size()) || region.IsBefore(all[box]);
    };
    if (!region.Plane && this->IsShell(region.Caster, part.Light, casters))
    {
      continue;
    }
    bool counts = !region.Plane || looked >= MostBoxes || isBehind(last);
    const bool none = !region.IsBefore(scene, 1e-12 * glm::length(scene[7] - scene[0]));
    for (std::size_t i = 0; !counts && !none && i < this->Boxes.size(); ++i, ++looked)
    {
      if (isBehind(static_cast<int>(i)))
      {
        counts = true;
        last = static_cast<int>(i);
      }
    }
    if (counts)
    {
      this->Regions.push_back(region);
      this->Casters.push_back(region.Caster);
    }
  }
  for (const auto& region : this->Regions)
  {
    if (!region.Plane)
    {
      this->Whole.push_back(region.Caster);
    }
  }
  std::sort(this->Casters.begin(), this->Casters.end());
  std::sort(this->Whole.begin(), this->Whole.end());
  this->Whole = this->Whole.empty() ? this->Casters : this->Whole;
}

//------------------------------------------------------------------------------
int vtkLightRegions::GetLargest() const
{
  const auto found = std::find_if(
    this->Regions.begin(), this->Regions.end(), [](const Region& region) { return !region.Plane; });
  return (found != this->Regions.end() ? *found : this->Regions.front()).Caster;
}

//------------------------------------------------------------------------------
double vtkLightRegions::GetDiameter() const
{
  Range all;
  const bool behind = std::any_of(
    this->Regions.begin(), this->Regions.end(), [](const Region& region) { return region.Plane; });
  const auto add = [&all](const Box& box)
  {
    for (const auto& corner : box)
    {
      all.Add(corner);
    }
  };
  if (behind)
  {
    std::for_each(this->Boxes.begin(), this->Boxes.end(), add);
  }
  for (const auto& region : this->Regions)
  {
    add(this->Boxes[region.Caster]);
  }
  return all.IsEmpty() ? 0.0 : glm::length(all.High - all.Low);
}

//------------------------------------------------------------------------------
std::vector<vtkLightRegions::Group> vtkLightRegions::GetGroups(
  const std::function<Range(const Box&)>& project, double overlap, int most) const
{
  std::vector<Range> windows(this->Boxes.size());
  std::transform(this->Boxes.begin(), this->Boxes.end(), windows.begin(), project);
  std::unique_ptr<WindowTree> tree;
  std::size_t looked = 0;
  std::vector<Item> items;
  Range whole; // what bodies need, and larger flats: what lies in it needs no closer look
  for (const auto& region : this->Regions)
  {
    if (!region.Plane)
    {
      whole.Add(windows[region.Caster]);
    }
  }
  for (const auto& region : this->Regions)
  {
    const Range& own = windows[region.Caster];
    Item item{ own, own, region.Caster, region.Plane };
    if (region.Plane && own.ReachesOver(whole) && looked < MostBoxesInView)
    {
      item.Needed = Range();
      if (!tree)
      {
        tree = std::make_unique<WindowTree>(windows);
      }
      tree->ForEach(
        [&](const Range& window)
        {
          const Range common = own.Window(window, overlap);
          return !common.IsEmpty() && common.ReachesOver(item.Needed);
        },
        [&](int i)
        {
          ++looked;
          if (i != region.Caster && region.IsBefore(this->Boxes[i]))
          {
            item.Needed.Add(own.Window(windows[i], overlap));
          }
        });
    }
    if (!item.Needed.IsEmpty())
    {
      whole.Add(item.Needed);
      items.push_back(item);
    }
  }
  std::vector<Group> groups;
  if (!items.empty())
  {
    // Look-ups from a receiver between two groups reach into one of them.
    AddGroups(std::move(items), 2.0 * overlap, most, groups);
  }
  for (auto& group : groups)
  {
    std::sort(group.Casters.begin(), group.Casters.end());
  }
  return groups;
}
