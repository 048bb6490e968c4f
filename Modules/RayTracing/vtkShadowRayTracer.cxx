// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRayTracer.h"

#include "vtkShadowCasters.h"
#include "vtkShadowLight.h"
#include "vtkShadowRayPackets.h"
#include "vtkShadowRayPatterns.h"

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>

namespace
{
/** Rays go on through holes: called for each hit on a mesh that has some. */
void PassHoles(const RTCFilterFunctionNArguments* arguments)
{
  const auto& mesh = *static_cast<const vtkShadowMesh*>(arguments->geometryUserPtr);
  for (unsigned int i = 0; i < arguments->N; ++i)
  {
    if (arguments->valid[i] == -1 &&
        mesh.Holes->IsHole(&mesh.Indices[3 * RTCHitN_primID(arguments->hit, arguments->N, i)],
          RTCHitN_u(arguments->hit, arguments->N, i), RTCHitN_v(arguments->hit, arguments->N, i)))
    {
      arguments->valid[i] = 0;
    }
  }
}
}

class vtkShadowRayTracer::Internals
{
public:
  struct MeshScene
  {
    RTCScene Scene = nullptr; // where structures are instanced
    bool Used = false;

    void Release()
    {
      if (this->Scene)
      {
        rtcReleaseScene(this->Scene);
        this->Scene = nullptr;
      }
    }
  };

  RTCDevice Device = nullptr;
  std::map<double, RTCScene> Scenes; // of casters of this opacity and more
  std::string Error;
  std::map<std::shared_ptr<const vtkShadowMesh>, MeshScene> Meshes;

  vtkShadowRayPatterns Patterns;
  int Packet = 0;
  bool Flat = false;
  bool Changed = false; // since the first structures

  /** A mesh's triangles, whose vertices are to be set. */
  RTCGeometry MakeGeometry(const vtkShadowMesh& mesh) const
  {
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
      mesh.Indices.data(), 0, 3 * sizeof(std::uint32_t), mesh.GetNumberOfTriangles());
    if (mesh.Holes)
    {
      rtcSetGeometryUserData(geometry, const_cast<vtkShadowMesh*>(&mesh));
      rtcSetGeometryOccludedFilterFunction(geometry, PassHoles);
    }
    return geometry;
  }

  RTCScene MakeMeshScene(const vtkShadowMesh& mesh) const
  {
    RTCScene scene = rtcNewScene(this->Device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = this->MakeGeometry(mesh);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
      mesh.Positions.data(), 0, 3 * sizeof(float), mesh.GetNumberOfVertices());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
  }

  /** A caster's triangles in their places. */
  RTCGeometry MakePlaced(const vtkShadowCaster& caster) const
  {
    const vtkShadowMesh& mesh = *caster.Mesh;
    RTCGeometry geometry = this->MakeGeometry(mesh);
    const std::size_t count = mesh.GetNumberOfVertices();
    auto* places = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), count));
    for (std::size_t i = 0; i < 3 * count; i += 3)
    {
      const glm::dvec4 position(
        mesh.Positions[i], mesh.Positions[i + 1], mesh.Positions[i + 2], 1.0);
      const glm::dvec4 place = caster.MeshToSWC * position;
      for (int c = 0; c < 3; ++c)
      {
        places[i + c] = static_cast<float>(place[c]);
      }
    }
    rtcCommitGeometry(geometry);
    return geometry;
  }

  RTCGeometry MakeInstance(const vtkShadowCaster& caster, RTCScene mesh) const
  {
    RTCGeometry instance = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, mesh);
    const glm::mat4 matrix(caster.MeshToSWC);
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, glm::value_ptr(matrix));
    rtcCommitGeometry(instance);
    return instance;
  }

  void ReleaseScenes()
  {
    for (auto& entry : this->Scenes)
    {
      rtcReleaseScene(entry.second);
    }
    this->Scenes.clear();
  }
};

//------------------------------------------------------------------------------
vtkShadowRayTracer::vtkShadowRayTracer()
  : Internal(new Internals)
{
  this->Internal->Device = rtcNewDevice(nullptr);
  if (!this->Internal->Device)
  {
    this->Internal->Error = "Embree cannot start (error " +
                            std::to_string(static_cast<int>(rtcGetDeviceError(nullptr))) + ")";
  }
}

//------------------------------------------------------------------------------
vtkShadowRayTracer::~vtkShadowRayTracer()
{
  this->Clear();
  if (this->Internal->Device)
  {
    rtcReleaseDevice(this->Internal->Device);
  }
}

//------------------------------------------------------------------------------
const std::string& vtkShadowRayTracer::GetError() const
{
  return this->Internal->Error;
}

//------------------------------------------------------------------------------
void vtkShadowRayTracer::Clear()
{
  this->Internal->ReleaseScenes();
  for (auto& entry : this->Internal->Meshes)
  {
    entry.second.Release();
  }
  this->Internal->Meshes.clear();
}

//------------------------------------------------------------------------------
bool vtkShadowRayTracer::IsFlat() const
{
  return this->Internal->Flat;
}

//------------------------------------------------------------------------------
int vtkShadowRayTracer::Update(const vtkShadowCasters& casters, const Options& options)
{
  Internals& my = *this->Internal;
  int built = 0;
  my.Packet = options.Packet;
  my.Changed = my.Changed || !my.Scenes.empty();
  std::set<const vtkShadowMesh*> distinct;
  for (const auto& caster : casters.Get())
  {
    distinct.insert(caster.Mesh.get());
  }
  my.Flat = options.Structure == Structure::Flat ||
            (options.Structure == Structure::Automatic && !my.Changed &&
              distinct.size() == casters.Get().size());
  my.ReleaseScenes();
  std::vector<double> opacities = casters.GetOpacities();
  opacities.push_back(1.0);
  for (const double opacity : opacities)
  {
    my.Scenes[opacity] = rtcNewScene(my.Device);
    rtcSetSceneFlags(my.Scenes[opacity], RTC_SCENE_FLAG_ROBUST);
  }
  for (auto& entry : my.Meshes)
  {
    entry.second.Used = false;
  }
  for (const auto& caster : casters.Get())
  {
    if (caster.Mesh->Indices.empty())
    {
      continue;
    }
    auto& mesh = my.Meshes[caster.Mesh]; // also keeps what flat structures point to
    mesh.Used = true;
    if (my.Flat)
    {
      ++built;
    }
    else if (!mesh.Scene)
    {
      mesh.Scene = my.MakeMeshScene(*caster.Mesh);
      ++built;
    }
    RTCGeometry geometry = my.Flat ? my.MakePlaced(caster) : my.MakeInstance(caster, mesh.Scene);
    for (auto& entry : my.Scenes)
    {
      if (caster.Opacity >= entry.first)
      {
        rtcAttachGeometry(entry.second, geometry);
      }
    }
    rtcReleaseGeometry(geometry);
  }
  for (auto& entry : my.Scenes)
  {
    rtcCommitScene(entry.second);
  }
  for (auto entry = my.Meshes.begin(); entry != my.Meshes.end();)
  {
    if (entry->second.Used)
    {
      ++entry;
      continue;
    }
    entry->second.Release();
    entry = my.Meshes.erase(entry);
  }
  return built;
}

//------------------------------------------------------------------------------
bool vtkShadowRayTracer::NeedsRays(
  const vtkShadowLight& light, const glm::dvec3& origin, const vtkShadowRayReceiver& receiver)
{
  if (!receiver.Casts)
  {
    return true;
  }
  // As shadowFacesAway in vtkShadowLightsFS.glsl.
  const double u = std::abs(glm::dot(receiver.Normal, light.U));
  const double v = std::abs(glm::dot(receiver.Normal, light.V));
  double reach = std::sqrt(u * u + v * v);
  if (light.Kind == vtkShadowLight::Shape::Sphere)
  {
    reach = glm::length(light.U);
  }
  else if (light.Kind == vtkShadowLight::Shape::Rectangle)
  {
    reach = u + v;
  }
  const glm::dvec3 towards =
    light.IsDirectional() ? -light.Direction : light.Position - origin - receiver.Position;
  return glm::dot(receiver.Normal, towards) + reach >= 0.0;
}

//------------------------------------------------------------------------------
void vtkShadowRayTracer::FindPositions(
  std::vector<vtkShadowRayReceiver>& receivers, const std::function<Ray(int pixel)>& getRay) const
{
  RTCScene scene = this->Internal->Scenes.begin()->second; // of all casters
  for (vtkShadowRayReceiver& receiver : receivers)
  {
    if (!receiver.Casts || receiver.Height == 0.0)
    {
      continue;
    }
    const auto [from, along] = getRay(receiver.Pixel);
    // Along the ray a surface that is seen at a slant is further off; not without end.
    const double slant = std::max(std::abs(glm::dot(receiver.Normal, along)), 1.0 / 64.0);
    const double reach = 4.0 * receiver.Height / slant;
    const double first = glm::dot(receiver.Position - from, along) - reach;
    const glm::vec3 start(from + first * along);
    RTCRayHit ray{};
    ray.ray.org_x = start.x;
    ray.ray.org_y = start.y;
    ray.ray.org_z = start.z;
    ray.ray.dir_x = static_cast<float>(along.x);
    ray.ray.dir_y = static_cast<float>(along.y);
    ray.ray.dir_z = static_cast<float>(along.z);
    ray.ray.tfar = static_cast<float>(2.0 * reach);
    ray.ray.mask = 0xffffffffu;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
    const glm::dvec3 found = from + (first + ray.ray.tfar) * along;
    if (ray.hit.geomID != RTC_INVALID_GEOMETRY_ID &&
        glm::length(found - receiver.Position) <= 2.0 * reach)
    {
      receiver.Position = found;
      receiver.Height = 0.0;
    }
  }
}

//------------------------------------------------------------------------------
double vtkShadowRayTracer::Trace(const Target& target,
  const std::vector<vtkShadowRayReceiver>& receivers, const std::vector<int>& chosen, int samples,
  std::vector<vtkShadowRaySeen>& seen)
{
  const vtkShadowLight& light = target.Part.Light;
  Internals& my = *this->Internal;
  const bool point = light.IsPoint();
  my.Patterns.Update(light, point ? std::vector<int>{ 1 } : target.Steps, target.Seed);
  const int wanted = point ? 1 : samples;
  // That of 1 is always there.
  RTCScene scene = my.Scenes.lower_bound(target.Part.LeastOpacity)->second;
  const glm::dvec3 place =
    light.IsDirectional() ? -light.Direction : light.Position - target.Origin;
  const vtkShadowRayPackets packets{ scene, my.Flat, light, place, target.Origin, my.Patterns,
    receivers, seen };
  std::atomic<std::size_t> traced{ 0 };
  vtkShadowRayTracer::ForAll(chosen.size(), 256,
    [&](std::size_t first, std::size_t end)
    { traced += packets.Trace(my.Packet, chosen.data() + first, chosen.data() + end, wanted); });
  return static_cast<double>(traced);
}

//------------------------------------------------------------------------------
void vtkShadowRayTracer::ForAll(std::size_t count, std::size_t grain,
  const std::function<void(std::size_t first, std::size_t end)>& function)
{
  // In an arena of this call's own: vtkSMPTools' backend is the whole program's, and may be one thread.
  using Range = tbb::blocked_range<std::size_t>;
  tbb::task_arena arena;
  arena.execute(
    [&]()
    {
      tbb::parallel_for(Range(0, count, grain),
        [&function](const Range& range) { function(range.begin(), range.end()); });
    });
}
