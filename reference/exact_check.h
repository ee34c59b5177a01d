// SPDX-License-Identifier: Apache-2.0
#pragma once
// A reference picture held against the exact oracle at points drawn over it.

#include "core/image.h"
#include "reference/exact_answer.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace umbrameter {

struct CheckedPoint {
  int x_px = 0;
  int y_px = 0;
  double exact_low = 0.0;  // the bracket of reference/exact_answer.h
  double exact_high = 0.0;
  double visibility = 0.0;  // the picture's
  double visibility_se = 0.0;
  std::optional<double> irradiance_error;  // picture - exact
  size_t triangles = 0;                    // between the receiver and the light
  double exact() const { return 0.5 * (exact_low + exact_high); }
  bool is_penumbra() const { return exact_low > 0.0 && exact_high < 1.0; }
  double error() const { return visibility - exact(); }
};

/// Draws `count` different pixels: three quarters of them where `pilot`, a picture of the same view whose samples owe
/// nothing to the one under test, sees a part of the light; the rest among the other pixels that the light could reach.
/// Fewer when the picture has fewer; a short half is filled from the other. Ascending.
std::vector<size_t> draw_check_pixels(const Image& pilot, size_t count, uint64_t seed);

/// Error{input} for a scene that the oracle cannot see: one with holes in its triangles.
void require_exact(const Scene& scene);

/// What `oracle` answers at the centres of `pixels` of `reference`. The receiver is computed anew: where the ray through
/// the pixel's centre meets the plane of the triangle it sees, 1e-12 of the scene's extent above it, so that its own surface
/// lies below. Error{input} as require_exact().
std::vector<CheckedPoint> check_pixels(const Scene& scene, const Image& reference,
                                       std::span<const size_t> pixels, const ExactOracle& oracle, int threads,
                                       Progress& progress);

/// Over points whose exact visibility lies strictly between 0 and 1, where sampling has something to do.
struct ExactAgreement {
  size_t points = 0;
  size_t covered = 0;  // inside interval_95 (reference/interval.h)
  double mean_error = 0.0;
  double mean_error_noise = 0.0;  // its standard deviation, were the stated errors true and independent
  double rms_error = 0.0;
  double rms_se = 0.0;
  double coverage() const { return static_cast<double>(covered) / static_cast<double>(points); }
};

struct ExactComparison {
  ExactAgreement penumbra;
  size_t others = 0;        // points that see all of the light or nothing
  size_t others_wrong = 0;  // whose interval does not hold that
  std::optional<CheckedPoint>
      worst;  // the greatest error, in standard errors; a wrong proof before all others
  std::optional<double> irradiance_rms_error;
};
ExactComparison compare_with_exact(std::span<const CheckedPoint> points);

}  // namespace umbrameter
