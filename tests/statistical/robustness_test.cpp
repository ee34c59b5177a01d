// SPDX-License-Identifier: Apache-2.0
// No surface may shadow itself and no light may leak through a closed one, at any size and place.

#include "tests/statistical/agreement.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

void expect_all(const Frame& frame, float visibility) {
  const auto v = frame.image.plane("visibility");
  const auto id = frame.image.plane("primitive_id");
  size_t wrong = 0, seen = 0;
  for (size_t i = 0; i < v.size(); ++i) {
    if (id[i] < 0.0f) continue;
    ++seen;
    if (v[i] != visibility) ++wrong;
  }
  EXPECT_GT(seen, v.size() / 4);
  EXPECT_EQ(wrong, 0u) << "of " << seen;
}

/// `cells` x `cells` quads of one flat floor.
Scene tiled_floor(const Light& light, double size, int cells) {
  Scene scene;
  const double cell = size / cells;
  for (int i = 0; i < cells * cells; ++i) {
    add_floor(scene, {cell, cell}, 0.0,
              {(i % cells + 0.5) * cell - 0.5 * size, (i / cells + 0.5) * cell - 0.5 * size});
  }
  scene.lights = {light};
  scene.camera = camera_above({0, 0, 0}, 0.9 * size, size);
  finish_scene(scene);
  return scene;
}

glm::dmat4 tilted_and_moved(const glm::dvec3& offset) {
  return glm::rotate(glm::translate(glm::dmat4(1.0), offset), 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
}

TEST(Robustness, a_flat_floor_does_not_shadow_itself_under_a_grazing_sun) {
  // The sun's lower limb is 0.0005 rad above the floor.
  const Light sun = sun_light({std::cos(0.001), std::sin(0.001), 0}, 0.0005);
  expect_all(render_reference(tiled_floor(sun, 20.0, 1)), 1.0f);
  expect_all(render_reference(tiled_floor(sun, 20.0, 16)), 1.0f);
}

TEST(Robustness, a_tilted_floor_does_not_shadow_itself) {
  // Rounding the corners to float bends the floor by ulp / cell: 6e-8 * 20 / 1.25 = 1e-6 rad; the sun is at
  // 0.0005.
  const Light sun = sun_light({std::cos(0.001), std::sin(0.001), 0}, 0.0005);
  expect_all(render_reference(moved_scene(tiled_floor(sun, 20.0, 1), tilted_and_moved({0, 0, 0}))), 1.0f);
  expect_all(render_reference(moved_scene(tiled_floor(sun, 20.0, 16), tilted_and_moved({0, 0, 0}))), 1.0f);
}

TEST(Robustness, a_floor_far_from_the_origin_does_not_shadow_itself) {
  // At 1e4 corners are rounded by up to 5e-4: cells of 1.25 bend by 1e-3 rad, the sun is at 0.05.
  const Light sun = sun_light({std::cos(0.1), std::sin(0.1), 0}, 0.05);
  expect_all(render_reference(moved_scene(tiled_floor(sun, 20.0, 16), tilted_and_moved({1e4, -1e4, 1e4}))),
             1.0f);
}

TEST(Robustness, convex_solids_of_any_size_do_not_shadow_themselves) {
  for (const double size : {1e-3, 1.0, 1e4}) {
    Scene scene;
    add_sphere(scene, {0, 0, 0}, size, 24);
    scene.lights = {disk_light_above(glm::dvec3(0, 3, 0) * size, 0.5 * size)};
    scene.camera = camera_above({0, 0, 0}, 2.0 * size, 3.0 * size);
    finish_scene(scene);
    const Frame frame = render_reference(scene);
    const auto v = frame.image.plane("visibility");
    const auto id = frame.image.plane("primitive_id");
    // Facets that face the whole light: n . (l - p) > 0 for the light's lowest point over the facet.
    size_t wrong = 0, seen = 0;
    for (size_t i = 0; i < v.size(); ++i) {
      if (id[i] < 0.0f) continue;
      const glm::dvec3 n{frame.image.plane("normal.x")[i], frame.image.plane("normal.y")[i],
                         frame.image.plane("normal.z")[i]};
      const double to_center = glm::dot(n, scene.light().center_world - position_of(frame, i));
      if (to_center < 1.01 * scene.light().radius_world * std::hypot(n.x, n.z)) continue;
      ++seen;
      if (v[i] != 1.0f) ++wrong;
    }
    EXPECT_GT(seen, 1000u);
    EXPECT_EQ(wrong, 0u) << "at size " << size;
  }
}

TEST(Robustness, closed_rooms_let_no_light_in) {
  for (const double size : {1e-3, 1.0, 1e4}) {
    for (const int side_px : {64, 65}) {
      Scene scene;
      add_box(scene, glm::dvec3(-1, -1, -1) * size, glm::dvec3(1, 1, 1) * size);
      scene.lights = {rect_light_above(glm::dvec3(0.5, 1.2, 0.3) * size, glm::dvec2(3, 3) * size)};
      scene.camera.eye_world = {0, 0, 0};
      scene.camera.at_world = glm::dvec3(0.3, -0.7, -0.4) * size;
      scene.camera.vertical_fov_deg = 110.0;
      finish_scene(scene);
      expect_all(render_reference(scene, {.side_px = side_px}), 0.0f);
      expect_all(render_reference(moved_scene(scene, tilted_and_moved(glm::dvec3(3, 1, -2) * size)),
                                  {.side_px = side_px}),
                 0.0f);
    }
  }
}

TEST(Robustness, closed_spheres_let_no_light_in) {
  Scene scene;
  add_sphere(scene, {0, 0, 0}, 1.0, 48);
  scene.lights = {sphere_light({0, 2.5, 0}, 1.0)};
  scene.camera.eye_world = {0, 0, 0};
  scene.camera.at_world = {0.3, -0.7, -0.4};
  scene.camera.vertical_fov_deg = 110.0;
  finish_scene(scene);
  expect_all(render_reference(scene), 0.0f);
}

TEST(Robustness, a_sheet_a_tenth_of_a_millimetre_above_the_floor_shadows_it) {
  Scene scene;
  add_floor(scene, {2, 2});
  add_floor(scene, {4, 4}, 1e-4);
  scene.lights = {rect_light_above({0, 2, 0}, {1, 1})};
  scene.camera.eye_world = {0.9, 5e-5, 0};  // between the two
  scene.camera.at_world = {0.8, 4.5e-5, 0};
  scene.camera.vertical_fov_deg = 20.0;
  finish_scene(scene);
  scene.camera.near_world = 1e-6;
  expect_all(render_reference(scene), 0.0f);
}

TEST(Robustness, a_lamp_flush_with_the_ceiling_is_not_hidden_by_it) {
  Scene room;
  add_box(room, {-2, 0, -2}, {2, 3, 2});
  room.lights = {rect_light_above({0, 3, 0}, {1, 1})};
  room.camera = camera_above({0, 0, 0}, 3.9, 2.0);
  finish_scene(room);
  expect_all(render_reference(room), 1.0f);
}

}  // namespace
}  // namespace umbrameter
