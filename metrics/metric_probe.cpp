// SPDX-License-Identifier: Apache-2.0
#include "metrics/metric_probe.h"

#include "core/guard.h"

#include <fmt/format.h>

#include <cmath>

namespace umbrameter {
namespace {

constexpr int kWidth_px = 64, kHeight_px = 32;
constexpr double kProbeTolerance = 1e-6;

struct Probe {
  Image test{kWidth_px, kHeight_px}, reference{kWidth_px, kHeight_px};
  std::vector<uint8_t> mask;
};

// R = .5 and its halves .05 away; V .2 too bright in the left half and .1 too dark in the right; the top quarter is
// not scored and wrong by .5.
Probe make_probe() {
  Probe probe;
  const auto v = probe.test.add_plane("visibility");
  const auto a = probe.reference.add_plane("half_a", 0.55f), b = probe.reference.add_plane("half_b", 0.45f);
  probe.reference.add_plane("visibility", 0.5f);
  probe.reference.add_plane("visibility_se", 0.02f);
  probe.mask.resize(probe.test.pixel_count());
  for (size_t i = 0; i < probe.mask.size(); ++i) {
    const size_t x = i % kWidth_px, y = i / kWidth_px;
    probe.mask[i] = y >= kHeight_px / 4 ? 1 : 0;
    v[i] = probe.mask[i] == 0 ? 1.0f : x < kWidth_px / 2 ? 0.7f : 0.4f;
    if (x % 2 != 0) std::swap(a[i], b[i]);
  }
  return probe;
}

struct Known {
  const char* name;
  std::optional<double> found;
  double expected;
};

}  // namespace

VisibilityError error_metric(const Image& test, const Image& reference, std::span<const uint8_t> mask) {
  return measure_visibility_error(test, reference, mask);
}

// mse: (e - d)(e + d) = e^2 - d^2, with errors .2 and -.1 of equal shares and halves d = .05 away.
std::vector<std::string> metric_problems(const ErrorMetric& metric) {
  const Probe probe = make_probe();
  VisibilityError error;
  const auto failure = guarded([&] { error = metric(probe.test, probe.reference, probe.mask); });
  if (failure) return {"the error metric fails: " + failure->message};
  const std::optional<double> mse = error.mse ? std::optional(error.mse->value) : std::nullopt;
  const Known known[] = {{"scored pixels", static_cast<double>(error.scored_pixels), 64.0 * 24.0},
                         {"mse", mse, (0.04 + 0.01) / 2.0 - 0.0025},
                         {"mae", error.mae, 0.15},
                         {"bias", error.bias, 0.05},
                         {"over_shadowing", error.over_shadowing, 0.05},
                         {"under_shadowing", error.under_shadowing, 0.1},
                         {"max_error", error.max_error, 0.2},
                         {"noise_floor_mse", error.noise_floor_mse, 4e-4}};
  std::vector<std::string> problems;
  for (const auto& [name, found, expected] : known) {
    if (found && std::abs(*found - expected) < kProbeTolerance) continue;
    problems.push_back(fmt::format("the error metric's {} of a known pair is {} instead of {}", name,
                                   found ? fmt::format("{:.6f}", *found) : "absent", expected));
  }
  return problems;
}

}  // namespace umbrameter
