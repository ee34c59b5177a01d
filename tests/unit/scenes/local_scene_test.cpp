// SPDX-License-Identifier: Apache-2.0
// Without these: a scene far from the origin is moved inexactly, or every scene is moved.
#include "scenes/local_scene.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>

#include <cmath>

namespace umbrameter {
namespace {

Scene scene_at(const glm::dvec3& offset_world) {
  Scene scene;
  scene.camera.eye_world = offset_world + glm::dvec3(0, 1, 3);
  scene.camera.at_world = offset_world;
  Light light;
  light.center_world = offset_world + glm::dvec3(0, 4, 0);
  scene.lights = {light};
  for (const glm::dvec3& p : {glm::dvec3(-4, 0, 4), glm::dvec3(4.1, 0.3, 4), glm::dvec3(0.1, 2, -4.7)}) {
    scene.positions_world.edit().emplace_back(offset_world + p);
    scene.bounds_world.min = glm::min(scene.bounds_world.min, glm::dvec3(scene.positions_world.back()));
    scene.bounds_world.max = glm::max(scene.bounds_world.max, glm::dvec3(scene.positions_world.back()));
  }
  scene.triangles = {{0, 1, 2}};
  return scene;
}

TEST(LocalScene, scenes_near_the_origin_stay) {
  EXPECT_FALSE(local_scene(scene_at({0, 0, 0})));
  EXPECT_FALSE(local_scene(scene_at({100, 0, -50})));
  EXPECT_FALSE(local_scene(Scene{}));
}

TEST(LocalScene, moves_exactly) {
  for (const double offset : {1e3, 1e5, 1.2345e6, -3e7}) {
    const Scene scene = scene_at({offset, 0, 0.7 * offset});
    const auto local = local_scene(scene);
    ASSERT_TRUE(local) << offset;
    EXPECT_EQ(local->origin_world.y, 0.0);
    for (size_t i = 0; i < scene.positions_world.size(); ++i) {
      const glm::dvec3 back = glm::dvec3(local->scene.positions_world[i]) + local->origin_world;
      EXPECT_EQ(back, glm::dvec3(scene.positions_world[i])) << offset;  // to the last bit
      EXPECT_LT(std::abs(local->scene.positions_world[i].x), 24.0f);
    }
    EXPECT_EQ(local->scene.camera.eye_world + local->origin_world, scene.camera.eye_world);
    EXPECT_EQ(local->scene.lights[0].center_world + local->origin_world, scene.lights[0].center_world);
  }
}

TEST(LocalScene, pictures_say_where_the_scene_is) {
  Image image(2, 1);
  for (const char* channel : {"position.x", "position.y", "position.z", "primitive_id"})
    image.add_plane(channel);
  image.plane("position.x")[0] = 1.5f;
  image.plane("primitive_id")[1] = -1.0f;
  add_origin({1000, 0, -8}, image);
  EXPECT_EQ(image.plane("position.x")[0], 1001.5f);
  EXPECT_EQ(image.plane("position.z")[0], -8.0f);
  EXPECT_EQ(image.plane("position.x")[1], 0.0f);  // nothing is hit there
}

}  // namespace
}  // namespace umbrameter
