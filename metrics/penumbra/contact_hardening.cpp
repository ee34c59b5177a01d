// SPDX-License-Identifier: Apache-2.0
#include "metrics/penumbra/contact_hardening.h"

#include "core/statistics.h"
#include "metrics/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace umbrameter {

namespace {

constexpr size_t kFewest = 8;
constexpr size_t kMost = 512;
constexpr double kFewestOctaves = 1.0;
constexpr double kEnoughOctaves = 2.0;
constexpr double kLargestMargin = 0.25;  // of a slope over fewer octaves than enough
constexpr double kWildSigmas = 3.0;      // a residual counts no further
constexpr double kPairOctaves = 0.5;
constexpr int kPlacePx = 64;

using Place = std::pair<int, int>;

struct Point {
  double reference_octaves = 0.0, test_octaves = 0.0;
  Place place;
};

std::vector<Point> sorted_points(const PenumbraError& penumbra) {
  std::vector<Point> points;
  const double hardest = std::log2(PenumbraSettings{}.hardest_share);
  for (const PenumbraProfile& profile : penumbra.profiles) {
    // The width of a hard edge is the pixel's.
    if (profile.outcome != ProfileOutcome::accepted || profile.width_octaves <= hardest) continue;
    points.push_back({std::log2(profile.reference_width_world),
                      std::log2(profile.test_width_world),
                      {profile.x / kPlacePx, profile.y / kPlacePx}});
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

// Of a line's slope: the sandwich estimator over places (Liang and Zeger 1986), its residuals clipped as the line's own
// weights are (Huber); never below what the profiles alone give, since few places may cancel by chance. Absent for one place.
std::optional<double> margin_of_slope(const std::vector<Point>& points, double slope, double intercept) {
  double mean = 0.0;
  std::vector<double> residuals, sizes;
  for (const Point& point : points) {
    mean += point.reference_octaves / static_cast<double>(points.size());
    residuals.push_back(point.test_octaves - intercept - slope * point.reference_octaves);
    sizes.push_back(std::abs(residuals.back()));
  }
  const double wild = kWildSigmas * kSigmaPerMedian * median(std::move(sizes));
  std::map<Place, double> places;
  double squares = 0.0, alone = 0.0;
  for (size_t k = 0; k < points.size(); ++k) {
    const double run = points[k].reference_octaves - mean;
    squares += run * run;
    const double score = run * std::clamp(residuals[k], -wild, wild);
    places[points[k].place] += score;
    alone += score * score;
  }
  if (places.size() < 2) return std::nullopt;
  double scores = 0.0;
  for (const auto& [place, score] : places) scores += score * score;
  const double n = static_cast<double>(places.size());
  const double se = std::sqrt(std::max(scores * n / (n - 1.0), alone)) / squares;
  return student_t_975(static_cast<int>(places.size()) - 1) * se;
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
  const auto margin = margin_of_slope(points, slope, middle + at_middle - slope * middle);
  if (out.octaves < kEnoughOctaves && !(margin && *margin <= kLargestMargin)) return out;
  out.slope = slope;
  out.slope_margin = margin;
  out.intercept_octaves = at_middle;
  return out;
}

}  // namespace

ContactHardening measure_contact_hardening(const PenumbraError& penumbra) {
  return fit_hardening(sorted_points(penumbra));
}

}  // namespace umbrameter
