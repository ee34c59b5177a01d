// SPDX-License-Identifier: Apache-2.0
#include "metrics/error/lit_sum.h"

#include "metrics/error/visibility_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace umbrameter {
namespace {

/// Planes of a truth and what they are called in a sum, which is compared as if it were one light's visibility.
constexpr std::array kSummed = {std::pair{"irradiance_ratio", "visibility"},
                                std::pair{"irradiance_half_a", "half_a"},
                                std::pair{"irradiance_half_b", "half_b"}};

std::span<const float> irradiance_of(const LitPart& part) {
  return part.truth->plane("unshadowed_irradiance");
}

std::vector<uint8_t> common_mask(std::span<const LitPart> parts) {
  std::vector<uint8_t> mask(parts.front().mask.size(), 0);
  for (size_t i = 0; i < mask.size(); ++i) {
    const auto is_dark = [i](const LitPart& part) { return irradiance_of(part)[i] == 0.0f; };
    const auto is_scored = [i](const LitPart& part) { return part.mask[i] != 0; };
    const bool is_whole =
        std::ranges::all_of(parts, [&](const LitPart& part) { return is_scored(part) || is_dark(part); });
    mask[i] = is_whole && std::ranges::any_of(parts, is_scored) ? 1 : 0;
  }
  return mask;
}

struct AllLight {
  double most = 0.0;  // of all lights together in a pixel
  double root_mean_square = 0.0;
  size_t pixels = 0;
};

AllLight all_light(std::span<const LitPart> parts, std::span<const uint8_t> mask) {
  AllLight light;
  double squares = 0.0;
  for (size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    double sum = 0.0;
    for (const LitPart& part : parts) sum += static_cast<double>(irradiance_of(part)[i]);
    squares += sum * sum;
    light.most = std::max(light.most, sum);
    ++light.pixels;
  }
  if (light.pixels > 0) light.root_mean_square = std::sqrt(squares / static_cast<double>(light.pixels));
  return light;
}

/// Adds `values` times the light's irradiance, of `most`; what rounding adds to 1 is cut.
void add_lit(std::span<const float> values, std::span<const float> irradiance, double most,
             std::span<float> sum) {
  for (size_t i = 0; i < sum.size(); ++i) {
    const double part = static_cast<double>(values[i]) * static_cast<double>(irradiance[i]) / most;
    sum[i] = std::min(1.0f, sum[i] + static_cast<float>(part));
  }
}

Image sum_of_truths(std::span<const LitPart> parts, double most) {
  Image sum(parts.front().truth->width, parts.front().truth->height);
  for (const auto& [from, to] : kSummed) {
    const auto plane = sum.add_plane(to);
    for (const LitPart& part : parts) add_lit(part.truth->plane(from), irradiance_of(part), most, plane);
  }
  const auto error = sum.add_plane("visibility_se");
  for (const LitPart& part : parts) {
    const auto own = part.truth->plane("irradiance_ratio_se"), irradiance = irradiance_of(part);
    for (size_t i = 0; i < error.size(); ++i)
      error[i] = std::hypot(error[i], own[i] * irradiance[i] / static_cast<float>(most));
  }
  return sum;
}

Image sum_of_pictures(std::span<const LitPart> parts, const Image* LitPart::*picture, double most) {
  Image sum(parts.front().truth->width, parts.front().truth->height);
  const auto plane = sum.add_plane("visibility");
  for (const LitPart& part : parts)
    add_lit((part.*picture)->plane("visibility"), irradiance_of(part), most, plane);
  return sum;
}

Interval scaled(const Interval& interval, double by) {
  return {interval.value * by, interval.low * by, interval.high * by};
}

}  // namespace

std::optional<LitSum> measure_lit_sum(std::span<const LitPart> parts) {
  const std::vector<uint8_t> mask = common_mask(parts);
  const AllLight light = all_light(parts, mask);
  if (light.pixels == 0) return std::nullopt;
  const Image truth = sum_of_truths(parts, light.most);
  const Image before = sum_of_pictures(parts, &LitPart::before, light.most);
  const Image after = sum_of_pictures(parts, &LitPart::after, light.most);
  const auto rmse = [&](const Image& picture) {
    const auto error = measure_visibility_error(picture, truth, mask).rmse;
    return scaled(error.value_or(Interval{}), light.most / light.root_mean_square);
  };
  LitSum sum;
  sum.pixels = light.pixels;
  sum.before = rmse(before);
  sum.after = rmse(after);
  if (const auto verdict = compare_runs(after, before, truth, mask)) sum.outcome = verdict->outcome;
  return sum;
}

}  // namespace umbrameter
