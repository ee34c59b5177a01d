// SPDX-License-Identifier: Apache-2.0
#include "reference/exact_check.h"

#include "core/error.h"
#include "reference/interval.h"
#include "scenes/instances.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace umbrameter {

namespace {

constexpr double kRounding = 1e-6;  // visibilities are stored as floats

/// Moves `count` random elements to the front and drops the others.
void keep_random(std::vector<size_t>& pixels, size_t count, std::mt19937_64& random) {
  for (size_t i = 0; i < count; ++i) std::swap(pixels[i], pixels[i + random() % (pixels.size() - i)]);
  pixels.resize(count);
}

glm::dvec3 vector_at(const Image& image, const std::string& name, size_t pixel) {
  return {image.plane(name + ".x")[pixel], image.plane(name + ".y")[pixel], image.plane(name + ".z")[pixel]};
}

ExactReceiver receiver_at(const Scene& scene, const Image& reference, size_t pixel, double lift_world) {
  const auto triangle = static_cast<uint32_t>(reference.plane("primitive_id")[pixel]);
  const glm::dvec2 p_px(static_cast<double>(pixel % static_cast<size_t>(reference.width)) + 0.5,
                        static_cast<double>(pixel / static_cast<size_t>(reference.width)) + 0.5);
  const glm::dvec3 d_world =
      camera_ray_direction_world(scene.camera, p_px, reference.width, reference.height);
  glm::dvec3 n_world = triangle_normal_world(scene, triangle);
  if (glm::dot(n_world, d_world) > 0.0) n_world = -n_world;
  const glm::dvec3 corner = scene.positions_world[scene.triangles[triangle].x];
  const glm::dvec3& eye = scene.camera.eye_world;
  const double way = glm::dot(n_world, corner - eye) / glm::dot(n_world, d_world);
  return {eye + d_world * way + n_world * lift_world, n_world, vector_at(reference, "shading_normal", pixel)};
}

double extent_world(const Scene& scene) {
  double extent = 0.0;
  for (const glm::vec3& p : scene.positions_world)
    extent = std::max<double>({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return extent;
}

CheckedPoint compare(const ExactLight& exact, const Image& reference, size_t pixel) {
  CheckedPoint point;
  point.x_px = static_cast<int>(pixel % static_cast<size_t>(reference.width));
  point.y_px = static_cast<int>(pixel / static_cast<size_t>(reference.width));
  point.exact_low = exact.visibility_low;
  point.exact_high = exact.visibility_high;
  point.visibility = reference.plane("visibility")[pixel];
  point.visibility_se = reference.plane("visibility_se")[pixel];
  if (exact.irradiance_ratio) {
    point.irradiance_error =
        static_cast<double>(reference.plane("irradiance_ratio")[pixel]) - *exact.irradiance_ratio;
  }
  point.triangles = exact.triangles;
  return point;
}

bool is_covered(const CheckedPoint& point) {
  const VisibilityInterval interval = interval_95(point.visibility, point.visibility_se);
  return interval.low - kRounding <= point.exact_high && point.exact_low <= interval.high + kRounding;
}

/// The error in standard errors; without one any error is beyond all others.
double badness(const CheckedPoint& point) {
  if (point.visibility_se > 0.0) return std::abs(point.error()) / point.visibility_se;
  return is_covered(point) ? 0.0 : std::numeric_limits<double>::max();
}

}  // namespace

std::vector<size_t> draw_check_pixels(const Image& pilot, size_t count, uint64_t seed) {
  const auto visibility = pilot.plane("visibility");
  const auto irradiance = pilot.plane("unshadowed_irradiance");
  std::vector<size_t> penumbra, rest;
  for (size_t i = 0; i < visibility.size(); ++i) {
    if (!(irradiance[i] > 0.0f)) continue;
    (visibility[i] > 0.0f && visibility[i] < 1.0f ? penumbra : rest).push_back(i);
  }
  size_t of_penumbra = std::min(count - count / 4, penumbra.size());
  const size_t of_rest = std::min(count - of_penumbra, rest.size());
  of_penumbra = std::min(count - of_rest, penumbra.size());
  std::mt19937_64 random(seed);
  keep_random(penumbra, of_penumbra, random);
  keep_random(rest, of_rest, random);
  penumbra.insert(penumbra.end(), rest.begin(), rest.end());
  std::ranges::sort(penumbra);
  return penumbra;
}

void require_exact(const Scene& scene) {
  const uint64_t holes = count_shown_cutouts(scene);
  if (holes == 0) return;
  fail_input(fmt::format("the exact check cannot see holes, which {} of {} triangles have", holes,
                         count_shown_triangles(scene)),
             scene.source);
}

std::vector<CheckedPoint> check_pixels(const Scene& scene, const Image& reference,
                                       std::span<const size_t> pixels, const ExactOracle& oracle, int threads,
                                       Progress& progress) {
  require_exact(scene);
  if (!scene.instanced.empty())
    return check_pixels(flattened(scene), reference, pixels, oracle, threads, progress);
  constexpr double kLift = 1e-12;
  const double lift_world = kLift * extent_world(scene);
  std::vector<ExactReceiver> receivers;
  for (const size_t pixel : pixels) receivers.push_back(receiver_at(scene, reference, pixel, lift_world));
  const std::vector<ExactLight> answers = oracle(scene, receivers, threads, progress);
  UMBRAMETER_ASSERT(answers.size() == pixels.size(), "{} answers for {} pixels", answers.size(),
                    pixels.size());
  std::vector<CheckedPoint> points;
  for (size_t i = 0; i < pixels.size(); ++i) points.push_back(compare(answers[i], reference, pixels[i]));
  return points;
}

ExactComparison compare_with_exact(std::span<const CheckedPoint> points) {
  ExactComparison comparison;
  ExactAgreement& sum = comparison.penumbra;
  double error2 = 0.0, se2 = 0.0, irradiance2 = 0.0;
  size_t irradiances = 0;
  for (const CheckedPoint& point : points) {
    if (!comparison.worst || badness(point) > badness(*comparison.worst)) comparison.worst = point;
    if (point.irradiance_error) {
      irradiance2 += *point.irradiance_error * *point.irradiance_error;
      ++irradiances;
    }
    if (!point.is_penumbra()) {
      ++comparison.others;
      if (!is_covered(point)) ++comparison.others_wrong;
      continue;
    }
    ++sum.points;
    if (is_covered(point)) ++sum.covered;
    sum.mean_error += point.error();
    error2 += point.error() * point.error();
    se2 += point.visibility_se * point.visibility_se;
  }
  if (irradiances > 0) {
    comparison.irradiance_rms_error = std::sqrt(irradiance2 / static_cast<double>(irradiances));
  }
  if (sum.points == 0) return comparison;
  const auto n = static_cast<double>(sum.points);
  sum.mean_error /= n;
  sum.mean_error_noise = std::sqrt(se2) / n;
  sum.rms_error = std::sqrt(error2 / n);
  sum.rms_se = std::sqrt(se2 / n);
  return comparison;
}

}  // namespace umbrameter
