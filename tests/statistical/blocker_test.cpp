// Blocker distance and layers explain errors later; a wrong one would blame the wrong cause.

#include "tests/statistical/agreement.h"
#include "tests/statistical/oracle_scenes.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

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
      std::swap(scene.triangles[k].y, scene.triangles[k].z);
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
    ASSERT_LE(nearest, frame.image.plane("blocker_distance")[i]);
    if (frame.image.plane("visibility")[i] == 1.0f) {
      ASSERT_EQ(nearest, 0.0f);
    }
  }
}

}  // namespace
}  // namespace umbrameter
