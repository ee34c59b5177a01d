// SPDX-License-Identifier: Apache-2.0
#include "tests/statistical/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace umbrameter {

Frame render_reference(const Scene& scene, const ReferencePicture& picture) {
  ReferenceSettings settings;
  settings.samples_per_pixel = picture.samples_per_pixel;
  settings.target_se = picture.target_se;
  settings.threads = picture.threads;
  RenderRequest request;
  request.width_px = request.height_px = picture.side_px;
  request.seed = picture.seed;
  SilentProgress progress;
  return make_reference_renderer(settings)->render(scene, request, progress);
}

glm::dvec3 position_of(const Frame& frame, size_t pixel) {
  const Image& image = frame.image;
  return {image.plane("position.x")[pixel], image.plane("position.y")[pixel],
          image.plane("position.z")[pixel]};
}

Truth in_penumbra(std::function<double(const glm::dvec3&)> visibility) {
  return [visibility = std::move(visibility)](const glm::dvec3& p_world) -> std::optional<double> {
    const double v = visibility(p_world);
    if (v < 0.02 || v > 0.98) return std::nullopt;
    return v;
  };
}

Agreement compare(const Frame& frame, const Truth& truth) {
  const auto visibility = frame.image.plane("visibility");
  const auto se = frame.image.plane("visibility_se");
  const auto primitive = frame.image.plane("primitive_id");
  double error_sum = 0.0, error2 = 0.0, se2 = 0.0, se4 = 0.0, z2 = 0.0;
  Agreement agreement;
  for (size_t i = 0; i < visibility.size(); ++i) {
    if (primitive[i] < 0.0f) continue;
    const std::optional<double> expected = truth(position_of(frame, i));
    if (!expected) continue;
    const double e = static_cast<double>(visibility[i]) - *expected;
    const double s = static_cast<double>(se[i]);
    error_sum += e;
    error2 += e * e;
    se2 += s * s;
    se4 += s * s * s * s;
    z2 += e * e / (s * s);
    ++agreement.pixels;
  }
  const auto n = static_cast<double>(agreement.pixels);
  agreement.rmse = std::sqrt(error2 / n);
  agreement.rms_se = std::sqrt(se2 / n);
  agreement.variance_ratio = error2 / se2;
  // A squared error has variance 2 sigma^4, a squared standard error of 8 replicates 2/7 sigma^4.
  agreement.variance_ratio_sd = std::sqrt((2.0 + 2.0 / 7.0) * se4) / se2;
  agreement.mean_z = error_sum / std::sqrt(se2);
  agreement.z_second_moment = z2 / n;
  return agreement;
}

std::string objection(const Agreement& a) {
  if (a.pixels < 100) return fmt::format("only {} pixels to judge by", a.pixels);
  const bool is_biased = std::abs(a.mean_z) > 4.0;
  const bool is_dishonest = std::abs(a.variance_ratio - 1.0) > 4.0 * a.variance_ratio_sd;
  if (!is_biased && !is_dishonest) return {};
  return fmt::format(
      "mean z {:.2f}, variance ratio {:.3f} (sd {:.3f}), rmse {:.5f}, rms se {:.5f}, {} pixels", a.mean_z,
      a.variance_ratio, a.variance_ratio_sd, a.rmse, a.rms_se, a.pixels);
}

double disk_share_beyond(double u) {
  if (u <= -1.0) return 0.0;
  if (u >= 1.0) return 1.0;
  return 0.5 + (u * std::sqrt(1.0 - u * u) + std::asin(u)) / std::numbers::pi;
}

}  // namespace umbrameter
