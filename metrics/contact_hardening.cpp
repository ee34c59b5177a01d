// SPDX-License-Identifier: Apache-2.0
#include "metrics/contact_hardening.h"

#include "core/statistics.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

constexpr size_t kFewest = 8;
constexpr size_t kMost = 512;
constexpr double kFewestOctaves = 1.0;
constexpr double kEnoughOctaves = 2.0;
constexpr double kLargestSe = 0.05;         // of a slope over fewer octaves than enough
constexpr double kSigmaPerMedian = 1.4826;  // of a normal distribution's |x|
constexpr double kPairOctaves = 0.5;

struct Point {
  double reference_octaves = 0.0, test_octaves = 0.0;
};

std::vector<Point> sorted_points(const PenumbraError& penumbra) {
  std::vector<Point> points;
  const double hardest = std::log2(PenumbraSettings{}.hardest_share);
  for (const PenumbraProfile& profile : penumbra.profiles) {
    // The width of a hard edge is the pixel's.
    if (profile.outcome != ProfileOutcome::accepted || profile.width_octaves <= hardest) continue;
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

// Of a line's slope: the residuals' spread over that of the abscissae, which the median keeps from wild profiles.
double slope_se(const std::vector<Point>& points, double slope, double intercept) {
  const double n = static_cast<double>(points.size());
  double mean = 0.0, variance = 0.0;
  for (const Point& point : points) mean += point.reference_octaves / n;
  std::vector<double> residuals;
  for (const Point& point : points) {
    variance += (point.reference_octaves - mean) * (point.reference_octaves - mean) / n;
    residuals.push_back(std::abs(point.test_octaves - intercept - slope * point.reference_octaves));
  }
  return kSigmaPerMedian * median(std::move(residuals)) / std::sqrt(variance * n);
}

ContactHardening fit_hardening(const std::vector<Point>& all) {
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
  const double at_middle = median(excess);
  const bool is_enough = out.octaves >= kEnoughOctaves ||
                         slope_se(points, slope, middle + at_middle - slope * middle) <= kLargestSe;
  if (!is_enough) return out;
  out.slope = slope;
  out.intercept_octaves = at_middle;
  return out;
}

}  // namespace

ContactHardening measure_contact_hardening(const PenumbraError& penumbra) {
  return fit_hardening(sorted_points(penumbra));
}

}  // namespace umbrameter
