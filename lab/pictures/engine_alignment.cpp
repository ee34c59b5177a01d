// SPDX-License-Identifier: Apache-2.0
#include "lab/pictures/engine_surfaces.h"

#include <fmt/format.h>

#include <cmath>

namespace umbrameter {
namespace {

constexpr int kMostShift_px = 2;
/// A reading must leave less than this share of the error to be named.
constexpr double kFarBetterShare = 0.5;

struct Reading {
  bool is_upside_down = false, is_mirrored = false;
  int dx = 0, dy = 0;
};

double mean_square(const Image& test, const Image& reference, const Reading& reading,
                   std::span<const uint8_t> known) {
  const std::span<const float> v = test.plane("visibility"), r = reference.plane("visibility");
  double sum = 0.0, count = 0.0;
  const int m = kMostShift_px;
  for (int y = m; y < test.height - m; ++y) {
    for (int x = m; x < test.width - m; ++x) {
      const auto i = static_cast<size_t>(y) * static_cast<size_t>(test.width) + static_cast<size_t>(x);
      if (known[i] == 0) continue;
      const int sy = (reading.is_upside_down ? test.height - 1 - y : y) + reading.dy;
      const int sx = (reading.is_mirrored ? test.width - 1 - x : x) + reading.dx;
      const double d = static_cast<double>(
          v[static_cast<size_t>(sy) * static_cast<size_t>(test.width) + static_cast<size_t>(sx)] - r[i]);
      sum += d * d;
      count += 1.0;
    }
  }
  return count == 0.0 ? 0.0 : sum / count;
}

std::string name_of_reading(const Reading& reading) {
  if (reading.is_upside_down && reading.is_mirrored) return "turned by 180 degrees";
  if (reading.is_upside_down) return "upside down";
  if (reading.is_mirrored) return "mirrored";
  return fmt::format("{} px to the {} and {} px {}", std::abs(reading.dx), reading.dx > 0 ? "left" : "right",
                     std::abs(reading.dy), reading.dy > 0 ? "up" : "down");
}

std::vector<Reading> all_readings() {
  std::vector<Reading> all = {{true, false, 0, 0}, {false, true, 0, 0}, {true, true, 0, 0}};
  for (int dy = -kMostShift_px; dy <= kMostShift_px; ++dy) {
    for (int dx = -kMostShift_px; dx <= kMostShift_px; ++dx) {
      if (dx != 0 || dy != 0) all.push_back({false, false, dx, dy});
    }
  }
  return all;
}

}  // namespace

std::optional<std::string> better_alignment(const Image& test, const Image& reference,
                                            std::span<const uint8_t> known) {
  const double as_it_stands = mean_square(test, reference, {}, known);
  double best = kFarBetterShare * as_it_stands;
  std::optional<std::string> name;
  for (const Reading& reading : all_readings()) {
    const double error = mean_square(test, reference, reading, known);
    if (error >= best) continue;
    best = error;
    name = name_of_reading(reading);
  }
  return name;
}

bool is_inverted(const Image& test, const Image& reference, std::span<const uint8_t> known) {
  const auto v = test.plane("visibility"), r = reference.plane("visibility");
  double straight = 0.0, inverted = 0.0;
  for (size_t i = 0; i < v.size(); ++i) {
    if (known[i] == 0) continue;
    straight += std::pow(static_cast<double>(v[i]) - r[i], 2);
    inverted += std::pow(1.0 - static_cast<double>(v[i]) - r[i], 2);
  }
  return inverted < kFarBetterShare * straight;
}

}  // namespace umbrameter
