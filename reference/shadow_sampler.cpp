#include "reference/shadow_sampler.h"

#include "reference/shadow_packet.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace umbrameter {

namespace {

/// The lanes of a batch as packets; everything but direction and end stays from ray to ray.
template <int Width>
class Tracer {
 public:
  Tracer(const EmbreeScene& embree, const glm::vec3& origin_world) : scene_(embree.handle()) {
    rtcInitIntersectContext(&context_);
    context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    std::fill_n(ray_.org_x, Width, origin_world.x);
    std::fill_n(ray_.org_y, Width, origin_world.y);
    std::fill_n(ray_.org_z, Width, origin_world.z);
    std::fill_n(ray_.tnear, Width, 0.0f);
    std::fill_n(ray_.time, Width, 0.0f);
    std::fill_n(ray_.mask, Width, ~0u);
    std::fill_n(ray_.id, Width, 0u);
    std::fill_n(ray_.flags, Width, 0u);
  }

  /// seen[i] = 1 where lane i is facing and nothing is in its way.
  void trace(const ShadowRayBatch& batch, std::array<float, kBatch>& seen) {
    for (uint32_t first = 0; first < kBatch; first += Width) {
      std::memcpy(ray_.dir_x, &batch.direction_x[first], sizeof ray_.dir_x);
      std::memcpy(ray_.dir_y, &batch.direction_y[first], sizeof ray_.dir_y);
      std::memcpy(ray_.dir_z, &batch.direction_z[first], sizeof ray_.dir_z);
      std::memcpy(ray_.tfar, &batch.end[first], sizeof ray_.tfar);
      const int32_t* valid = &batch.is_facing[first];
      if (std::none_of(valid, valid + Width, [](int32_t v) { return v != 0; })) {
        std::fill_n(&seen[first], Width, 0.0f);
        continue;
      }
      ShadowPacket<Width>::occluded(valid, scene_, &context_, &ray_);
      for (int i = 0; i < Width; ++i) {
        // An occluded ray's tfar is -infinity.
        seen[first + static_cast<uint32_t>(i)] = valid[i] != 0 && ray_.tfar[i] >= 0.0f ? 1.0f : 0.0f;
      }
    }
  }

 private:
  RTCScene scene_;
  RTCIntersectContext context_;
  typename ShadowPacket<Width>::Ray ray_;
};

/// Lanes past the end of the set neither see nor weigh.
void cut_batch(ShadowRayBatch& batch, uint32_t lanes) {
  for (uint32_t i = lanes; i < kBatch; ++i) {
    batch.is_facing[i] = 0;
    batch.weight[i] = 0.0f;
  }
}

template <int Width>
void extend_replicate(Tracer<Width>& tracer, const LightPatch& patch, const SampleStream& stream,
                      uint32_t begin, uint32_t end, ReplicateSums& sums) {
  ShadowRayBatch batch;
  alignas(64) std::array<float, kBatch> seen;
  // Lanes are summed apart in float: counts stay exact and weights lose less than 1e-6 over the lanes' share.
  alignas(64) std::array<float, kBatch> lane_seen{};
  alignas(64) std::array<float, kBatch> lane_weight{};
  alignas(64) std::array<float, kBatch> lane_weight_seen{};
  for (uint32_t first = begin; first < end; first += kBatch) {
    make_shadow_rays(patch, stream, first, batch);
    if (end - first < kBatch) cut_batch(batch, end - first);
    tracer.trace(batch, seen);
    for (uint32_t i = 0; i < kBatch; ++i) {
      lane_seen[i] += seen[i];
      lane_weight[i] += batch.weight[i];
      lane_weight_seen[i] += batch.weight[i] * seen[i];
    }
  }
  for (uint32_t i = 0; i < kBatch; ++i) {
    sums.seen += static_cast<uint32_t>(lane_seen[i]);
    sums.weight += static_cast<double>(lane_weight[i]);
    sums.weight_seen += static_cast<double>(lane_weight_seen[i]);
  }
}

template <int Width>
void extend_pixel(const EmbreeScene& embree, const glm::vec3& origin_world, const LightPatch& patch,
                  const SampleSets& sets, uint32_t seed, uint32_t points, PixelSums& sums) {
  Tracer<Width> tracer(embree, origin_world);
  for (uint32_t r = 0; r < kReplicates; ++r) {
    extend_replicate(tracer, patch, sets.stream(seed, r), sums.points, points, sums.replicates[r]);
  }
}

}  // namespace

void sample_pixel(const EmbreeScene& embree, const glm::vec3& origin_world, const LightPatch& patch,
                  const SampleSets& sets, uint32_t seed, uint32_t points, PixelSums& sums) {
  switch (embree.packet_width()) {
    case 16:
      extend_pixel<16>(embree, origin_world, patch, sets, seed, points, sums);
      break;
    case 8:
      extend_pixel<8>(embree, origin_world, patch, sets, seed, points, sums);
      break;
    default:
      extend_pixel<4>(embree, origin_world, patch, sets, seed, points, sums);
  }
  sums.points = points;
}

PixelEstimate estimate_pixel(const PixelSums& sums) {
  PixelEstimate estimate;
  if (sums.points == 0) return estimate;
  constexpr int kHalf = kReplicates / 2;
  std::array<double, kReplicates> means;
  double weight = 0.0, weight_seen = 0.0;
  for (size_t r = 0; r < kReplicates; ++r) {
    means[r] = static_cast<double>(sums.replicates[r].seen) / sums.points;
    (r < kHalf ? estimate.half_a : estimate.half_b) += means[r] / kHalf;
    weight += sums.replicates[r].weight;
    weight_seen += sums.replicates[r].weight_seen;
  }
  estimate.visibility = 0.5 * (estimate.half_a + estimate.half_b);
  double squares = 0.0;
  for (const double mean : means) squares += (mean - estimate.visibility) * (mean - estimate.visibility);
  estimate.sample_count = kReplicates * sums.points;
  // Samples that all agree do not prove certainty: an occluder thinner than a stratum can hide from them.
  const double floor = 0.5 / estimate.sample_count;
  estimate.visibility_se = std::max(floor, std::sqrt(squares / (kReplicates * (kReplicates - 1))));
  estimate.irradiance_ratio = weight > 0.0 ? weight_seen / weight : 0.0;
  estimate.unshadowed_irradiance = weight / estimate.sample_count;
  return estimate;
}

}  // namespace umbrameter
