// SPDX-License-Identifier: Apache-2.0
// Blocker distance and layers explain errors later; a wrong one would blame the wrong cause.

#include "tests/statistical/agreement.h"
#include "tests/statistical/oracle_scenes.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

const glm::dvec3 kPointLight{0, kLightHeight, 0};

TEST(Blocker, distance_is_from_the_receiver_to_the_first_sheet) {
  Scene scene = floor_under(disk_light_above(kPointLight, 1e-3), 1.0);
  add_floor(scene, {6, 6}, 2.0);  // hidden behind the first
  add_floor(scene, {6, 6}, kOccluderHeight);
  finish_scene(scene);
  const Frame frame = render_reference(scene, {.side_px = 16});
  for (size_t i = 0; i < frame.image.pixel_count(); ++i) {
    const double expected = kFraction * glm::distance(position_of(frame, i), kPointLight);
    ASSERT_NEAR(frame.image.plane("blocker_distance")[i], expected, 1e-3);
    ASSERT_NEAR(frame.image.plane("blocker_distance_min")[i], expected, 1e-3);
    ASSERT_EQ(frame.image.plane("blocker_layers")[i], 2.0f);
  }
}

TEST(Blocker, distance_towards_the_sun_is_a_length_too) {
  const glm::dvec3 to_sun = glm::normalize(glm::dvec3(1, 1, 0));
  Scene scene = floor_under(sun_light(to_sun, 1e-4), 1.0);
  add_floor(scene, {8, 8}, kOccluderHeight);
  finish_scene(scene);
  const Frame frame = render_reference(scene, {.side_px = 8});
  for (const float distance : frame.image.plane("blocker_distance")) {
    ASSERT_NEAR(distance, kOccluderHeight / to_sun.y, 1e-3);
  }
}

TEST(Blocker, a_closed_box_is_one_layer_whichever_way_it_is_wound) {
  for (const bool inside_out : {false, true}) {
    Scene scene = floor_under(disk_light_above(kPointLight, 1e-3), 0.5);
    const size_t first = scene.triangles.size();
    add_box(scene, {-2, 1.0, -2}, {2, 1.5, 2});
    for (size_t k = first; inside_out && k < scene.triangles.size(); ++k) {
      std::swap(scene.triangles.edit()[k].y, scene.triangles.edit()[k].z);
    }
    finish_scene(scene);
    const Frame frame = render_reference(scene, {.side_px = 8});
    for (const float layers : frame.image.plane("blocker_layers")) ASSERT_EQ(layers, 1.0f);
  }
}

TEST(Blocker, boxes_behind_and_inside_each_other_and_a_sheet_are_three_layers) {
  Scene scene = floor_under(disk_light_above(kPointLight, 1e-3), 0.5);
  add_box(scene, {-2, 1.0, -2}, {2, 1.6, 2});
  add_box(scene, {-1.5, 1.2, -1.5}, {1.5, 1.4, 1.5});
  add_floor(scene, {6, 6}, 0.5);
  finish_scene(scene);
  const Frame frame = render_reference(scene, {.side_px = 8});
  for (const float layers : frame.image.plane("blocker_layers")) ASSERT_EQ(layers, 3.0f);
}

TEST(Blocker, the_nearest_is_no_farther_than_the_mean) {
  Scene scene = floor_under(rect_light_above(kPointLight, {1, 1}), 0.4);
  add_half_plane(scene);
  finish_scene(scene);
  const Frame frame = render_reference(scene, {.side_px = 32});
  for (size_t i = 0; i < frame.image.pixel_count(); ++i) {
    const float nearest = frame.image.plane("blocker_distance_min")[i];
    ASSERT_LE(nearest, frame.image.plane("blocker_distance_p10")[i]);
    ASSERT_LE(frame.image.plane("blocker_distance_p10")[i], frame.image.plane("blocker_distance")[i] * 1.1f);
    if (frame.image.plane("visibility")[i] == 1.0f) {
      ASSERT_EQ(nearest, 0.0f);
    }
  }
}

TEST(Blocker, the_tenth_percentile_looks_past_a_single_near_leaf) {
  // All 16 probes end at the sheet; before 3 % of the light hangs a leaf, which now and then one of them meets.
  Scene scene = floor_under(rect_light_above(kPointLight, {1, 1}), 0.001);
  add_floor(scene, {8, 8}, kOccluderHeight);
  add_floor(scene, {0.003, 2}, 0.4);
  finish_scene(scene);
  scene.camera.eye_world.y = 0.3;
  const Frame frame = render_reference(scene, {.side_px = 32});
  const auto near_in = [&](const char* plane) {
    return std::ranges::count_if(frame.image.plane(plane), [](float d) { return d < 0.6f; });
  };
  EXPECT_GT(near_in("blocker_distance_min"), 200);
  EXPECT_LT(near_in("blocker_distance_p10"), near_in("blocker_distance_min") / 3);
}

TEST(Blocker, expected_penumbra_is_that_of_similar_triangles) {
  // Light of width 1 at height 5, sheet at 1: 1 * 1 / (5 - 1); the sun's: 2 tan(0.1) * 1.
  const std::vector<std::pair<Light, double>> lights{{rect_light_above(kPointLight, {1, 1}), 0.25},
                                                     {disk_light_above(kPointLight, 0.5), 0.25},
                                                     {sphere_light(kPointLight, 0.5), 0.25},
                                                     {sun_light({0, 1, 0}, 0.1), 2.0 * std::tan(0.1)}};
  for (const auto& [light, width] : lights) {
    Scene scene = floor_under(light, 0.01);
    add_half_plane(scene);
    finish_scene(scene);
    const Frame frame = render_reference(scene, {.side_px = 8});
    for (const float w : frame.image.plane("penumbra_width")) ASSERT_NEAR(w, width, 0.02 * width);
    for (const float h : frame.image.plane("contact_distance")) ASSERT_NEAR(h, kOccluderHeight, 1e-4);
  }
}

}  // namespace
}  // namespace umbrameter
