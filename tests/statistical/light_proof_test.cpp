// SPDX-License-Identifier: Apache-2.0
// A proof that is wrong once is a guess: rays are shot all the same, and the pictures must be equal to the bit.

#include "reference/ray_budget.h"
#include "tests/statistical/agreement.h"
#include "tests/statistical/oracle_scenes.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

std::vector<Light> one_of_each(const glm::dvec3& center) {
  return {rect_light_above(center, {1.2, 0.8}), disk_light_above(center, 0.5), sphere_light(center, 0.5),
          sun_light({0.3, 1, 0.2}, 0.02)};
}

/// Solids, thin sheets, a fine mesh and a big cover over a floor of many quads.
Scene varied_scene(const Light& light) {
  Scene scene;
  for (int i = 0; i < 64; ++i) add_floor(scene, {1, 1}, 0.0, {i % 8 - 3.5, i / 8 - 3.5});
  add_box(scene, {-1.0, 0.0, -0.5}, {-0.4, 0.9, 0.1});
  add_box(scene, {0.2, 0.3, -0.8}, {0.9, 0.5, 0.6});
  add_sphere(scene, {0.0, 0.7, 1.2}, 0.4, 24);
  add_floor(scene, {3, 3}, 1.4, {2.6, 0});
  add_quad(scene, {-2, 0, -2}, {-2, 0, 2}, {-2, 2, 2}, {-2, 2, -2});
  scene.lights = {light};
  scene.camera.eye_world = {2.5, 1.3, 4.5};
  scene.camera.at_world = {0, 0.3, 0};
  scene.camera.vertical_fov_deg = 60.0;
  finish_scene(scene);
  return scene;
}

Frame render(const Scene& scene, const ReferenceSettings& settings) {
  SilentProgress progress;
  RenderRequest request;
  request.width_px = 70;
  request.height_px = 54;
  return make_reference_renderer(settings)->render(scene, request, progress);
}

void expect_same_but_samples(Frame skipping, Frame tracing, const std::string& what) {
  skipping.image.planes.erase("sample_count");
  tracing.image.planes.erase("sample_count");
  for (const auto& [channel, plane] : skipping.image.planes) {
    EXPECT_TRUE(std::ranges::equal(plane, tracing.image.plane(channel))) << channel << ", " << what;
  }
}

void expect_proofs_hold(const Scene& scene, const std::string& what, double least_lit) {
  for (const std::optional<double> target : {std::optional<double>{}, std::optional<double>{0.01}}) {
    const Frame skipping = render(scene, {512, target, 0, true});
    expect_same_but_samples(skipping, render(scene, {512, target, 0, false}), what);
    const RayBudget budget = ray_budget(skipping.image);
    EXPECT_GT(budget.proven_lit, least_lit) << what;
    EXPECT_GT(budget.sampled, 0.01) << what;
    EXPECT_NEAR(budget.background + budget.unlit + budget.proven_lit + budget.proven_dark + budget.sampled,
                1.0, 1e-9);
  }
}

TEST(LightProof, rays_would_have_said_the_same_under_every_light) {
  for (const Light& light : one_of_each({0.4, 4, 0.3})) {
    const Scene scene = varied_scene(light);
    expect_proofs_hold(scene, std::string(to_text(light.type)), 0.15);
  }
}

TEST(LightProof, rays_would_have_said_the_same_after_a_motion_and_at_any_size) {
  const glm::dmat4 motion = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(20, -10, 30)), 1.1,
                                        glm::normalize(glm::dvec3(1, -2, 1)));
  const Scene scene = varied_scene(one_of_each({0.4, 4, 0.3})[0]);
  expect_proofs_hold(moved_scene(scene, motion), "moved", 0.15);
  expect_proofs_hold(scaled_scene(scene, 1e-3), "small", 0.15);
  expect_proofs_hold(scaled_scene(scene, 1e3), "large", 0.15);
}

TEST(LightProof, a_lamp_inside_the_scene_does_not_hide_behind_what_is_beyond_it) {
  // The cover lies above every light: nothing of it is between the floor and them.
  for (const Light& light : one_of_each({0, 1.0, 0})) {
    if (light.type == LightType::sun) continue;
    Scene scene = floor_under(light, 1.0);
    add_floor(scene, {9, 9}, 1.6);
    finish_scene(scene);
    scene.camera.eye_world = {0.9, 0.5, 0};
    scene.camera.up_world = {0, 1, 0};
    const Frame frame = render(scene, {64, {}, 0, true});
    expect_same_but_samples(frame, render(scene, {64, {}, 0, false}), std::string(to_text(light.type)));
    EXPECT_EQ(ray_budget(frame.image).proven_dark, 0.0);
  }
}

TEST(LightProof, one_triangle_over_all_of_the_light_is_a_cover) {
  for (const Light& light : one_of_each({0, kLightHeight, 0})) {
    Scene scene = floor_under(light, 0.4);
    add_quad(scene, {-30, 1, 30}, {30, 1, 30}, {30, 1, -1},
             {-30, 1, -30});  // the diagonal misses the picture
    finish_scene(scene);
    const Frame frame = render(scene, {64, {}, 0, true});
    EXPECT_GT(ray_budget(frame.image).proven_dark, 0.5) << to_text(light.type);
    expect_same_but_samples(frame, render(scene, {64, {}, 0, false}), std::string(to_text(light.type)));
  }
}

}  // namespace
}  // namespace umbrameter
