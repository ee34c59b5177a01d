// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/standing_alone.h"

#include <array>
#include <cmath>

namespace umbrameter {

namespace {

// More than grain of 64 taps and less than acne that anyone would see.
constexpr float kLoneRise = 0.1f;

struct Direction {
  double x, y;
};
constexpr double kSqrtHalf = 0.70710678, kLong = 0.92387953, kShort = 0.38268343;
constexpr std::array<Direction, 16> kDirections = {{{1, 0},
                                                    {0, 1},
                                                    {-1, 0},
                                                    {0, -1},
                                                    {kSqrtHalf, kSqrtHalf},
                                                    {-kSqrtHalf, kSqrtHalf},
                                                    {-kSqrtHalf, -kSqrtHalf},
                                                    {kSqrtHalf, -kSqrtHalf},
                                                    {kLong, kShort},
                                                    {kShort, kLong},
                                                    {-kShort, kLong},
                                                    {-kLong, kShort},
                                                    {-kLong, -kShort},
                                                    {-kShort, -kLong},
                                                    {kShort, -kLong},
                                                    {kLong, -kShort}}};

// Light does come over outlines: through creases, and between hairs, where contact tells its cause.
bool leads_to_shade(const Outskirts& field, size_t i, const Direction& direction, double reach_px,
                    float tolerance) {
  const int width = field.surface.width, height = field.surface.height;
  const int x = static_cast<int>(i % static_cast<size_t>(width));
  const int y = static_cast<int>(i / static_cast<size_t>(width));
  const float own = field.sign * field.v[i];
  size_t from = i;
  for (int step = 1; step <= static_cast<int>(reach_px); ++step) {
    const int to_x = x + static_cast<int>(std::lround(step * direction.x));
    const int to_y = y + static_cast<int>(std::lround(step * direction.y));
    if (to_x < 0 || to_x >= width || to_y < 0 || to_y >= height) return false;
    const size_t to = static_cast<size_t>(to_y) * static_cast<size_t>(width) + static_cast<size_t>(to_x);
    if (field.mask[to] == 0 || (field.sign > 0.0f && !same_surface(field.surface, from, to))) return false;
    if (field.sign * field.r[to] <= own + tolerance) return true;
    if (field.sign * field.v[to] > own + kLoneRise) return false;
    from = to;
  }
  return false;
}

}  // namespace

bool stands_alone(const Outskirts& field, size_t i, double reach_px, float tolerance) {
  for (const Direction& direction : kDirections) {
    if (leads_to_shade(field, i, direction, reach_px, tolerance)) return false;
  }
  return true;
}

}  // namespace umbrameter
