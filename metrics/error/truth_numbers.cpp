// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/truth_numbers.h"

#include "core/hash.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

/// Beyond noise: sums of floats in another order.
constexpr double kDeviceRounding = 1e-6;

struct TruthSum {
  double value = 0.0, variance = 0.0;
  void add(double v, double sd) {
    value += v;
    variance += sd * sd;
  }
  MeanWithNoise mean(double count) const { return {value / count, std::sqrt(variance) / count}; }
};

std::optional<std::string> difference(const char* what, const MeanWithNoise& now, const MeanWithNoise& before,
                                      double sigmas) {
  const double apart = std::abs(now.value - before.value);
  const double allowed = sigmas * std::hypot(now.sd, before.sd) + kDeviceRounding;
  if (apart <= allowed) return std::nullopt;
  return fmt::format("its mean {} was {:.6g} and is {:.6g}, {:.2g} apart where noise allows {:.2g}", what,
                     before.value, now.value, apart, allowed);
}

}  // namespace

TruthNumbers truth_numbers(const Image& truth, const std::string& device, uint64_t seed) {
  const auto v = truth.plane("visibility"), a = truth.plane("half_a"), b = truth.plane("half_b");
  const auto se = truth.plane("visibility_se"), samples = truth.plane("sample_count");
  const auto primitive = truth.plane("primitive_id");
  TruthSum visibility, penumbra;
  double count = 0.0, sample_sum = 0.0;
  for (size_t i = 0; i < v.size(); ++i) {
    if (primitive[i] < 0.0f) continue;
    visibility.add(v[i], se[i]);
    penumbra.add(0.5 * (a[i] * (1.0 - b[i]) + b[i] * (1.0 - a[i])), (1.0 - 2.0 * v[i]) * se[i]);
    sample_sum += static_cast<double>(samples[i]);
    count += 1.0;
  }
  Hasher hasher;
  hasher.values(v);
  TruthNumbers numbers = {hasher.hex(), device, seed, 0.0, {}, {}};
  if (count == 0.0) return numbers;
  numbers.samples_per_pixel = sample_sum / count;
  numbers.visibility = visibility.mean(count);
  numbers.penumbra = penumbra.mean(count);
  return numbers;
}

std::optional<std::string> truth_difference(const TruthNumbers& now, const TruthNumbers& before,
                                            double sigmas) {
  if (auto text = difference("visibility", now.visibility, before.visibility, sigmas)) return text;
  return difference("of V (1 - V)", now.penumbra, before.penumbra, sigmas);
}

void add_samples(Image& truth, const Image& more) {
  require_same_size(truth, more, "more samples");
  const std::span<float> samples = truth.plane("sample_count");
  const std::span<const float> extra = more.plane("sample_count");
  std::vector<float> share(samples.size(), 0.0f);  // of the new ones
  for (size_t i = 0; i < share.size(); ++i) {
    const float all = samples[i] + extra[i];
    if (all > 0.0f) share[i] = extra[i] / all;
  }
  for (const char* channel :
       {"visibility", "half_a", "half_b", "irradiance_ratio", "irradiance_half_a", "irradiance_half_b"}) {
    if (!truth.has(channel)) continue;
    const std::span<float> mean = truth.plane(channel);
    const std::span<const float> other = more.plane(channel);
    for (size_t i = 0; i < share.size(); ++i) mean[i] += share[i] * (other[i] - mean[i]);
  }
  for (const char* channel : {"visibility_se", "irradiance_ratio_se"}) {
    if (!truth.has(channel)) continue;
    const std::span<float> se = truth.plane(channel);
    const std::span<const float> other_se = more.plane(channel);
    for (size_t i = 0; i < share.size(); ++i)
      se[i] = std::hypot((1.0f - share[i]) * se[i], share[i] * other_se[i]);
  }
  for (size_t i = 0; i < share.size(); ++i) samples[i] += extra[i];
}

}  // namespace umbrameter
