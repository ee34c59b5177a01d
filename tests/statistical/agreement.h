// SPDX-License-Identifier: Apache-2.0
#pragma once
// How a reference picture is put to the test against a known answer, with nothing but its own error bars.

#include "core/renderer.h"
#include "reference/reference.h"
#include "tests/support/procedural_scene.h"

#include <functional>
#include <limits>
#include <optional>
#include <string>

namespace umbrameter {

struct ReferencePicture {
  int side_px = 64;
  int samples_per_pixel = 256;
  uint64_t seed = 1;
  int threads = 0;
  std::optional<double> target_se = {};
};
Frame render_reference(const Scene& scene, const ReferencePicture& picture = {});

glm::dvec3 position_of(const Frame& frame, size_t pixel);

/// The true visibility at a point of the picture; nothing where the test does not look.
using Truth = std::function<std::optional<double>(const glm::dvec3& p_world)>;

/// Restricts `visibility` to the points where it lies well inside (0,1): there sampling has something to do.
Truth in_penumbra(std::function<double(const glm::dvec3&)> visibility);

/// Errors e = V - truth against stated standard errors s, over the pixels that have a truth. `channel` stands
/// for V.
struct Agreement {
  size_t pixels = 0;
  double rmse = 0.0;
  double rms_se = 0.0;
  double variance_ratio = 0.0;     // sum e^2 / sum s^2, 1 when the error bars are honest
  double variance_ratio_sd = 0.0;  // its standard deviation when they are
  double mean_z = 0.0;             // sum e / sqrt(sum s^2), standard normal when unbiased
  double z_second_moment = 0.0;    // mean of (e/s)^2; 7/5 for Gaussian replicate means
};
Agreement compare(const Frame& frame, const Truth& truth);

/// Empty when unbiased and honest: |mean_z| <= 4 and |variance_ratio - 1| <= 4 standard deviations; otherwise
/// a sentence with the numbers. The z-test's chance of a false alarm is below 1e-4; seeds are fixed.
std::string objection(const Agreement& agreement);

/// Share of the unit disk where x > -u: 1/2 + (u sqrt(1-u^2) + asin u) / pi, 0 and 1 beyond +-1.
double disk_share_beyond(double u);

}  // namespace umbrameter
