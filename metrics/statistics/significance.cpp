// SPDX-License-Identifier: Apache-2.0
#include "metrics/statistics/significance.h"

#include "core/error.h"
#include "metrics/image/checks.h"
#include "metrics/image/tiles.h"

#include <array>
#include <cmath>
#include <limits>

namespace umbrameter {

namespace {

// abs(z) is counted in bins of 1/256 up to 16 (p = 1e-57) and beyond: Benjamini and Hochberg's step-up over the
// bins' lower edges needs no sorting and errs by at most a bin, towards calling fewer pixels wrong.
constexpr int kBinsPerUnit = 256;
constexpr size_t kHistogramBins = 16 * kBinsPerUnit + 1;
using Histogram = std::array<uint32_t, kHistogramBins>;

double two_sided_p(double z) {
  return std::erfc(z / std::sqrt(2.0));
}

size_t bin_of(float z) {
  return static_cast<size_t>(std::min(std::abs(z) * kBinsPerUnit, static_cast<float>(kHistogramBins - 1)));
}

double lower_edge(size_t bin) {
  return static_cast<double>(bin) / kBinsPerUnit;
}

void require_settings(const SignificanceSettings& settings) {
  if (settings.replicates < 2) {
    fail_input(fmt::format("replicates is {}", settings.replicates), {}, "at least 2");
  }
  if (!(settings.floor_variance > 0.0)) {
    fail_input(fmt::format("floor_variance is {}", settings.floor_variance), {}, "above 0");
  }
  if (!(settings.false_discovery_rate > 0.0 && settings.false_discovery_rate < 1.0)) {
    fail_input(fmt::format("false_discovery_rate is {}", settings.false_discovery_rate), {},
               "between 0 and 1");
  }
}

void require_inputs(const Image& test, const Image& reference, std::span<const uint8_t> mask) {
  require_same_size(test, reference, "significance");
  require_mask_size(test, mask, "significance");
  for (const Image* image : {&test, &reference}) {
    require_visibility(*image, "visibility", mask);
    if (image == &reference || image->has("visibility_se")) {
      require_range(*image, "visibility_se", mask, 0.0f, std::numeric_limits<float>::max());
    }
  }
}

// The lowest bin whose p-value times all tests is within the allowed share of the pixels from it on.
std::optional<size_t> threshold_bin(const Histogram& histogram, size_t tested, double rate) {
  std::optional<size_t> threshold;
  size_t from_here_on = 0;
  for (size_t bin = kHistogramBins; bin-- > 0;) {
    from_here_on += histogram[bin];
    const double false_ones = static_cast<double>(tested) * two_sided_p(lower_edge(bin));
    if (from_here_on > 0 && false_ones <= rate * static_cast<double>(from_here_on)) threshold = bin;
  }
  return threshold;
}

void count_exceedances(const SignificanceSettings& settings, Significance& out) {
  for (const float z : out.z) out.exceeding += std::abs(z) > settings.exceedance_z ? 1 : 0;
  const double p = two_sided_p(settings.exceedance_z), tested = static_cast<double>(out.tested);
  out.expected_exceeding = tested * p;
  out.exceedance_sigmas =
      (static_cast<double>(out.exceeding) - *out.expected_exceeding) / std::sqrt(tested * p * (1.0 - p));
}

}  // namespace

double normal_deviate(double v, double r, double se, double test_se, const SignificanceSettings& settings) {
  const double truth = std::clamp(v, 0.0, 1.0), reference_variance = se * se,
               test_variance = test_se * test_se;
  const bool all_agree = (r <= 0.0 || r >= 1.0) && se > 0.0;
  if (all_agree) {
    const double samples = 0.5 / se;
    const double score_variance = std::max(reference_variance, truth * (1.0 - truth) / samples);
    return (v - r) / std::sqrt(score_variance + test_variance + settings.floor_variance);
  }
  const double variance = reference_variance + test_variance + settings.floor_variance;
  const double t = (v - r) / std::sqrt(variance);
  const double squares = reference_variance * reference_variance + test_variance * test_variance;
  if (squares < 1e-12 * variance * variance) return t;  // exact, but for v0
  // Degrees of freedom by Welch and Satterthwaite, then Wallace 1959: never too large, and at most
  // 1.3 % too small for 7 degrees and p down to 1e-9.
  const double degrees = (settings.replicates - 1) * variance * variance / squares;
  const double z =
      (8.0 * degrees + 1.0) / (8.0 * degrees + 3.0) * std::sqrt(degrees * std::log1p(t * t / degrees));
  return std::copysign(z, t);
}

Significance measure_significance(const Image& test, const Image& reference, std::span<const uint8_t> mask,
                                  const SignificanceSettings& settings) {
  require_settings(settings);
  require_inputs(test, reference, mask);
  const std::span<const float> v = test.plane("visibility"), r = reference.plane("visibility"),
                               se = reference.plane("visibility_se");
  const std::vector<float> exact(test.has("visibility_se") ? 0 : test.pixel_count(), 0.0f);
  const std::span<const float> test_se = exact.empty() ? test.plane("visibility_se") : exact;
  Significance out;
  out.z.assign(test.pixel_count(), 0.0f);
  out.wrong.assign(test.pixel_count(), 0);
  for_each_row(test.height, [&](int y) {
    const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(test.width);
    for (size_t i = begin; i < begin + static_cast<size_t>(test.width); ++i) {
      if (mask[i] != 0)
        out.z[i] = static_cast<float>(normal_deviate(v[i], r[i], se[i], test_se[i], settings));
    }
  });
  Histogram histogram{};
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    ++out.tested;
    ++histogram[bin_of(out.z[i])];
  }
  if (out.tested == 0) return out;
  count_exceedances(settings, out);
  const auto bin = threshold_bin(histogram, out.tested, settings.false_discovery_rate);
  if (!bin) return out;
  out.threshold_z = lower_edge(*bin);
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0 || bin_of(out.z[i]) < *bin) continue;
    out.wrong[i] = 1;
    ++(out.z[i] < 0.0f ? out.too_dark : out.too_bright);
  }
  return out;
}

}  // namespace umbrameter
