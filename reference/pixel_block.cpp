// SPDX-License-Identifier: Apache-2.0
#include "reference/pixel_block.h"

#include "reference/shadow_sampler.h"

#include <algorithm>
#include <array>

namespace umbrameter {

namespace {

static_assert(kShafts == kBlock * kBlock);

using Proofs = std::array<LightProof, kShafts>;

struct PixelSamples {
  PixelSums sums;
  std::array<PixelSums, 2> kept;  // by half: the sums when it stopped
};

struct Block {
  const BlockPixels& pixels;
  Proofs proofs;
  std::array<PixelSamples, kShafts> samples;
};

Proofs prove(const BlockJob& job, const BlockPixels& pixels, bool all_lit) {
  if (!all_lit) return prove_light(job.occluders, job.scene, job.scene_extent_world, pixels.shafts);
  Proofs proofs;
  proofs.fill(LightProof::lit);
  return proofs;
}

bool is_settled(const BlockJob& job, Half judge, const Block& block) {
  for (size_t i = 0; i < block.pixels.shafts.size(); ++i) {
    if (block.proofs[i] != LightProof::none) continue;
    if (!job.target_se || standard_error_by(judge, block.samples[i].sums) > *job.target_se) return false;
  }
  return true;
}

/// A half that stopped by what its own samples look like would be biased: those that agree by chance stop early. So each
/// half stops when the other one says so. What it is sampled after that only serves to judge the other.
void sample_block(const BlockJob& job, Block& block) {
  const size_t count = block.pixels.shafts.size();
  std::array<bool, 2> has_stopped{};
  uint32_t points = job.target_se ? std::min(kFirstRound, job.sets.points()) : job.sets.points();
  for (;;) {
    for (size_t i = 0; i < count; ++i) {
      if (job.skip_proven && block.proofs[i] != LightProof::none) continue;
      const ShaftPixel& shaft = block.pixels.shafts[i];
      sample_pixel(job.embree, shaft.ray_origin_world, shaft.patch, job.sets,
                   pixel_seed(job.seed, block.pixels.indices[i]), points, block.samples[i].sums);
    }
    const bool is_last = points == job.sets.points();
    for (size_t half = 0; half < 2; ++half) {
      if (has_stopped[half]) continue;
      if (!is_last && !is_settled(job, half == 0 ? Half::b : Half::a, block)) continue;
      has_stopped[half] = true;
      for (size_t i = 0; i < count; ++i) block.samples[i].kept[half] = block.samples[i].sums;
    }
    if (has_stopped[0] && has_stopped[1]) return;
    points = std::min(2 * points, job.sets.points());
  }
}

PixelEstimate proven_estimate(LightProof proof, const LightPatch& patch) {
  PixelEstimate estimate;
  if (proof != LightProof::lit) return estimate;
  estimate.visibility = estimate.half_a = estimate.half_b = 1.0;
  estimate.irradiance_ratio = is_unlit(patch) ? 0.0 : 1.0;
  estimate.irradiance_half_a = estimate.irradiance_half_b = estimate.irradiance_ratio;
  return estimate;
}

PixelEstimate sampled_estimate(LightProof proof, const PixelSamples& samples) {
  PixelEstimate estimate = estimate_pixel(samples.kept[0], samples.kept[1]);
  estimate.sample_count = kReplicates * samples.sums.points;
  if (proof != LightProof::none) estimate.visibility_se = estimate.irradiance_ratio_se = 0.0;
  return estimate;
}

void write(const BlockJob& job, const BlockPixels& pixels, size_t i, const PixelEstimate& estimate,
           ReferencePlanes& planes) {
  const uint32_t index = pixels.indices[i];
  planes.write_light(index, estimate);
  if (!job.probe_blockers || estimate.visibility >= 1.0) return;
  const ShaftPixel& shaft = pixels.shafts[i];
  const ProbeJob probe{job.embree, job.light, shaft.patch, shaft.ray_origin_world, shaft.n_geometric_world};
  planes.write_blockers(index, probe_blockers(probe, job.sets, pixel_seed(job.seed, index)));
}

void write_proven(const BlockJob& job, const BlockPixels& pixels, size_t i, LightProof proof,
                  ReferencePlanes& planes) {
  const PixelEstimate estimate = proven_estimate(proof, pixels.shafts[i].patch);
  if (estimate.irradiance_ratio < 1.0) write(job, pixels, i, estimate, planes);  // else as the background is
}

}  // namespace

void render_block(const BlockJob& job, const BlockPixels& pixels, bool all_lit, ReferencePlanes& planes) {
  const size_t count = pixels.shafts.size();
  const Proofs proofs = prove(job, pixels, all_lit);
  const auto is_proven = [](LightProof proof) { return proof != LightProof::none; };
  if (job.skip_proven && std::all_of(proofs.begin(), proofs.begin() + count, is_proven)) {
    for (size_t i = 0; i < count; ++i) write_proven(job, pixels, i, proofs[i], planes);
    return;
  }
  Block block{pixels, proofs, {}};
  sample_block(job, block);
  for (size_t i = 0; i < count; ++i) {
    if (block.samples[i].sums.points == 0) {
      write_proven(job, pixels, i, proofs[i], planes);
    } else {
      write(job, pixels, i, sampled_estimate(proofs[i], block.samples[i]), planes);
    }
  }
}

}  // namespace umbrameter
