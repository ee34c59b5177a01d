// SPDX-License-Identifier: Apache-2.0
#include "metrics/penumbra/envelope.h"

#include "core/error.h"
#include "metrics/image/checks.h"
#include "metrics/image/disc_extreme.h"
#include "metrics/image/nearest_feature.h"
#include "metrics/image/standing_alone.h"
#include "metrics/image/tiles.h"
#include "metrics/statistics/bootstrap.h"

#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

constexpr float kPlateauMargin = 0.01f;  // from full light or full shadow

struct BoundedField {
  std::span<const float> v, r, se;
  std::span<const uint8_t> mask;
  SurfaceView surface;
  std::span<const PenumbraProfile> profiles;
  const EnvelopeSettings& settings;

  double radius_px(const Envelope& out, size_t i) const {
    const int32_t nearest = out.nearest_profile[i];
    if (nearest < 0) return 1.0;
    const double width = profiles[static_cast<size_t>(nearest)].reference_width_px;
    return 1.0 + settings.radius_per_width * std::min(width, settings.max_width_px);
  }
};

// Pixels of a tile whose error exceeds the tolerance in one direction; sign 1: too dark, -1: too bright.
struct Candidates {
  float sign = 1.0f;
  std::vector<size_t> pixels;
  double max_radius_px = 0.0;
};

struct TileResult {
  TileSum dark, bright;
  size_t dark_pixels = 0, bright_pixels = 0;
};

std::vector<int32_t> nearest_profiles(std::span<const PenumbraProfile> profiles, int width, int height) {
  std::vector<uint8_t> is_feature(static_cast<size_t>(width) * static_cast<size_t>(height), 0);
  std::vector<int32_t> profile_at(is_feature.size(), -1);
  for (size_t k = 0; k < profiles.size(); ++k) {
    if (!(profiles[k].reference_width_px > 0.0)) continue;
    const size_t i = profiles[k].pixel(width);
    UMBRAMETER_ASSERT(i < is_feature.size(), "profile at ({}, {})", profiles[k].x, profiles[k].y);
    is_feature[i] = 1;
    profile_at[i] = static_cast<int32_t>(k);
  }
  std::vector<int32_t> nearest = nearest_feature(is_feature, width, height);
  for (int32_t& index : nearest) {
    if (index >= 0) index = profile_at[static_cast<size_t>(index)];
  }
  return nearest;
}

std::pair<Candidates, Candidates> find_candidates(const BoundedField& field, const TileGrid& grid,
                                                  const Tile& tile, Envelope& out, TileResult& result) {
  Candidates dark{1.0f, {}, 0.0}, bright{-1.0f, {}, 0.0};
  for (int y = tile.y0; y < tile.y1; ++y) {
    const size_t row = static_cast<size_t>(y) * static_cast<size_t>(grid.width);
    for (size_t i = row + static_cast<size_t>(tile.x0); i < row + static_cast<size_t>(tile.x1); ++i) {
      if (field.mask[i] == 0) continue;
      result.dark.weight += 1.0;
      result.bright.weight += 1.0;
      out.tolerance[i] = std::max(static_cast<float>(field.settings.tolerance), 3.0f * field.se[i]);
      const float error = field.v[i] - field.r[i];
      if (std::abs(error) <= out.tolerance[i]) continue;
      Candidates& side = error < 0.0f ? dark : bright;
      side.pixels.push_back(i);
      side.max_radius_px = std::max(side.max_radius_px, field.radius_px(out, i));
    }
  }
  return {std::move(dark), std::move(bright)};
}

// With sign s the residual is max(0, min(s R) - s V - tolerance) for both directions.
void measure_side(const BoundedField& field, const TileGrid& grid, const Tile& tile, const Candidates& side,
                  Envelope& out, std::vector<float>& residual, TileSum& sum, size_t& pixels) {
  if (side.pixels.empty()) return;
  const DiscMinimum discs(field.r, field.mask, grid, tile, side.max_radius_px, side.sign);
  const Outskirts outskirts = {field.v, field.r, field.mask, field.surface, side.sign};
  for (const size_t i : side.pixels) {
    const float excused = side.sign * field.v[i] + out.tolerance[i];
    const int x = static_cast<int>(i % static_cast<size_t>(grid.width));
    const int y = static_cast<int>(i / static_cast<size_t>(grid.width));
    const double radius_px = field.radius_px(out, i);
    float least = discs.minimum(x, y, radius_px, excused);
    const bool is_outskirt = least <= excused && outskirts.on_plateau(i, kPlateauMargin);
    if (is_outskirt && stands_alone(outskirts, i, radius_px, out.tolerance[i]))
      least = side.sign * field.r[i];
    if (least <= excused) continue;
    residual[i] = least - excused;
    sum.sum += residual[i];
    ++pixels;
  }
}

Interval mean_of(std::span<const TileSum> tiles, const VisibilityErrorSettings& settings) {
  TileSum total;
  for (const TileSum& tile : tiles) {
    total.sum += tile.sum;
    total.weight += tile.weight;
  }
  // A single tile tells no spread: the mean may be anything a visibility error may be.
  const BootstrapInterval interval =
      bootstrap_ratio(tiles, settings.bootstrap_rounds, settings.seed).value_or(BootstrapInterval{0.0, 1.0});
  return {total.sum / total.weight, interval.low, interval.high};
}

}  // namespace

Envelope measure_envelope(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                          std::span<const PenumbraProfile> profiles, const EnvelopeSettings& settings) {
  require_same_size(test, reference, "envelope");
  require_mask_size(reference, mask, "envelope");
  require_visibility(test, "visibility", mask);
  require_visibility(reference, "visibility", mask);
  require_range(reference, "visibility_se", mask, 0.0f, std::numeric_limits<float>::max());
  if (!(settings.radius_per_width >= 0.0 && settings.radius_per_width <= 1.0)) {
    fail_input(fmt::format("radius_per_width is {}", settings.radius_per_width), {}, "between 0 and 1");
  }

  const BoundedField field = {test.plane("visibility"),
                              reference.plane("visibility"),
                              reference.plane("visibility_se"),
                              mask,
                              checked_surface(reference),
                              profiles,
                              settings};
  Envelope out;
  out.width = test.width;
  out.height = test.height;
  out.dark.assign(test.pixel_count(), 0.0f);
  out.bright.assign(test.pixel_count(), 0.0f);
  out.tolerance.assign(test.pixel_count(), 0.0f);
  out.nearest_profile = nearest_profiles(profiles, test.width, test.height);

  const TileGrid grid = {test.width, test.height, settings.bootstrap.tile_px};
  const std::vector<TileResult> tiles =
      for_each_tile<TileResult>(grid, [&](const Tile& tile, TileResult& result) {
        const auto [dark, bright] = find_candidates(field, grid, tile, out, result);
        measure_side(field, grid, tile, dark, out, out.dark, result.dark, result.dark_pixels);
        measure_side(field, grid, tile, bright, out, out.bright, result.bright, result.bright_pixels);
      });

  std::vector<TileSum> dark, bright;
  for (const TileResult& tile : tiles) {
    dark.push_back(tile.dark);
    bright.push_back(tile.bright);
    out.scored_pixels += static_cast<size_t>(tile.dark.weight);
    out.dark_pixels += tile.dark_pixels;
    out.bright_pixels += tile.bright_pixels;
  }
  if (out.scored_pixels == 0) return out;
  out.mean_dark = mean_of(dark, settings.bootstrap);
  out.mean_bright = mean_of(bright, settings.bootstrap);
  return out;
}

}  // namespace umbrameter
