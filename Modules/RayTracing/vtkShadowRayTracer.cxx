// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRayTracer.h"

#include "vtkShadowCasters.h"
#include "vtkShadowLight.h"
#include "vtkShadowSampling.h"

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>

namespace
{
/** Rays of one pixel go in packets; Embree splits them where the CPU is narrower. */
constexpr int PacketSize = 8;

/**
 * Sampling patterns, shared by pixels that hash to the same one: scrambled Sobol points, mapped to
 * the shape's own square or disk [-1,1]^2 once, so that a sample costs two reads.
 */
struct Patterns
{
  static constexpr int Count = 256;

  Patterns(const vtkShadowLight& light, int samples, int seed)
    : Samples(samples)
    , Seed(static_cast<std::uint32_t>(seed))
  {
    const bool rectangle = light.Kind == vtkShadowLight::Shape::Rectangle;
    const auto points = vtkShadowSampling::Sobol(samples);
    this->A.reserve(static_cast<std::size_t>(Count) * samples);
    this->B.reserve(this->A.capacity());
    for (int pattern = 0; pattern < Count; ++pattern)
    {
      const std::uint32_t x = vtkShadowSampling::Hash(2 * (this->Seed * Count + pattern) + 1);
      const std::uint32_t y = vtkShadowSampling::Hash(2 * (this->Seed * Count + pattern) + 2);
      glm::dvec3 sum(0.0);
      for (const auto& point : points)
      {
        const glm::dvec2 unit = vtkShadowSampling::ToUnit({ point.X ^ x, point.Y ^ y });
        const glm::dvec2 p = rectangle ? 2.0 * unit - 1.0 : vtkShadowSampling::ConcentricDisk(unit);
        this->A.push_back(static_cast<float>(p.x));
        this->B.push_back(static_cast<float>(p.y));
        if (light.Emission)
        {
          this->Weights.push_back(light.GetEmission(unit));
          sum += this->Weights.back();
        }
      }
      for (int i = 0; light.Emission && i < samples; ++i)
      {
        glm::dvec3& weight = this->Weights[static_cast<std::size_t>(pattern) * samples + i];
        for (int c = 0; c < 3; ++c)
        {
          weight[c] = sum[c] > 0.0 ? weight[c] / sum[c] : 1.0 / samples;
        }
      }
    }
  }

  int Samples;
  std::uint32_t Seed; // another seed, other patterns for all pixels
  std::vector<float> A;
  std::vector<float> B;
  std::vector<glm::dvec3> Weights; // with an emission texture only
};
}

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
    RTCScene Scene = nullptr;
    bool Used = false;
  };

  RTCDevice Device = nullptr;
  std::map<double, RTCScene> Scenes; // of casters of this opacity and more
  std::string Error;
  std::map<std::shared_ptr<const vtkShadowMesh>, MeshScene> Meshes;

  RTCScene MakeMeshScene(const vtkShadowMesh& mesh)
  {
    RTCScene scene = rtcNewScene(this->Device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
      mesh.Positions.data(), 0, 3 * sizeof(float), mesh.GetNumberOfVertices());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
      mesh.Indices.data(), 0, 3 * sizeof(std::uint32_t), mesh.GetNumberOfTriangles());
    if (mesh.Holes)
    {
      rtcSetGeometryUserData(geometry, const_cast<vtkShadowMesh*>(&mesh));
      rtcSetGeometryOccludedFilterFunction(geometry, PassHoles);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
  }

  void ReleaseScenes()
  {
    for (auto& entry : this->Scenes)
    {
      rtcReleaseScene(entry.second);
    }
    this->Scenes.clear();
  }

  /** Visibility of one receiver. */
  glm::dvec3 TracePixel(RTCScene scene, const vtkShadowLight& light, const glm::dvec3& place,
    const Receiver& receiver, const Patterns& patterns) const;
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
    rtcReleaseScene(entry.second.Scene);
  }
  this->Internal->Meshes.clear();
}

//------------------------------------------------------------------------------
int vtkShadowRayTracer::Update(const vtkShadowCasters& casters)
{
  Internals& my = *this->Internal;
  int built = 0;
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
    auto& mesh = my.Meshes[caster.Mesh];
    if (!mesh.Scene)
    {
      mesh.Scene = my.MakeMeshScene(*caster.Mesh);
      ++built;
    }
    mesh.Used = true;
    RTCGeometry instance = rtcNewGeometry(my.Device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, mesh.Scene);
    const glm::mat4 matrix(caster.MeshToSWC);
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, glm::value_ptr(matrix));
    rtcCommitGeometry(instance);
    for (auto& entry : my.Scenes)
    {
      if (caster.Opacity >= entry.first)
      {
        rtcAttachGeometry(entry.second, instance);
      }
    }
    rtcReleaseGeometry(instance);
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
    rtcReleaseScene(entry->second.Scene);
    entry = my.Meshes.erase(entry);
  }
  return built;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkShadowRayTracer::Internals::TracePixel(RTCScene scene, const vtkShadowLight& light,
  const glm::dvec3& place, const Receiver& receiver, const Patterns& patterns) const
{
  const std::uint32_t hash = vtkShadowSampling::Hash(
    static_cast<std::uint32_t>(receiver.Pixel) ^ (0x9e3779b9u * (patterns.Seed + 1)));
  const std::size_t first =
    static_cast<std::size_t>(hash % Patterns::Count) * static_cast<std::size_t>(patterns.Samples);

  // Half axes as this receiver sees them, relative to where its rays start.
  const glm::dvec3 start = receiver.Position + receiver.Offset * receiver.Normal;
  glm::dvec3 centre = light.IsDirectional() ? place : place - start;
  glm::dvec3 u = light.U;
  glm::dvec3 v = light.V;
  if (light.Kind == vtkShadowLight::Shape::Sphere)
  {
    // Map gives the disk that faces the receiver; its axes are two of its points.
    u = light.Map({ 1.0, 0.5 }, receiver.Position + (light.Position - place)) - light.Position;
    v = light.Map({ 0.5, 1.0 }, receiver.Position + (light.Position - place)) - light.Position;
  }
  if (light.Kind != vtkShadowLight::Shape::Rectangle)
  {
    // Disks are turned besides, so that pixels of the same pattern differ.
    const double angle = glm::two_pi<double>() * (hash >> 8) / 16777216.0;
    const glm::dvec3 turned = std::cos(angle) * u + std::sin(angle) * v;
    v = std::cos(angle) * v - std::sin(angle) * u;
    u = turned;
  }

  alignas(32) int valid[PacketSize];
  RTCRay8 rays;
  for (int i = 0; i < PacketSize; ++i)
  {
    rays.org_x[i] = static_cast<float>(start.x);
    rays.org_y[i] = static_cast<float>(start.y);
    rays.org_z[i] = static_cast<float>(start.z);
  }
  const glm::vec3 c(centre);
  const glm::vec3 a(u);
  const glm::vec3 b(v);
  // Rays rise from the receiver's plane: past Height it is not its own surface that they hit. Moving
  // their start as far along the normal would move the shadow's edge.
  const glm::vec3 normal(receiver.Normal);
  const float height = receiver.Casts ? static_cast<float>(receiver.Height) : 0.0f;
  // A ray of a positional light ends at the light, t = 1.
  const float end = light.IsDirectional() ? std::numeric_limits<float>::infinity() : 1.0f;
  glm::dvec3 visible(0.0);
  int clear = 0;
  for (int base = 0; base < patterns.Samples; base += PacketSize)
  {
    const int count = std::min(PacketSize, patterns.Samples - base);
    for (int i = 0; i < PacketSize; ++i)
    {
      const std::size_t sample = first + base + std::min(i, count - 1);
      const glm::vec3 direction = c + patterns.A[sample] * a + patterns.B[sample] * b;
      valid[i] = i < count ? -1 : 0;
      rays.dir_x[i] = direction.x;
      rays.dir_y[i] = direction.y;
      rays.dir_z[i] = direction.z;
      rays.tnear[i] = 0.0f;
      rays.tfar[i] = end;
      if (height > 0.0f)
      {
        const float rise = glm::dot(normal, direction);
        rays.tnear[i] = height / std::max(rise, std::numeric_limits<float>::min());
        valid[i] = rays.tnear[i] < end ? valid[i] : 0;
        rays.tfar[i] =
          rise > 0.0f ? end : -end; // its own surface hides what lies below its horizon
      }
      rays.time[i] = 0.0f;
      rays.mask[i] = 0xffffffffu;
      rays.flags[i] = 0;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded8(valid, scene, &context, &rays);
    for (int i = 0; i < count; ++i)
    {
      if (rays.tfar[i] >= 0.0f)
      {
        ++clear;
        if (!patterns.Weights.empty())
        {
          visible += patterns.Weights[first + base + i];
        }
      }
    }
  }
  return patterns.Weights.empty() ? glm::dvec3(static_cast<double>(clear) / patterns.Samples)
                                  : visible;
}

//------------------------------------------------------------------------------
bool vtkShadowRayTracer::NeedsRays(
  const vtkShadowLight& light, const glm::dvec3& origin, const Receiver& receiver)
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
  std::vector<Receiver>& receivers, const std::function<Ray(int pixel)>& getRay) const
{
  RTCScene scene = this->Internal->Scenes.begin()->second; // of all casters
  for (Receiver& receiver : receivers)
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
    if (ray.hit.geomID != RTC_INVALID_GEOMETRY_ID)
    {
      receiver.Position = from + (first + ray.ray.tfar) * along;
      receiver.Height = 0.0;
    }
  }
}

//------------------------------------------------------------------------------
double vtkShadowRayTracer::Trace(const vtkShadowLightPart& part, const glm::dvec3& origin,
  const std::vector<Receiver>& receivers, int samples, int seed, int components,
  std::vector<float>& visibility) const
{
  const vtkShadowLight& light = part.Light;
  const Internals& my = *this->Internal;
  RTCScene scene = my.Scenes.lower_bound(part.LeastOpacity)->second; // that of 1 is always there
  const Patterns patterns(light, light.IsPoint() ? 1 : samples, seed);
  const glm::dvec3 place = light.IsDirectional() ? -light.Direction : light.Position - origin;
  std::atomic<std::size_t> traced{ 0 };
  const auto work = [&](const tbb::blocked_range<std::size_t>& range)
  {
    std::size_t pixels = 0;
    for (std::size_t i = range.begin(); i < range.end(); ++i)
    {
      const Receiver& receiver = receivers[i];
      glm::dvec3 visible(0.0);
      if (vtkShadowRayTracer::NeedsRays(light, origin, receiver))
      {
        visible = my.TracePixel(scene, light, place, receiver, patterns);
        ++pixels;
      }
      float* target = &visibility[static_cast<std::size_t>(components) * receiver.Pixel];
      for (int c = 0; c < std::min(components, 3); ++c)
      {
        target[c] = static_cast<float>(visible[c]);
      }
    }
    traced += pixels;
  };
  // All cores, in an arena of this call's own: vtkSMPTools' backend is the whole program's, and may be
  // one thread.
  tbb::task_arena arena;
  arena.execute(
    [&]() { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, receivers.size(), 256), work); });
  return static_cast<double>(traced) * patterns.Samples;
}
