#include "reference/pixel_block.h"

#include "reference/light_proof.h"
#include "reference/patch_irradiance.h"
#include "reference/shadow_sampler.h"
#include "scenes/near_light.h"

#include <algorithm>
#include <array>

namespace umbrameter {

namespace {

struct Pixel {
  size_t index = 0;
  uint32_t seed = 0;
  glm::vec3 ray_origin_world{0.0f};
  glm::vec3 n_geometric_world{0.0f};
  LightPatch patch;
  LightProof proof = LightProof::none;
  PixelSums sums;
  std::array<PixelSums, 2> kept;  // by half: the sums when it stopped
};

static_assert(kShafts == kBlock * kBlock);

struct Block {
  std::array<Pixel, kBlock * kBlock> pixels;
  size_t count = 0;
  std::span<Pixel> used() { return {pixels.data(), count}; }
};

/// Writes what is known without sampling; leaves the pixels that light can reach.
Block shoot_primary(const BlockJob& job, int x0, int y0, ReferencePlanes& planes) {
  Block block;
  for (int y = y0; y < std::min(y0 + kBlock, planes.height()); ++y) {
    for (int x = x0; x < std::min(x0 + kBlock, planes.width()); ++x) {
      const std::optional<PrimaryHit> hit = job.camera.hit(job.embree, x, y);
      if (!hit) continue;
      const uint32_t index = static_cast<uint32_t>(y * planes.width() + x);
      planes.write_surface(index, *hit);
      const Receiver& receiver = hit->receiver;
      const LightPatch patch = make_light_patch(job.light, receiver, job.scene_extent_world);
      if (is_below_horizon(patch) && is_unlit(patch)) {
        planes.write_light(index, {}, {});
        continue;
      }
      planes.write_unshadowed_irradiance(
          index, is_near_light(job.light, receiver.p_world)
                     ? near_irradiance(job.light, receiver.p_world, receiver.n_shading_world)
                     : unshadowed_irradiance(patch));
      block.pixels[block.count++] = {index,
                                     pixel_seed(job.seed, index),
                                     receiver.ray_origin_world,
                                     glm::vec3(receiver.n_geometric_world),
                                     patch,
                                     LightProof::none,
                                     {},
                                     {}};
    }
  }
  return block;
}

void prove(const BlockJob& job, Block& block) {
  std::array<ShaftPixel, kShafts> shafts;
  for (size_t i = 0; i < block.count; ++i) {
    const Pixel& pixel = block.pixels[i];
    shafts[i] = {&pixel.patch, pixel.ray_origin_world, pixel.n_geometric_world};
  }
  const auto proofs =
      prove_light(job.occluders, job.scene, job.scene_extent_world, {shafts.data(), block.count});
  for (size_t i = 0; i < block.count; ++i) block.pixels[i].proof = proofs[i];
}

bool is_settled(const BlockJob& job, Half judge, const Pixel& pixel) {
  if (pixel.proof != LightProof::none) return true;
  return job.target_se && standard_error_by(judge, pixel.sums) <= *job.target_se;
}

/// A half that stopped by what its own samples look like would be biased: those that agree by chance stop early. So each
/// half stops when the other one says so. What it is sampled after that only serves to judge the other.
void sample_block(const BlockJob& job, Block& block) {
  std::array<bool, 2> has_stopped{};
  uint32_t points = job.target_se ? std::min(kFirstRound, job.sets.points()) : job.sets.points();
  for (;;) {
    for (Pixel& pixel : block.used()) {
      if (job.skip_proven && pixel.proof != LightProof::none) continue;
      sample_pixel(job.embree, pixel.ray_origin_world, pixel.patch, job.sets, pixel.seed, points, pixel.sums);
    }
    const bool is_last = points == job.sets.points();
    for (size_t half = 0; half < 2; ++half) {
      if (has_stopped[half]) continue;
      const Half judge = half == 0 ? Half::b : Half::a;
      const auto settled = [&](const Pixel& pixel) { return is_settled(job, judge, pixel); };
      if (!is_last && !std::ranges::all_of(block.used(), settled)) continue;
      has_stopped[half] = true;
      for (Pixel& pixel : block.used()) pixel.kept[half] = pixel.sums;
    }
    if (has_stopped[0] && has_stopped[1]) return;
    points = std::min(2 * points, job.sets.points());
  }
}

/// What the samples say; without any, what is proven.
PixelEstimate estimate_of(const Pixel& pixel) {
  PixelEstimate estimate = estimate_pixel(pixel.kept[0], pixel.kept[1]);
  estimate.sample_count = kReplicates * pixel.sums.points;
  if (pixel.proof == LightProof::none) return estimate;
  estimate.visibility_se = 0.0;
  if (estimate.sample_count > 0 || pixel.proof != LightProof::lit) return estimate;
  estimate.visibility = estimate.half_a = estimate.half_b = 1.0;
  estimate.irradiance_ratio = is_unlit(pixel.patch) ? 0.0 : 1.0;
  return estimate;
}

}  // namespace

void render_block(const BlockJob& job, int x0, int y0, ReferencePlanes& planes) {
  Block block = shoot_primary(job, x0, y0, planes);
  prove(job, block);
  sample_block(job, block);
  for (const Pixel& pixel : block.used()) {
    const PixelEstimate estimate = estimate_of(pixel);
    BlockerStatistics blockers;
    if (estimate.visibility < 1.0) {
      blockers = probe_blockers(
          {job.embree, job.light, pixel.patch, pixel.ray_origin_world, pixel.n_geometric_world}, job.sets,
          pixel.seed);
    }
    planes.write_light(pixel.index, estimate, blockers);
  }
}

}  // namespace umbrameter
