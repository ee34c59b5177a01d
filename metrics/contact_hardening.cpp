// SPDX-License-Identifier: Apache-2.0
#include "metrics/contact_hardening.h"

#include "core/statistics.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

constexpr size_t kFewest = 8;
constexpr size_t kMost = 512;
constexpr double kFewestOctaves = 2.0;
constexpr double kPairOctaves = 0.5;

struct Point {
  double reference_octaves = 0.0, test_octaves = 0.0;
};

std::vector<Point> sorted_points(const PenumbraError& penumbra) {
  std::vector<Point> points;
  for (const PenumbraProfile& profile : penumbra.profiles) {
    if (profile.outcome != ProfileOutcome::accepted) continue;
    points.push_back({std::log2(profile.reference_width_world), std::log2(profile.test_width_world)});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const Point& a, const Point& b) { return a.reference_octaves < b.reference_octaves; });
  return points;
}

std::vector<Point> evenly_picked(const std::vector<Point>& points) {
  if (points.size() <= kMost) return points;
  std::vector<Point> picked;
  for (size_t k = 0; k < kMost; ++k) picked.push_back(points[k * (points.size() - 1) / (kMost - 1)]);
  return picked;
}

}  // namespace

ContactHardening measure_contact_hardening(const PenumbraError& penumbra) {
  const std::vector<Point> all = sorted_points(penumbra);
  ContactHardening out;
  out.profiles = all.size();
  if (all.empty()) return out;
  const size_t last = all.size() - 1;
  out.octaves = all[(last * 95 + 50) / 100].reference_octaves - all[(last * 5 + 50) / 100].reference_octaves;
  if (all.size() < kFewest || out.octaves < kFewestOctaves) return out;

  const std::vector<Point> points = evenly_picked(all);
  std::vector<double> slopes;
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t j = i + 1; j < points.size(); ++j) {
      const double run = points[j].reference_octaves - points[i].reference_octaves;
      if (run >= kPairOctaves) slopes.push_back((points[j].test_octaves - points[i].test_octaves) / run);
    }
  }
  const double slope = median(slopes);
  const double middle = points[points.size() / 2].reference_octaves;
  std::vector<double> excess;
  for (const Point& point : points) {
    excess.push_back(point.test_octaves - middle - slope * (point.reference_octaves - middle));
  }
  out.slope = slope;
  out.intercept_octaves = median(excess);
  return out;
}

}  // namespace umbrameter
