// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finding ridges, their gradient, and the pixels of a walk along it. Not here: what the profiles mean
// (metrics/penumbra/penumbra.h).

#include "metrics/image/surface.h"
#include "metrics/image/tiles.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

/// The truth and where it may be used.
struct ReferenceField {
  SurfaceView surface;
  std::span<const float> visibility, visibility_se;
  std::span<const uint8_t> mask;

  bool usable(size_t i) const { return mask[i] != 0 && surface.hit(i); }
  bool connected(size_t i, size_t j) const { return usable(i) && usable(j) && same_surface(surface, i, j); }
};

struct Seed {
  size_t pixel = 0;
  bool on_ridge = false;  // else only in the penumbra: .2 < visibility < .8
  /// Off a ridge: a pixel where visibility crosses .75 or .25, the flank of a shadow without umbra or of light between
  /// shadows.
  std::optional<size_t> flank;
};

/// The seed of a cell: the ridge pixel closest to .5, else the penumbra pixel closest to it, with the flank pixel closest to
/// its level; else none.
std::optional<Seed> find_seed(const ReferenceField& field, const Tile& cell);

/// The steepest ascent of visibility on the receiver.
struct Ascent {
  glm::dvec3 direction_world{0.0};  // unit, in the tangent plane
  glm::dvec2 direction_px{0.0};     // the same in the image, longer component 1
  double width_px = 0.0;            // of a linear ramp with this slope
};

/// Least-squares slope over a window grown to a quarter of the width, so that noise averages out. Absent
/// where the receiver has no extent in the image or visibility is flat.
std::optional<Ascent> fit_ascent(const ReferenceField& field, size_t seed);

struct WalkSample {
  size_t pixel = 0;
  double s_world = 0.0;  // along the ascent, 0 at the seed
};

enum class WalkEnd : uint8_t { saturated, turned, broken, too_long };

/// Pixels from the seed towards the light or away from it, without the seed itself.
struct Walk {
  std::vector<WalkSample> samples;
  size_t reference_count = 0;       // of samples until the reference's plateau
  size_t test_count = 0;            // of samples until the test's
  WalkEnd end = WalkEnd::too_long;  // of the reference
  bool test_cut = false;            // stopped by a break or a turn before the test's plateau
};

/// Walks pixel by pixel until the reference has been on its plateau for three pixels, then on until the test
/// is, but no more than four times as far. `towards_light` picks the side.
Walk walk_profile(const ReferenceField& field, std::span<const float> test, size_t seed, const Ascent& ascent,
                  bool towards_light, int max_length_px);

}  // namespace umbrameter
