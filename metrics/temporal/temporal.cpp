// SPDX-License-Identifier: Apache-2.0
#include "metrics/temporal/temporal.h"

#include "core/error.h"
#include "core/spaces.h"
#include "core/statistics.h"
#include "metrics/image/checks.h"
#include "metrics/image/surface.h"
#include "metrics/image/tiles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {

namespace {

constexpr int kTilePx = 64;
constexpr double kSamePoint = 0.25;  // of a pixel's extent; more, and something else is seen there

struct FrameValues {
  std::span<const float> v, a, b;
  std::span<const uint8_t> mask;
};

struct CameraFrame {
  FrameValues values;
  SurfaceView surface;
  glm::dmat4 clip_from_world;
};

FrameValues checked_frame(const SequenceFrame& frame, const Image& first) {
  UMBRAMETER_ASSERT(frame.test != nullptr && frame.reference != nullptr, "a frame has no {}", "image");
  require_same_size(*frame.test, first, "sequence");
  require_same_size(*frame.reference, first, "sequence");
  require_mask_size(first, frame.mask, "sequence");
  require_visibility(*frame.test, "visibility", frame.mask);
  require_visibility(*frame.reference, "half_a", frame.mask);
  require_visibility(*frame.reference, "half_b", frame.mask);
  return {frame.test->plane("visibility"), frame.reference->plane("half_a"), frame.reference->plane("half_b"),
          frame.mask};
}

void require_two(size_t frames) {
  if (frames >= 2) return;
  fail_input(fmt::format("a sequence of {} frames tells nothing of change", frames), {}, "give two or more");
}

// Four pixels of one surface around a continuous position, and their weights.
struct Footing {
  std::array<size_t, 4> pixels{};
  std::array<double, 4> weights{};

  double of(std::span<const float> plane) const {
    double sum = 0.0;
    for (size_t k = 0; k < 4; ++k) sum += weights[k] * plane[pixels[k]];
    return sum;
  }
  glm::dvec3 p_world(const SurfaceView& surface) const {
    glm::dvec3 sum(0.0);
    for (size_t k = 0; k < 4; ++k) sum += weights[k] * surface.p_world(pixels[k]);
    return sum;
  }
};

std::optional<Footing> footing_at(const CameraFrame& frame, const glm::dvec2& p_px) {
  const double left = std::floor(p_px.x - 0.5), top = std::floor(p_px.y - 0.5);
  const bool inside =
      left >= 0.0 && top >= 0.0 && left + 1.0 < frame.surface.width && top + 1.0 < frame.surface.height;
  if (!inside) return std::nullopt;
  const double fx = p_px.x - 0.5 - left, fy = p_px.y - 0.5 - top;
  const size_t width = static_cast<size_t>(frame.surface.width);
  const size_t corner = static_cast<size_t>(top) * width + static_cast<size_t>(left);
  const Footing footing = {{corner, corner + 1, corner + width, corner + width + 1},
                           {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
  for (const size_t i : footing.pixels) {
    if (frame.values.mask[i] == 0 || !same_surface(frame.surface, corner, i)) return std::nullopt;
  }
  return footing;
}

// Where a world point is seen in a frame; absent when something hides it.
std::optional<Footing> find_point(const CameraFrame& frame, const glm::dvec3& p_world) {
  const glm::dvec4 clip = frame.clip_from_world * glm::dvec4(p_world, 1.0);
  if (!(clip.w > 0.0)) return std::nullopt;
  const auto footing = footing_at(frame, pixel_of_clip(clip, frame.surface.width, frame.surface.height));
  if (!footing) return std::nullopt;
  const glm::dvec3 corner = frame.surface.p_world(footing->pixels[0]);
  const double extent = std::max(glm::length(frame.surface.p_world(footing->pixels[1]) - corner),
                                 glm::length(frame.surface.p_world(footing->pixels[2]) - corner));
  const bool is_same = glm::length(footing->p_world(frame.surface) - p_world) <= kSamePoint * extent;
  return is_same ? footing : std::nullopt;
}

struct FlickerSums {
  size_t points = 0, rejected = 0;
  double test = 0.0, reference = 0.0;  // sums of variances
};

// Sums over the frames a point is seen in.
struct PointSums {
  double n = 0, v = 0, vv = 0, a = 0, b = 0, ab = 0;

  void add(const Footing& at, const FrameValues& frame) {
    const double value = at.of(frame.v), half_a = at.of(frame.a), half_b = at.of(frame.b);
    n += 1, v += value, vv += value * value, a += half_a, b += half_b, ab += half_a * half_b;
  }
  double variance() const { return std::max(0.0, (vv - v * v / n) / (n - 1)); }
  double covariance() const { return (ab - a * b / n) / (n - 1); }
};

// A place within the pixel that differs from pixel to pixel (Roberts' R2 sequence), so that the first frame
// is smoothed by interpolation as much as the others.
glm::dvec2 place_in_pixel(size_t i) {
  constexpr double kX = 0.7548776662466927, kY = 0.5698402909980532;
  const double n = static_cast<double>(i) + 0.5;
  return {n * kX - std::floor(n * kX), n * kY - std::floor(n * kY)};
}

void follow_point(std::span<const CameraFrame> frames, size_t i, FlickerSums& sums) {
  const CameraFrame& first = frames.front();
  const size_t width = static_cast<size_t>(first.surface.width);
  const glm::dvec2 corner(static_cast<double>(i % width), static_cast<double>(i / width));
  const auto start = footing_at(first, corner + 0.5 + place_in_pixel(i));
  if (!start) return;
  const glm::dvec3 p_world = start->p_world(first.surface);
  PointSums point;
  point.add(*start, first.values);
  for (const CameraFrame& frame : frames.subspan(1)) {
    const auto footing = find_point(frame, p_world);
    if (!footing) {
      ++sums.rejected;
      return;
    }
    point.add(*footing, frame.values);
  }
  ++sums.points;
  sums.test += point.variance();
  sums.reference += point.covariance();
}

struct StepSums {
  size_t pixels = 0;
  double product = 0.0;
};

}  // namespace

Flicker measure_flicker(std::span<const SequenceFrame> frames, int point_spacing_px) {
  require_two(frames.size());
  if (point_spacing_px < 1) fail_input(fmt::format("point_spacing_px is {}", point_spacing_px));
  std::vector<CameraFrame> views;
  for (const SequenceFrame& frame : frames) {
    const FrameValues values = checked_frame(frame, *frames.front().test);
    views.push_back({values, checked_surface(*frame.reference), frame.clip_from_world});
  }
  const TileGrid grid = {frames.front().test->width, frames.front().test->height, kTilePx};
  const size_t width = static_cast<size_t>(grid.width), spacing = static_cast<size_t>(point_spacing_px);
  const auto tiles = for_each_tile<FlickerSums>(grid, [&](const Tile& tile, FlickerSums& sums) {
    for_each_pixel(grid, tile, [&](size_t i) {
      if (i % width % spacing == 0 && i / width % spacing == 0) follow_point(views, i, sums);
    });
  });
  FlickerSums total;
  for (const FlickerSums& tile : tiles) {
    total.points += tile.points;
    total.rejected += tile.rejected;
    total.test += tile.test;
    total.reference += tile.reference;
  }
  Flicker out = {total.points, total.rejected, {}, {}, {}};
  if (total.points == 0) return out;
  const double points = static_cast<double>(total.points);
  out.test = std::sqrt(total.test / points);
  out.reference = signed_root(total.reference / points);
  out.excess = signed_root((total.test - total.reference) / points);
  return out;
}

Popping measure_popping(std::span<const SequenceFrame> frames) {
  require_two(frames.size());
  std::vector<FrameValues> values;
  for (const SequenceFrame& frame : frames) values.push_back(checked_frame(frame, *frames.front().test));
  const TileGrid grid = {frames.front().test->width, frames.front().test->height, kTilePx};
  const auto tiles = for_each_tile<StepSums>(grid, [&](const Tile& tile, StepSums& sums) {
    for_each_pixel(grid, tile, [&](size_t i) {
      for (size_t t = 1; t < values.size(); ++t) {
        const FrameValues &now = values[t], &before = values[t - 1];
        if (now.mask[i] == 0 || before.mask[i] == 0) continue;
        const double dv = static_cast<double>(now.v[i]) - before.v[i];
        const double da = static_cast<double>(now.a[i]) - before.a[i];
        const double db = static_cast<double>(now.b[i]) - before.b[i];
        ++sums.pixels;
        sums.product += (dv - da) * (dv - db);
      }
    });
  });
  StepSums total;
  for (const StepSums& tile : tiles) {
    total.pixels += tile.pixels;
    total.product += tile.product;
  }
  if (total.pixels == 0) return {};
  return {total.pixels, signed_root(total.product / static_cast<double>(total.pixels))};
}

std::optional<double> measure_seed_noise(std::span<const Image* const> tests, std::span<const uint8_t> mask) {
  require_two(tests.size());
  std::vector<std::span<const float>> values;
  for (const Image* test : tests) {
    require_same_size(*test, *tests.front(), "seeds");
    require_mask_size(*test, mask, "seeds");
    require_visibility(*test, "visibility", mask);
    values.push_back(test->plane("visibility"));
  }
  const double n = static_cast<double>(tests.size());
  const TileGrid grid = {tests.front()->width, tests.front()->height, kTilePx};
  const auto tiles = for_each_tile<StepSums>(grid, [&](const Tile& tile, StepSums& sums) {
    for_each_pixel(grid, tile, [&](size_t i) {
      if (mask[i] == 0) return;
      double sum = 0.0, squares = 0.0;
      for (const std::span<const float> v : values) {
        sum += v[i];
        squares += static_cast<double>(v[i]) * v[i];
      }
      ++sums.pixels;
      sums.product += std::max(0.0, (squares - sum * sum / n) / (n - 1.0));
    });
  });
  StepSums total;
  for (const StepSums& tile : tiles) {
    total.pixels += tile.pixels;
    total.product += tile.product;
  }
  if (total.pixels == 0) return std::nullopt;
  return std::sqrt(total.product / static_cast<double>(total.pixels));
}

}  // namespace umbrameter
