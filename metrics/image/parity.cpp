// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/parity.h"

#include "core/error.h"
#include "core/statistics.h"
#include "metrics/image/checks.h"
#include "metrics/image/surface.h"
#include "metrics/image/tiles.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace umbrameter {

namespace {

struct Surface {
  SurfaceView view;
  std::span<const float> irradiance;
  std::span<const float> known;  // empty: everywhere
};

Surface checked_lit_surface(const Image& image) {
  const SurfaceView view = checked_surface(image);
  std::vector<uint8_t> hit(image.pixel_count());
  for (size_t i = 0; i < hit.size(); ++i) hit[i] = view.hit(i) ? 1 : 0;
  require_range(image, "unshadowed_irradiance", hit, 0.0f, std::numeric_limits<float>::max());
  return {view, image.plane("unshadowed_irradiance"),
          image.has("known") ? image.plane("known") : std::span<const float>()};
}

float largest_irradiance(std::span<const float> primitive, std::span<const float> irradiance) {
  float largest = 0.0f;
  for (size_t i = 0; i < primitive.size(); ++i) {
    if (primitive[i] >= 0.0f) largest = std::max(largest, irradiance[i]);
  }
  return largest;
}

float irradiance_threshold(const Image& reference) {
  return 1e-6f *
         largest_irradiance(reference.plane("primitive_id"), reference.plane("unshadowed_irradiance"));
}

double relative_distance(const Surface& test, const Surface& reference, size_t i,
                         const glm::dvec3& eye_world) {
  const glm::dvec3 at = reference.view.p_world(i);
  const double apart = glm::length(test.view.p_world(i) - at);
  return apart == 0.0 ? 0.0 : apart / glm::length(at - eye_world);
}

struct Judge {
  Surface test, reference;
  glm::dvec3 eye_world;
  ParityTolerance tolerance;
  double cosine_limit;
  double irradiance_slack;

  bool same_primitive(size_t i) const { return test.view.primitive[i] == reference.view.primitive[i]; }
  bool same_surface(size_t i, double relative_depth_error) const {
    if (same_primitive(i)) return true;
    return relative_depth_error <= tolerance.relative_depth &&
           glm::dot(test.view.n_world(i), reference.view.n_world(i)) >= cosine_limit;
  }
  bool same_irradiance(size_t i) const {
    const double expected = reference.irradiance[i];
    const double allowed = tolerance.relative_irradiance * expected + irradiance_slack;
    return std::abs(test.irradiance[i] - expected) <= allowed;
  }
};

struct TileCounts {
  std::array<size_t, 6> by_class{};  // indexed by ParityClass
  size_t same_primitive = 0;
  std::vector<float> depth_errors;
};

ParityClass classify(const Judge& judge, size_t i, TileCounts& counts) {
  const bool hit_test = judge.test.view.hit(i), hit_reference = judge.reference.view.hit(i);
  if (!hit_test && !hit_reference) return ParityClass::background;
  if (hit_test != hit_reference) return ParityClass::coverage;
  const double depth_error = relative_distance(judge.test, judge.reference, i, judge.eye_world);
  counts.depth_errors.push_back(static_cast<float>(depth_error));
  if (judge.same_primitive(i)) ++counts.same_primitive;
  if (!judge.same_surface(i, depth_error)) return ParityClass::surface;
  if (!judge.same_irradiance(i)) return ParityClass::irradiance;
  const bool is_known = judge.test.known.empty() || judge.test.known[i] != 0.0f;
  return is_known ? ParityClass::agrees : ParityClass::unknown;
}

}  // namespace

Parity compare_surfaces(const Image& test, const Image& reference, const glm::dvec3& eye_world,
                        const ParityTolerance& tolerance) {
  require_same_size(test, reference, "parity");
  const Surface reference_surface = checked_lit_surface(reference);
  const Judge judge = {.test = checked_lit_surface(test),
                       .reference = reference_surface,
                       .eye_world = eye_world,
                       .tolerance = tolerance,
                       .cosine_limit = std::cos(tolerance.normal_deg * std::numbers::pi / 180.0),
                       .irradiance_slack = 1e-4 * largest_irradiance(reference_surface.view.primitive,
                                                                     reference_surface.irradiance)};

  Parity out;
  out.width = test.width;
  out.height = test.height;
  out.classes.resize(test.pixel_count());
  const TileGrid grid = {test.width, test.height, 64};
  const std::vector<TileCounts> tiles =
      for_each_tile<TileCounts>(grid, [&](const Tile& tile, TileCounts& counts) {
        for (int y = tile.y0; y < tile.y1; ++y) {
          const size_t row = static_cast<size_t>(y) * static_cast<size_t>(grid.width);
          for (size_t i = row + static_cast<size_t>(tile.x0); i < row + static_cast<size_t>(tile.x1); ++i) {
            out.classes[i] = classify(judge, i, counts);
            ++counts.by_class[static_cast<size_t>(out.classes[i])];
          }
        }
      });

  std::array<size_t, 6> by_class{};
  std::vector<float> depth_errors;
  depth_errors.reserve(test.pixel_count());
  for (const TileCounts& tile : tiles) {
    for (size_t k = 0; k < by_class.size(); ++k) by_class[k] += tile.by_class[k];
    out.same_primitive += tile.same_primitive;
    depth_errors.insert(depth_errors.end(), tile.depth_errors.begin(), tile.depth_errors.end());
  }
  const auto count = [&](ParityClass kind) { return by_class[static_cast<size_t>(kind)]; };
  out.covered = test.pixel_count() - count(ParityClass::background);
  out.coverage_mismatch = count(ParityClass::coverage);
  out.surface_mismatch = count(ParityClass::surface);
  out.irradiance_mismatch = count(ParityClass::irradiance);
  out.unknown = count(ParityClass::unknown);
  if (!depth_errors.empty()) out.median_relative_depth_error = median(std::move(depth_errors));
  const auto share = [&](size_t pixels) {
    return out.covered > 0 ? static_cast<double>(pixels) / static_cast<double>(out.covered) : 1.0;
  };
  out.agreement = share(count(ParityClass::agrees) + out.unknown);
  out.passes = out.agreement >= tolerance.required_agreement;
  const size_t same_surface = count(ParityClass::agrees) + count(ParityClass::irradiance);
  out.is_other_light = !out.passes && share(same_surface) >= tolerance.required_agreement;
  return out;
}

std::vector<uint8_t> scored_mask(const Parity& parity, const Image& reference) {
  if (parity.width != reference.width || parity.height != reference.height) {
    fail_input(fmt::format("scored mask: parity is of {}x{} pixels, the reference of {}x{}", parity.width,
                           parity.height, reference.width, reference.height));
  }
  const std::span<const float> irradiance = reference.plane("unshadowed_irradiance");
  const float threshold = irradiance_threshold(reference);
  std::vector<uint8_t> mask(parity.classes.size());
  for_each_row(reference.height, [&](int y) {
    const size_t width = static_cast<size_t>(reference.width);
    const size_t begin = static_cast<size_t>(y) * width;
    for (size_t i = begin; i < begin + width; ++i) {
      mask[i] = parity.classes[i] == ParityClass::agrees && irradiance[i] > threshold ? 1 : 0;
    }
  });
  return mask;
}

std::vector<uint8_t> scorable_mask(const Image& reference) {
  const auto primitive = reference.plane("primitive_id"),
             irradiance = reference.plane("unshadowed_irradiance");
  const float threshold = irradiance_threshold(reference);
  std::vector<uint8_t> mask(primitive.size());
  for (size_t i = 0; i < mask.size(); ++i)
    mask[i] = primitive[i] >= 0.0f && irradiance[i] > threshold ? 1 : 0;
  return mask;
}

std::vector<uint8_t> known_mask(std::span<const uint8_t> mask, const Image& test) {
  std::vector<uint8_t> out(mask.begin(), mask.end());
  if (!test.has("known")) return out;
  const std::span<const float> known = test.plane("known");
  for (size_t i = 0; i < out.size(); ++i) {
    if (known[i] == 0.0f) out[i] = 0;
  }
  return out;
}

}  // namespace umbrameter
