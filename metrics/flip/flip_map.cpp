// SPDX-License-Identifier: Apache-2.0
#include "metrics/flip/flip_map.h"

#include "core/error.h"
#include "metrics/flip/flip_color.h"
#include "metrics/flip/flip_see.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbrameter {

namespace {

// The paper's constants: colour exponent .7 (see powered), knee of the colour curve.
constexpr float kKneeAt = 0.4f, kKneeValue = 0.95f;

// To the power .7.
float powered(float difference) {
  const float fifth = root<5>(difference);
  return fifth * fifth * fifth * std::sqrt(fifth);
}

// The largest difference a display can show: green against blue.
float largest_color_difference() {
  return powered(
      hyab_distance(hunt_lab_from_linear({0.0f, 1.0f, 0.0f}), hunt_lab_from_linear({0.0f, 0.0f, 1.0f})));
}

// Compresses differences above the knee: what is very different cannot become much more so.
float color_difference(float hyab, float largest) {
  const float difference = powered(hyab), knee = kKneeAt * largest;
  const float below = difference * (kKneeValue / knee);
  const float above = kKneeValue + (difference - knee) * ((1.0f - kKneeValue) / (largest - knee));
  return difference < knee ? below : above;
}

float flip_value(float hyab, float edge_difference, float point_difference, float largest) {
  const float edge = std::abs(edge_difference), point = std::abs(point_difference);
  const float feature = std::sqrt((edge > point ? edge : point) * (1.0f / std::numbers::sqrt2_v<float>));
  return fast_pow(color_difference(hyab, largest), 1.0f - (feature < 1.0f ? feature : 1.0f));
}

void color_distances(const SeenRow& test, const SeenPicture& reference, size_t first, FlipTileRow& hyab) {
  const float* lightness = &reference.lightness[first];
  if (reference.a.empty()) {
    for (size_t x = 0; x < test.count; ++x) hyab[x] = std::abs(test.lightness[x] - lightness[x]);
    return;
  }
  const float *a = &reference.a[first], *b = &reference.b[first];
  for (size_t x = 0; x < test.count; ++x)
    hyab[x] = hyab_distance({test.lightness[x], test.a[x], test.b[x]}, {lightness[x], a[x], b[x]});
}

void compare(const SeenRow& test, const SeenPicture& reference, float largest, float* map) {
  const size_t first = test.y * static_cast<size_t>(reference.width) + test.x;
  FlipTileRow hyab;
  color_distances(test, reference, first, hyab);
  const float *edge = &reference.edge[first], *point = &reference.point[first];
  for (size_t x = 0; x < test.count; ++x)
    map[first + x] = flip_value(hyab[x], test.edge[x] - edge[x], test.point[x] - point[x], largest);
}

}  // namespace

SeenPicture see_picture(const FlipSource& picture, int width, int height, double ppd) {
  const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
  SeenPicture out;
  out.width = width;
  out.height = height;
  for (auto* plane : {&out.lightness, &out.edge, &out.point}) plane->resize(pixels);
  for (auto* plane : {&out.a, &out.b}) plane->resize(picture.is_grey ? 0 : pixels);
  see_rows(picture, width, height, ppd, [&](const SeenRow& row) {
    const size_t first = row.y * static_cast<size_t>(width) + row.x;
    const auto keep = [&](const FlipTileRow& from, std::vector<float>& to) {
      if (!to.empty()) std::copy_n(from.begin(), row.count, &to[first]);
    };
    keep(row.lightness, out.lightness);
    keep(row.a, out.a);
    keep(row.b, out.b);
    keep(row.edge, out.edge);
    keep(row.point, out.point);
  });
  return out;
}

std::vector<float> flip_map(const FlipSource& test, const SeenPicture& reference, double ppd) {
  UMBRAMETER_ASSERT(test.is_grey == reference.a.empty(), "grey is compared with colour");
  static const float largest = largest_color_difference();
  std::vector<float> map(reference.lightness.size());
  see_rows(test, reference.width, reference.height, ppd,
           [&](const SeenRow& row) { compare(row, reference, largest, map.data()); });
  return map;
}

}  // namespace umbrameter
