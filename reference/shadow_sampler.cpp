#include "reference/shadow_sampler.h"

#include "reference/shadow_packet.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

/// Traces the batch in packets of the device's own width.
template <int Width>
void trace_in_packets(RTCScene scene, RTCIntersectContext& context, ShadowRayBatch& batch) {
  for (uint32_t first = 0; first < kBatch; first += Width) {
    typename ShadowPacket<Width>::Ray part = slice<Width>(batch.rays, first);
    ShadowPacket<Width>::occluded(&batch.is_facing[first], scene, &context, &part);
    std::copy_n(part.tfar, Width, batch.rays.tfar + first);
  }
}

void trace(const EmbreeScene& embree, RTCIntersectContext& context, ShadowRayBatch& batch) {
  switch (embree.packet_width()) {
    case 16:
      rtcOccluded16(batch.is_facing.data(), embree.handle(), &context, &batch.rays);
      break;
    case 8:
      trace_in_packets<8>(embree.handle(), context, batch);
      break;
    default:
      trace_in_packets<4>(embree.handle(), context, batch);
  }
}

}  // namespace

void sample_pixel(const EmbreeScene& embree, const glm::vec3& origin_world, const LightPatch& patch,
                  const SampleSets& sets, uint32_t seed, uint32_t points, PixelSums& sums) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  // The rays of a batch share their origin and lie close together on the light.
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  ShadowRayBatch batch(origin_world);
  for (uint32_t r = 0; r < kReplicates; ++r) {
    const SampleStream stream = sets.stream(seed, r);
    LaneSums lanes;
    for (uint32_t first = sums.points; first < points; first += kBatch) {
      make_shadow_rays(patch, stream, first, points, batch);
      if (batch.any_facing) trace(embree, context, batch);
      add_rays(batch, lanes);
    }
    add_lanes(lanes, sums.replicates[r]);
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
  return estimate;
}

}  // namespace umbrameter
