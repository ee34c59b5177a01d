// SPDX-License-Identifier: Apache-2.0
// Without these tests a width could be right on a painted floor and wrong on a rendered one.

#include "tests/support/procedural_scene.h"

#include "core/progress.h"
#include "core/statistics.h"
#include "metrics/penumbra/penumbra.h"
#include "reference/reference.h"
#include "scenes/load_scene.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {
namespace {

constexpr double kEnough_px = 20.0;

struct Edge {
  size_t profiles = 0;
  double median_width_world = 0.0, median_width_10_90_world = 0.0;
};

Frame truth_of(const std::string& name) {
  const std::filesystem::path root = source_dir();
  const Scene scene = load_scene(root / "scenes/library" / (name + ".toml"), SceneSearch{});
  SilentProgress silent;
  RenderRequest request;
  request.width_px = 480;
  request.height_px = 270;
  return make_reference_renderer({512, {}, 0})->render(scene, request, silent);
}

/// Widths of the penumbrae of 20 px or more whose ridge satisfies `lies_on`.
template <class LiesOn>
Edge measure_edge(const Frame& frame, const LiesOn& lies_on) {
  const Image& image = frame.image;
  const std::vector<uint8_t> everywhere(image.pixel_count(), 1);
  std::vector<double> widths, widths_10_90;
  for (const PenumbraProfile& profile : measure_penumbra(image, image, everywhere).profiles) {
    const size_t i = profile.pixel(image.width);
    if (profile.outcome != ProfileOutcome::accepted || profile.reference_width_px < kEnough_px) continue;
    if (!lies_on(image.plane("position.x")[i], image.plane("position.z")[i])) continue;
    widths.push_back(profile.reference_width_world);
    widths_10_90.push_back(profile.reference_width_10_90_world);
  }
  Edge edge{widths.size()};
  if (widths.empty()) return edge;
  edge.median_width_world = median(widths);
  edge.median_width_10_90_world = median(widths_10_90);
  return edge;
}

void expect_widths(const Edge& edge, double width_world, double width_10_90_world) {
  EXPECT_GE(edge.profiles, 5u);
  EXPECT_NEAR(edge.median_width_world, width_world, 0.02 * width_world);
  EXPECT_NEAR(edge.median_width_10_90_world, width_10_90_world, 0.02 * width_10_90_world);
}

TEST(PenumbraWidth, of_a_half_plane_under_a_square_is_the_ramps) {
  expect_widths(measure_edge(truth_of("half_plane"), [](double, double) { return true; }), 1.0, 0.8);
}

TEST(PenumbraWidth, of_a_half_plane_under_a_disk_is_sqrt_3_of_its_radius) {
  expect_widths(measure_edge(truth_of("half_plane_disk"), [](double, double) { return true; }),
                0.5 * std::sqrt(3.0), 0.687);
}

// Away from its corners a plate has two straight edges; the light's sides are 0.8 and 0.4 long.
TEST(PenumbraWidth, of_a_plate_is_the_lights_extent_across_each_edge) {
  const Frame frame = truth_of("plate");
  expect_widths(
      measure_edge(
          frame, [](double x, double z) { return std::abs(std::abs(x) - 1.6) < 0.05 && std::abs(z) < 0.6; }),
      0.8, 0.64);
  expect_widths(
      measure_edge(
          frame, [](double x, double z) { return std::abs(std::abs(z) - 1.0) < 0.05 && std::abs(x) < 0.9; }),
      0.4, 0.32);
}

}  // namespace
}  // namespace umbrameter
