// SPDX-License-Identifier: Apache-2.0
// Prefiltered maps beyond one blocker: the leak that theory predicts, slopes that end, samples and mip levels.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using namespace test;

using Picture = std::vector<float>;

size_t differing(const Picture& a, const Picture& b) {
  size_t different = 0;
  for (size_t i = 0; i < a.size(); ++i) different += std::abs(a[i] - b[i]) > 1e-4f ? 1 : 0;
  return different;
}

/// Floor in the full shadow of plate B, 1 above it, and plate A over x < 0, `a_to_b` above B, under an overhead sun.
Scene two_layer_scene(double a_to_b) {
  Scene scene;
  scene.name = "two-layers";
  add_floor(scene, {12, 12});
  add_floor(scene, {20, 40}, 1.0);
  add_floor(scene, {20, 40}, 1.0 + a_to_b, {-10, 0});
  scene.lights = {light_at_4(LightType::sun, 0.5)};
  scene.camera.eye_world = {0.8, 0.4, 0.1};
  scene.camera.at_world = {0, 0, 0};
  scene.camera.vertical_fov_deg = 40.0;
  finish_scene(scene);
  return scene;
}

/// Visibility of the floor at x = 0: between the pixels on either side that are nearest to it.
double visibility_at_edge(const Frame& frame) {
  const auto v = frame.image.plane("visibility");
  const auto x = frame.image.plane("position.x");
  const auto y = frame.image.plane("position.y");
  double below_x = -1e9, above_x = 1e9, below_v = 0.0, above_v = 0.0;
  for (size_t i = 0; i < v.size(); ++i) {
    if (std::abs(y[i]) > 1e-4f) continue;
    if (x[i] <= 0.0f && x[i] > below_x) below_x = x[i], below_v = v[i];
    if (x[i] > 0.0f && x[i] < above_x) above_x = x[i], above_v = v[i];
  }
  return below_v + (above_v - below_v) * (0.0 - below_x) / (above_x - below_x);
}

TEST(vsm, leaks_under_half_an_upper_blocker_as_the_bound_says) {
  UMBRAMETER_REQUIRE_GL();
  // Half the kernel sees A, half B, d1 = A to B, d2 = B to floor: (d1/2)^2 / ((d1/2)^2 + (d1/2 + d2)^2). As d2 / d1 is
  // 0.25, 0.5, 1, 2 that is 4/13, 1/5, 1/10, 1/26. The texel that holds the edge moves a half by up to 1 / 50.
  const struct {
    double ratio;
    double leak;
  } rows[] = {{0.25, 4.0 / 13}, {0.5, 0.2}, {1.0, 0.1}, {2.0, 1.0 / 26}};
  for (const auto& [ratio, leak] : rows) {
    const Frame frame = render(two_layer_scene(1.0 / ratio), "vsm",
                               {{"map_size", int64_t{512}},
                                {"filter_width_texels", 25.0},
                                {"min_deviation_world", 1e-3},
                                {"bias_texels", 0.0},
                                {"normal_offset_texels", 0.0}});
    EXPECT_NEAR(visibility_at_edge(frame), leak, 0.02 * leak + 0.005) << ratio;
  }
}

/// A wall of 80 degrees to the sun that ends on the floor; nothing shadows anything.
Scene foot_scene() {
  Scene scene;
  scene.name = "foot";
  add_quad(scene, {0, 0, 2}, {2, 0, 2}, {2, 0, -2}, {0, 0, -2});
  add_quad(scene, {0, 0, 2}, {0, 0, -2}, {0, 2, -2}, {0, 2, 2});
  scene.lights = {sun_light({std::tan(glm::radians(10.0)), 1, 0}, 0.001)};
  scene.camera.eye_world = {2, 1.2, 0.3};
  scene.camera.at_world = {0.2, 0.2, 0};
  scene.camera.vertical_fov_deg = 40.0;
  finish_scene(scene);
  return scene;
}

/// Of the wall; the floor beside it is as dark as any filter makes it.
float darkest_on_wall(const Frame& frame) {
  const auto v = frame.image.plane("visibility");
  const auto x = frame.image.plane("position.x");
  const auto id = frame.image.plane("primitive_id");
  float darkest = 1.0f;
  for (size_t i = 0; i < v.size(); ++i)
    if (id[i] >= 0.0f && std::abs(x[i]) < 1e-4f) darkest = std::min(darkest, v[i]);
  return darkest;
}

TEST(prefiltered, plane_bias_keeps_the_foot_of_a_wall_lit) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = foot_scene();
  for (const std::string technique : {"vsm", "vsm_inline", "esm", "evsm"}) {
    ParameterValues values{{"map_size", int64_t{256}}};
    EXPECT_LT(darkest_on_wall(render(scene, technique, values)), 0.95f) << technique;
    values["plane_bias"] = true;
    EXPECT_GT(darkest_on_wall(render(scene, technique, values)), 0.97f) << technique;
  }
}

TEST(vsm, samples_of_a_texel_change_edges_alone) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues values{{"map_size", int64_t{256}}, {"filter_width_texels", 1.0}};
  ParameterValues sampled = values;
  sampled["map_samples"] = int64_t{4};  // as many as every GL has
  const Frame single = render(plate_scene(), "vsm", values);
  const Frame several = render(plate_scene(), "vsm", sampled);
  const auto a = single.image.plane("visibility");
  const auto b = several.image.plane("visibility");
  const size_t changed = differing({a.begin(), a.end()}, {b.begin(), b.end()});
  EXPECT_GT(changed, 0u);
  EXPECT_LT(changed, a.size() / 20);
  EXPECT_GE(several.memory_bytes, single.memory_bytes + 3u * 256 * 256 * 12);
}

TEST(vsm, mip_levels_act_only_where_a_pixel_covers_texels) {
  UMBRAMETER_REQUIRE_GL();
  // Half a metre of floor on 160 px: a pixel is 3 mm wide and, at this angle, less than 10 mm long.
  Scene scene = plate_scene();
  scene.camera.eye_world = {0.6, 0.5, 0.5};
  scene.camera.at_world = {0.3, 0.0, 0.2};
  finish_scene(scene);
  for (const int64_t reads : {1, 4}) {
    const auto with = [&](int64_t map_size, int64_t anisotropy) {
      return visibility(scene, "vsm", {{"map_size", map_size}, {"mip_anisotropy", anisotropy}});
    };
    EXPECT_EQ(with(16, reads), with(16, 0)) << reads;
    EXPECT_GT(differing(with(1024, reads), with(1024, 0)), 0u) << reads;
  }
}

TEST(esm, art_controls_are_neutral_until_asked) {
  UMBRAMETER_REQUIRE_GL();
  const auto plain = visibility(plate_scene(), "esm", {{"map_size", int64_t{512}}});
  const auto lifted = visibility(plate_scene(), "esm", {{"map_size", int64_t{512}}, {"darkest", 0.5}});
  const auto squared = visibility(plate_scene(), "esm", {{"map_size", int64_t{512}}, {"darkening", 2.0}});
  for (size_t i = 0; i < plain.size(); ++i) {
    ASSERT_EQ(lifted[i], std::max(plain[i], 0.5f)) << i;
    ASSERT_NEAR(squared[i], plain[i] * plain[i], 1e-4) << i;
  }
}

}  // namespace
}  // namespace umbrameter
