// SPDX-License-Identifier: Apache-2.0
#include "reference/pixel_tile.h"

#include "reference/patch_irradiance.h"
#include "reference/tile_proof.h"
#include "scenes/near_light.h"

#include <algorithm>
#include <array>

namespace umbrameter {

namespace {

/// The pixels that light can reach, block by block.
struct Tile {
  std::array<ShaftPixel, kTile * kTile> shafts;
  std::array<uint32_t, kTile * kTile> indices;
  size_t count = 0;
  std::array<size_t, 16> block_ends{};

  BlockPixels pixels(size_t first, size_t end) const {
    return {{shafts.data() + first, end - first}, {indices.data() + first, end - first}};
  }
};

/// In closed form where a rule of few points fails: near the light, and where the horizon cuts it and the form is exact.
double irradiance_at(const Light& light, const Receiver& receiver, const LightPatch& patch) {
  const bool is_exact = light.type == LightType::rect || light.type == LightType::sphere;
  const bool is_hard = is_near_light(light, receiver.p_world) || (is_exact && straddles_horizon(patch));
  return is_hard ? near_irradiance(light, receiver.p_world, receiver.n_shading_world)
                 : unshadowed_irradiance(patch);
}

/// Writes what is known without sampling.
void take_hit(const BlockJob& job, uint32_t index, const PrimaryHit& hit, Tile& tile,
              ReferencePlanes& planes) {
  planes.write_surface(index, hit);
  const Receiver& receiver = hit.receiver;
  const LightPatch patch = make_light_patch(job.light, receiver, job.scene_extent_world);
  if (is_below_horizon(patch) && is_unlit(patch)) {
    planes.write_light(index, {});
    return;
  }
  planes.write_unshadowed_irradiance(index, irradiance_at(job.light, receiver, patch));
  tile.shafts[tile.count] = {patch, receiver.ray_origin_world, glm::vec3(receiver.n_geometric_world)};
  tile.indices[tile.count++] = index;
}

void shoot_primary(const BlockJob& job, int x0, int y0, Tile& tile, ReferencePlanes& planes) {
  for (size_t block = 0; block < tile.block_ends.size(); ++block) {
    const int x = x0 + kBlock * static_cast<int>(block % 4), y = y0 + kBlock * static_cast<int>(block / 4);
    tile.block_ends[block] = tile.count;
    if (x >= planes.width() || y >= planes.height()) continue;
    const PrimaryBlock hits = job.camera.hits(job.embree, x, y);
    for (size_t i = 0; i < hits.size(); ++i) {
      if (!hits[i]) continue;
      const auto column = x + static_cast<int>(i % kBlock), row = y + static_cast<int>(i / kBlock);
      take_hit(job, static_cast<uint32_t>(row * planes.width() + column), *hits[i], tile, planes);
    }
    tile.block_ends[block] = tile.count;
  }
}

}  // namespace

void render_tile(const BlockJob& job, int x0, int y0, ReferencePlanes& planes) {
  Tile tile;
  shoot_primary(job, x0, y0, tile, planes);
  const bool all_lit =
      proves_all_lit(job.occluders, job.scene, job.scene_extent_world, {tile.shafts.data(), tile.count});
  size_t first = 0;
  for (const size_t end : tile.block_ends) {
    if (first < end) render_block(job, tile.pixels(first, end), all_lit, planes);
    first = end;
  }
}

}  // namespace umbrameter
