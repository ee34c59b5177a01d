// SPDX-License-Identifier: Apache-2.0
// Without these a forest's truth could differ from that of the same trees each on its own.

#include "tests/support/instanced_scene.h"

#include "core/progress.h"
#include "reference/exact/exact_oracle.h"
#include "reference/exact_check.h"
#include "reference/reference.h"
#include "scenes/instances.h"
#include "scenes/merge_meshes.h"
#include "scenes/shapes.h"
#include "tests/statistical/agreement.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

const Light kLights[] = {rect_light_above({0.5, 4, 0.5}, {1, 0.7}), disk_light_above({0.5, 4, 0.5}, 0.5),
                         sphere_light({0.5, 4, 0.5}, 0.5), sun_light({0.4, 1, 0.3}, 0.05)};

const InstancedSceneOptions kOptions[] = {{false, false}, {true, false}, {false, true}};

Frame trace(const Scene& scene, int samples_per_pixel = 64, bool skip_proven = true) {
  SilentProgress progress;
  ReferenceSettings settings;
  settings.samples_per_pixel = samples_per_pixel;
  settings.skip_proven = skip_proven;
  return make_reference_renderer(settings)->render(
      scene, {.width_px = 96, .height_px = 64, .seed = 1, .technique = {}, .parameters = {}}, progress);
}

/// Share of pixels at which the planes differ by more than `tolerance`.
double different(const Frame& a, const Frame& b, const std::string& channel, float tolerance) {
  const auto x = a.image.plane(channel), y = b.image.plane(channel);
  size_t count = 0;
  for (size_t i = 0; i < x.size(); ++i) count += std::abs(x[i] - y[i]) <= tolerance ? 0 : 1;
  return static_cast<double>(count) / static_cast<double>(x.size());
}

TEST(Instances, have_the_truth_of_their_flattened_twin) {
  for (const Light& light : kLights) {
    for (const InstancedSceneOptions& options : kOptions) {
      const Scene scene = instanced_scene(light, options);
      const Frame own = trace(scene), flat = trace(flattened(scene));
      const std::string of =
          fmt::format("{} {} {}", to_text(light.type), options.is_smooth, options.has_leaves);
      // The same rays to a few roundings: one of 64 may pass an edge on the other side.
      EXPECT_LE(different(own, flat, "visibility", 1e-6f), 0.01) << of;
      EXPECT_LE(different(own, flat, "visibility", 0.04f), 0.001) << of;
      EXPECT_LE(different(own, flat, "irradiance_ratio", 0.04f), 0.001) << of;
      EXPECT_LE(different(own, flat, "blocker_layers", 1e-3f), 0.02) << of;
      for (const char* axis : {"x", "y", "z"}) {
        EXPECT_LE(different(own, flat, std::string("position.") + axis, 1e-5f), 0.001) << of;
        EXPECT_LE(different(own, flat, std::string("normal.") + axis, 1e-4f), 0.001) << of;
        EXPECT_LE(different(own, flat, std::string("shading_normal.") + axis, 1e-4f), 0.001) << of;
      }
      if (options.has_leaves) continue;  // then they are numbered otherwise
      EXPECT_LE(different(own, flat, "primitive_id", 0.0f), 0.001) << of;
    }
  }
}

TEST(Instances, skip_nothing_that_rays_would_have_met) {
  const Scene scene = instanced_scene(kLights[0]);
  const Frame skipping = trace(scene), all = trace(scene, 64, false);
  EXPECT_EQ(different(skipping, all, "visibility", 0.0f), 0.0);
  const auto samples = skipping.image.plane("sample_count");
  EXPECT_GT(std::ranges::count(samples, 0.0f), 96 * 64 / 20) << "some of the floor is proven to be lit";
}

/// Balls that nothing is above, turned and stretched, far from the origin: their rays start where Embree cannot find the plate again.
TEST(Instances, do_not_shade_themselves) {
  std::vector<NamedMesh> meshes(2);
  meshes[0].name = "floor";
  meshes[0].mesh = make_plane({2000, 2000});
  meshes[1].name = "balls";
  std::vector<glm::dmat4> places;
  for (int i = 0; i < 5; ++i) {
    glm::dmat4 place = glm::translate(glm::dmat4(1.0), glm::dvec3(700 + i, 2 + 0.1 * i, 800));
    place = glm::rotate(place, 0.1 * i, glm::dvec3(0.3, 0.1, 1));
    places.push_back(glm::scale(place, glm::dvec3(0.7, 0.9 + i, 0.4)));
  }
  meshes[1].mesh.repeated.push_back({make_sphere(0.5, 24, true), places});
  Scene scene;
  merge_meshes(meshes, scene);
  scene.lights = {sun_light({0.3, 1, 0.2}, 0.01)};
  scene.camera = {.eye_world = {702, 9, 803}, .at_world = {702, 2.5, 800}, .near_world = 0.1};
  const Frame own = trace(scene), flat = trace(flattened(scene));
  const auto id = own.image.plane("primitive_id"), v = own.image.plane("visibility"),
             w = flat.image.plane("visibility");
  size_t seen = 0, darker = 0;
  for (size_t i = 0; i < id.size(); ++i) {
    if (id[i] < 2.0f || w[i] < 1.0f) continue;
    ++seen;
    darker += v[i] < 1.0f ? 1 : 0;
  }
  EXPECT_GT(seen, 250u);
  EXPECT_LE(darker, seen / 200);
}

TEST(Instances, are_unrolled_for_the_exact_check) {
  std::vector<NamedMesh> meshes(2);
  meshes[0].mesh = make_plane({8, 6});
  const glm::dmat4 one(1.0);
  meshes[1].mesh.repeated.push_back(
      {make_box({0.7, 1, 0.5}),
       {glm::translate(one, glm::dvec3(-1, 0.2, 0)),
        glm::rotate(glm::translate(one, glm::dvec3(1, 0.1, 0.3)), 0.4, glm::dvec3(0, 1, 0))}});
  Scene scene;
  merge_meshes(meshes, scene);
  scene.lights = {kLights[0]};
  scene.camera = {.eye_world = {1.5, 3.2, 4.5}, .at_world = {0, 0.4, 0}, .near_world = 1e-3};
  const Frame frame = trace(scene, 1024);
  SilentProgress progress;
  const std::vector<size_t> pixels = draw_check_pixels(frame.image, 12, 1);
  const ExactComparison comparison =
      compare_with_exact(check_pixels(scene, frame.image, pixels, exact_oracle(), 0, progress));
  EXPECT_EQ(comparison.others_wrong, 0u);
  EXPECT_LT(std::abs(comparison.penumbra.mean_error), 0.02);
  EXPECT_LT(comparison.penumbra.rms_error, 0.03);
}

TEST(Instances, that_change_are_seen) {
  Scene scene = instanced_scene(kLights[0]);
  ReferenceSettings settings;
  settings.samples_per_pixel = 16;
  const auto renderer = make_reference_renderer(settings);
  SilentProgress progress;
  const RenderRequest request{.width_px = 96, .height_px = 64, .seed = 1, .technique = {}, .parameters = {}};
  const Frame before = renderer->render(scene, request, progress);
  auto moved = std::make_shared<InstancedMesh>(*scene.instanced.back());
  moved->world_from_mesh[0][3].x += 0.5f;
  scene.instanced.back() = moved;
  const Frame after = renderer->render(scene, request, progress);
  EXPECT_GT(different(before, after, "visibility", 0.1f), 0.01);
}

}  // namespace
}  // namespace umbrameter
