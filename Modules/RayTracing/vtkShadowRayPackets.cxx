// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRayPackets.h"

#include "vtkShadowLight.h"
#include "vtkShadowRayBundle.h"
#include "vtkShadowRayTracer.h"

#include <algorithm>

namespace
{
///@{ Embree's packets under one name.
struct Packet1
{
  static constexpr int Size = 1;
  struct Rays
  {
    float org_x[1], org_y[1], org_z[1], tnear[1], dir_x[1], dir_y[1], dir_z[1], time[1], tfar[1];
    unsigned int mask[1], id[1], flags[1];
  };
  static_assert(sizeof(Rays) == sizeof(RTCRay), "as Embree's own");
  static void Trace(const int* valid, RTCScene scene, RTCIntersectContext* context, Rays* rays)
  {
    if (*valid)
    {
      rtcOccluded1(scene, context, reinterpret_cast<RTCRay*>(rays));
    }
  }
};
struct Packet4
{
  static constexpr int Size = 4;
  using Rays = RTCRay4;
  static void Trace(const int* valid, RTCScene scene, RTCIntersectContext* context, Rays* rays)
  {
    rtcOccluded4(valid, scene, context, rays);
  }
};
struct Packet8
{
  static constexpr int Size = 8;
  using Rays = RTCRay8;
  static void Trace(const int* valid, RTCScene scene, RTCIntersectContext* context, Rays* rays)
  {
    rtcOccluded8(valid, scene, context, rays);
  }
};
struct Packet16
{
  static constexpr int Size = 16;
  using Rays = RTCRay16;
  static void Trace(const int* valid, RTCScene scene, RTCIntersectContext* context, Rays* rays)
  {
    rtcOccluded16(valid, scene, context, rays);
  }
};
///@}

/** Rays that wait for their packet to be full. */
template <typename Packet>
class Waiting
{
public:
  Waiting(RTCScene scene, bool flat, std::vector<vtkShadowRaySeen>& seen)
    : Scene(scene)
    , Seen(seen)
  {
    rtcInitIntersectContext(&this->Context);
    // Embree 3.13 does not come back from some coherent packets of 16 through instances.
    this->Context.flags =
      flat ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    std::fill_n(this->Rays.time, Packet::Size, 0.0f);
    std::fill_n(this->Rays.mask, Packet::Size, 0xffffffffu);
    std::fill_n(this->Rays.flags, Packet::Size, 0u);
  }

  void Add(const vtkShadowRayBundle& bundle, int receiver, int sample)
  {
    const int i = this->Count++;
    const vtkShadowRayBundle::Ray ray = bundle.GetRay(sample);
    this->Rays.org_x[i] = bundle.GetStart().x;
    this->Rays.org_y[i] = bundle.GetStart().y;
    this->Rays.org_z[i] = bundle.GetStart().z;
    this->Rays.dir_x[i] = ray.Direction.x;
    this->Rays.dir_y[i] = ray.Direction.y;
    this->Rays.dir_z[i] = ray.Direction.z;
    this->Rays.tnear[i] = ray.Near;
    this->Rays.tfar[i] = ray.Far;
    this->Valid[i] = ray.Needed ? -1 : 0;
    this->Emission[i] = bundle.GetEmission(sample);
    this->Receivers[i] = receiver;
    if (this->Count == Packet::Size)
    {
      this->Trace();
    }
  }

  void Trace()
  {
    if (this->Count == 0)
    {
      return;
    }
    std::fill(this->Valid + this->Count, this->Valid + Packet::Size, 0);
    Packet::Trace(this->Valid, this->Scene, &this->Context, &this->Rays);
    for (int i = 0; i < this->Count; ++i)
    {
      this->Seen[this->Receivers[i]].Add(this->Rays.tfar[i] >= 0.0f, this->Emission[i]);
    }
    this->Count = 0;
  }

private:
  RTCScene Scene;
  std::vector<vtkShadowRaySeen>& Seen;
  RTCIntersectContext Context;
  alignas(64) int Valid[Packet::Size];
  alignas(64) typename Packet::Rays Rays{};
  int Receivers[Packet::Size];
  const glm::vec3* Emission[Packet::Size];
  int Count = 0;
};
}

//------------------------------------------------------------------------------
template <typename Packet>
std::size_t vtkShadowRayPackets::TraceBy(const int* first, const int* end, int samples) const
{
  std::size_t rays = 0;
  Waiting<Packet> waiting(this->Scene, this->Flat, this->Seen);
  for (const int* chosen = first; chosen != end; ++chosen)
  {
    const vtkShadowRayReceiver& receiver = this->Receivers[*chosen];
    const int before = this->Seen[*chosen].Samples;
    if (before < samples && vtkShadowRayTracer::NeedsRays(this->Light, this->Origin, receiver))
    {
      const vtkShadowRayBundle bundle(this->Light, this->Place, receiver, this->Patterns);
      for (int sample = before; sample < samples; ++sample)
      {
        waiting.Add(bundle, *chosen, sample);
      }
      waiting.Trace();
      rays += static_cast<std::size_t>(samples - before);
    }
  }
  waiting.Trace();
  return rays;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowRayPackets::Trace(
  int packet, const int* first, const int* end, int samples) const
{
  // Rays of one receiver alone: those of several part too early.
  const int rays = first == end ? 0 : samples - this->Seen[*first].Samples;
  switch (std::min(packet, rays <= 4 ? 4 : (rays <= 8 ? 8 : 16)))
  {
    case 1:
      return this->TraceBy<Packet1>(first, end, samples);
    case 4:
      return this->TraceBy<Packet4>(first, end, samples);
    case 8:
      return this->TraceBy<Packet8>(first, end, samples);
    default:
      return this->TraceBy<Packet16>(first, end, samples);
  }
}
