// SPDX-License-Identifier: Apache-2.0
#include "reference/shadow_sampler.h"

#include "reference/shadow_packet.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

/// Packets of the device's own width for the batches of one pixel: what its rays share is copied once.
template <int Width>
class Tracer {
 public:
  Tracer(const EmbreeScene& embree, const ShadowRayBatch& batch) : scene_(embree.handle()) {
    rtcInitIntersectContext(&context_);
    context_.flags = embree.packet_flags();
    for (uint32_t i = 0; i < kPackets; ++i) packets_[i] = slice<Width>(batch.rays, i * Width);
  }

  void trace(ShadowRayBatch& batch) {
    for (uint32_t i = 0; i < kPackets; ++i) {
      const uint32_t first = i * Width;
      auto& packet = packets_[i];
      std::copy_n(batch.rays.dir_x + first, Width, packet.dir_x);
      std::copy_n(batch.rays.dir_y + first, Width, packet.dir_y);
      std::copy_n(batch.rays.dir_z + first, Width, packet.dir_z);
      std::copy_n(batch.rays.tfar + first, Width, packet.tfar);
      ShadowPacket<Width>::occluded(&batch.is_facing[first], scene_, &context_, &packet);
      std::copy_n(packet.tfar, Width, batch.rays.tfar + first);
    }
  }

 private:
  static constexpr uint32_t kPackets = kBatch / Width;
  RTCScene scene_;
  RTCIntersectContext context_;
  std::array<typename ShadowPacket<Width>::Ray, kPackets> packets_;
};

template <>
class Tracer<8> {
 public:
  Tracer(const EmbreeScene& embree, const ShadowRayBatch& batch)
      : scene_(embree.handle()), packets_{slice<8>(batch.rays, 0), slice<8>(batch.rays, 8)} {
    rtcInitIntersectContext(&context_);
    context_.flags = embree.packet_flags();
  }
  void trace(ShadowRayBatch& batch) {
    to_packets_of_8(batch, packets_);
    rtcOccluded8(&batch.is_facing[0], scene_, &context_, &packets_[0]);
    rtcOccluded8(&batch.is_facing[8], scene_, &context_, &packets_[1]);
    from_packets_of_8(packets_, batch);
  }

 private:
  RTCScene scene_;
  RTCIntersectContext context_;
  std::array<RTCRay8, 2> packets_;
};

/// The batch is a packet already.
template <>
class Tracer<16> {
 public:
  Tracer(const EmbreeScene& embree, const ShadowRayBatch&) : scene_(embree.handle()) {
    rtcInitIntersectContext(&context_);
    context_.flags = embree.packet_flags();
  }
  void trace(ShadowRayBatch& batch) { rtcOccluded16(batch.is_facing.data(), scene_, &context_, &batch.rays); }

 private:
  RTCScene scene_;
  RTCIntersectContext context_;
};

template <int Width>
void sample_in_packets(const EmbreeScene& embree, const glm::vec3& origin_world, const LightPatch& patch,
                       const SampleSets& sets, uint32_t seed, uint32_t points, PixelSums& sums) {
  ShadowRayBatch batch(origin_world);
  Tracer<Width> tracer(embree, batch);
  for (uint32_t r = 0; r < kReplicates; ++r) {
    const SampleStream stream = sets.stream(seed, r);
    LaneSums lanes;
    for (uint32_t first = sums.points; first < points; first += kBatch) {
      make_shadow_rays(patch, stream, first, points, batch);
      if (batch.any_facing) tracer.trace(batch);
      add_rays(batch, lanes);
    }
    add_lanes(lanes, sums.replicates[r]);
  }
  sums.points = points;
}

constexpr uint32_t kHalf = kReplicates / 2;

double mean_of(const PixelSums& sums, size_t replicate) {
  return static_cast<double>(sums.replicates[replicate].seen) / sums.points;
}

/// Samples that all agree do not prove certainty: an occluder thinner than a stratum can hide from them.
double least_error(uint32_t samples) {
  return 0.5 / samples;
}

}  // namespace

void sample_pixel(const EmbreeScene& embree, const glm::vec3& origin_world, const LightPatch& patch,
                  const SampleSets& sets, uint32_t seed, uint32_t points, PixelSums& sums) {
  switch (embree.packet_width()) {
    case 16:
      return sample_in_packets<16>(embree, origin_world, patch, sets, seed, points, sums);
    case 8:
      return sample_in_packets<8>(embree, origin_world, patch, sets, seed, points, sums);
    default:
      return sample_in_packets<4>(embree, origin_world, patch, sets, seed, points, sums);
  }
}

double standard_error_by(Half half, const PixelSums& sums) {
  const size_t first = half == Half::a ? 0 : kHalf;
  double mean = 0.0, squares = 0.0;
  for (size_t r = first; r < first + kHalf; ++r) mean += mean_of(sums, r) / kHalf;
  for (size_t r = first; r < first + kHalf; ++r) squares += std::pow(mean_of(sums, r) - mean, 2);
  const double spread = std::sqrt(squares / (kReplicates * (kHalf - 1)));
  return std::max(least_error(kReplicates * sums.points), spread);
}

namespace {

/// S of the whole and of its halves, and its standard error from the replicates' residuals (delta method of a ratio).
void estimate_irradiance(const std::array<ReplicateSums, kReplicates>& replicates, PixelEstimate& estimate) {
  std::array<double, 2> weight{}, seen{};
  for (size_t r = 0; r < kReplicates; ++r) {
    weight[r / kHalf] += replicates[r].weight;
    seen[r / kHalf] += replicates[r].weight_seen;
  }
  const double all = weight[0] + weight[1];
  if (!(weight[0] > 0.0 && weight[1] > 0.0)) return;
  estimate.irradiance_half_a = seen[0] / weight[0];
  estimate.irradiance_half_b = seen[1] / weight[1];
  estimate.irradiance_ratio = (seen[0] + seen[1]) / all;
  double squares = 0.0;
  for (const ReplicateSums& sums : replicates) {
    const double residual = sums.weight_seen - estimate.irradiance_ratio * sums.weight;
    squares += residual * residual;
  }
  const double spread = kReplicates / all * std::sqrt(squares / (kReplicates * (kReplicates - 1)));
  estimate.irradiance_ratio_se = std::max(least_error(estimate.sample_count), spread);
}

}  // namespace

PixelEstimate estimate_pixel(const PixelSums& a, const PixelSums& b) {
  PixelEstimate estimate;
  if (a.points == 0 || b.points == 0) return estimate;
  std::array<double, kReplicates> means;
  std::array<ReplicateSums, kReplicates> replicates;
  for (size_t r = 0; r < kReplicates; ++r) {
    const PixelSums& sums = r < kHalf ? a : b;
    means[r] = mean_of(sums, r);
    (r < kHalf ? estimate.half_a : estimate.half_b) += means[r] / kHalf;
    const double each = static_cast<double>(a.points) / sums.points;
    replicates[r] = {0, each * sums.replicates[r].weight, each * sums.replicates[r].weight_seen};
  }
  estimate.visibility = 0.5 * (estimate.half_a + estimate.half_b);
  // Right for replicates of unequal variance too, as long as they are independent.
  double squares = 0.0;
  for (const double mean : means) squares += (mean - estimate.visibility) * (mean - estimate.visibility);
  estimate.sample_count = kHalf * (a.points + b.points);
  estimate.visibility_se =
      std::max(least_error(estimate.sample_count), std::sqrt(squares / (kReplicates * (kReplicates - 1))));
  estimate_irradiance(replicates, estimate);
  return estimate;
}

}  // namespace umbrameter
