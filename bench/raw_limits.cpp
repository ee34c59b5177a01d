// SPDX-License-Identifier: Apache-2.0
#include "bench/raw_limits.h"

#include "core/clock.h"
#include "reference/primary_hit.h"
#include "reference/reference.h"
#include "reference/shadow_sampler.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace umbrameter {
namespace {

constexpr int kRuns = 5;

template <class Work>
double best_of(const Work& work) {
  double best_s = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRuns; ++i) {
    const double before_s = process_cpu_seconds();
    work();
    best_s = std::min(best_s, process_cpu_seconds() - before_s);
  }
  return best_s;
}

struct alignas(64) PrimaryPacket {
  std::array<int32_t, 16> valid;
  RTCRayHit16 rays;
};

PrimaryPacket primary_packet(const Scene& scene, const Image& frame, int x0, int y0) {
  PrimaryPacket packet{};
  packet.valid.fill(-1);
  for (int i = 0; i < 16; ++i) {
    const glm::dvec3 d = camera_ray_direction_world(scene.camera, {x0 + i % 4 + 0.5, y0 + i / 4 + 0.5},
                                                    frame.width, frame.height);
    RTCRay16& ray = packet.rays.ray;
    ray.org_x[i] = static_cast<float>(scene.camera.eye_world.x);
    ray.org_y[i] = static_cast<float>(scene.camera.eye_world.y);
    ray.org_z[i] = static_cast<float>(scene.camera.eye_world.z);
    ray.dir_x[i] = static_cast<float>(d.x);
    ray.dir_y[i] = static_cast<float>(d.y);
    ray.dir_z[i] = static_cast<float>(d.z);
    ray.tnear[i] = static_cast<float>(scene.camera.near_world);
    ray.mask[i] = ~0u;
  }
  return packet;
}

double primary_seconds(const EmbreeScene& embree, const Scene& scene, const Image& frame) {
  std::vector<PrimaryPacket> packets;
  for (int y = 0; y + 4 <= frame.height; y += 4) {
    for (int x = 0; x + 4 <= frame.width; x += 4) packets.push_back(primary_packet(scene, frame, x, y));
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = embree.primary_flags();
  return best_of([&] {
    for (PrimaryPacket& packet : packets) {
      std::fill_n(packet.rays.ray.tfar, 16, std::numeric_limits<float>::infinity());
      std::fill_n(packet.rays.hit.geomID, 16, RTC_INVALID_GEOMETRY_ID);
      rtcIntersect16(packet.valid.data(), embree.handle(), &context, &packet.rays);
    }
  });
}

struct ShadowPacketOf16 {
  ShadowRayBatch batch;
  std::array<float, kBatch> end;
};

/// The first samples of every replicate of about a thousand pixels that were sampled.
std::vector<ShadowPacketOf16> shadow_packets(const EmbreeScene& embree, const Scene& scene,
                                             const Image& frame) {
  const auto samples = frame.plane("sample_count");
  const auto sampled = std::ranges::count_if(samples, [](float n) { return n > 0.0f; });
  const auto stride = std::max<std::ptrdiff_t>(1, sampled / 1000);
  const PrimaryCamera camera(scene, frame.width, frame.height);
  const SampleSets sets(kBatch);
  std::vector<ShadowPacketOf16> packets;
  std::ptrdiff_t seen = 0;
  for (size_t i = 0; i < samples.size(); ++i) {
    if (samples[i] <= 0.0f || seen++ % stride != 0) continue;
    const int x = static_cast<int>(i) % frame.width, y = static_cast<int>(i) / frame.width;
    const PrimaryBlock hits = camera.hits(embree, x, y);
    if (!hits[0]) continue;
    const Receiver& receiver = hits[0]->receiver;
    const LightPatch patch = make_light_patch(scene.light(), receiver, scene.bounds_world.diagonal());
    for (uint32_t r = 0; r < kReplicates; ++r) {
      ShadowPacketOf16 packet{ShadowRayBatch(receiver.ray_origin_world), {}};
      make_shadow_rays(patch, sets.stream(pixel_seed(1, static_cast<uint32_t>(i)), r), 0, kBatch,
                       packet.batch);
      std::copy_n(packet.batch.rays.tfar, kBatch, packet.end.data());
      packets.push_back(packet);
    }
  }
  return packets;
}

double shadow_seconds(const EmbreeScene& embree, const Scene& scene, const Image& frame) {
  std::vector<ShadowPacketOf16> packets = shadow_packets(embree, scene, frame);
  if (packets.empty()) return 0.0;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = embree.packet_flags();
  const double some_s = best_of([&] {
    for (ShadowPacketOf16& packet : packets) {
      std::copy_n(packet.end.data(), kBatch, packet.batch.rays.tfar);
      rtcOccluded16(packet.batch.is_facing.data(), embree.handle(), &context, &packet.batch.rays);
    }
  });
  const auto samples = frame.plane("sample_count");
  const double rays = std::accumulate(samples.begin(), samples.end(), 0.0);
  return some_s * rays / static_cast<double>(packets.size() * kBatch);
}

}  // namespace

RawLimits raw_limits(const Scene& scene, const Image& frame) {
  EmbreeScene embree;
  embree.load(scene);
  return {primary_seconds(embree, scene, frame), shadow_seconds(embree, scene, frame)};
}

}  // namespace umbrameter
