// SPDX-License-Identifier: Apache-2.0
// Relations that need no known answer, on scenes no closed form covers.

#include "tests/statistical/agreement.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

Scene cluttered_scene() {
  Scene scene;
  add_floor(scene, {8, 8});
  add_box(scene, {-1.0, 0.0, -0.5}, {-0.4, 0.9, 0.1});
  add_box(scene, {0.2, 0.3, -0.8}, {0.9, 0.5, 0.6});
  add_sphere(scene, {0.0, 0.7, 1.0}, 0.4, 12);
  add_disk(scene, {0.5, 1.2, 0.2}, 0.5, 24);
  scene.lights = {rect_light_above({0.7, 4, 0.5}, {1.5, 1.0})};
  scene.camera.eye_world = {2.5, 2.0, 3.5};
  scene.camera.at_world = {0, 0.3, 0};
  finish_scene(scene);
  return scene;
}

double rms_difference(const Frame& a, const Frame& b) {
  const auto va = a.image.plane("visibility");
  const auto vb = b.image.plane("visibility");
  double sum = 0.0;
  for (size_t i = 0; i < va.size(); ++i) sum += std::pow(static_cast<double>(va[i]) - vb[i], 2);
  return std::sqrt(sum / static_cast<double>(va.size()));
}

double rms_se(const Frame& frame) {
  double sum = 0.0;
  for (const float se : frame.image.plane("visibility_se")) sum += static_cast<double>(se) * se;
  return std::sqrt(sum / static_cast<double>(frame.image.pixel_count()));
}

TEST(Metamorphic, an_occluder_more_never_brightens_a_pixel) {
  const Scene before = cluttered_scene();
  Scene after = before;
  add_floor(after, {0.6, 0.3}, 2.5, {0.3, 0.4});  // out of the camera's sight lines to the rest
  finish_scene(after);
  after.camera.near_world = before.camera.near_world;
  const Frame a = render_reference(before);
  const Frame b = render_reference(after);
  const auto id_a = a.image.plane("primitive_id");
  const auto id_b = b.image.plane("primitive_id");
  size_t darker = 0;
  for (size_t i = 0; i < id_a.size(); ++i) {
    if (id_a[i] != id_b[i]) continue;  // the occluder itself is in view there
    ASSERT_LE(b.image.plane("visibility")[i], a.image.plane("visibility")[i]) << "pixel " << i;
    if (b.image.plane("visibility")[i] < a.image.plane("visibility")[i]) ++darker;
  }
  EXPECT_GT(darker, 100u);
}

TEST(Metamorphic, a_rigid_motion_changes_nothing_but_rounding) {
  const Scene scene = cluttered_scene();
  const glm::dmat4 motion = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(2, -1, 3)), 1.1,
                                        glm::normalize(glm::dvec3(1, -2, 1)));
  const Frame still = render_reference(scene);
  const Frame moved = render_reference(moved_scene(scene, motion));
  // The same samples meet the same geometry; only those within rounding of an edge may change sides.
  EXPECT_LT(rms_difference(still, moved), rms_se(still));
}

TEST(Metamorphic, scaling_by_a_power_of_two_changes_no_bit_of_visibility) {
  const Scene scene = cluttered_scene();
  const Frame plain = render_reference(scene);
  for (const double scale : {0x1p-10, 0x1p+10}) {
    const Frame scaled = render_reference(scaled_scene(scene, scale));
    EXPECT_TRUE(std::ranges::equal(plain.image.plane("visibility"), scaled.image.plane("visibility")))
        << scale;
    EXPECT_TRUE(std::ranges::equal(plain.image.plane("primitive_id"), scaled.image.plane("primitive_id")))
        << scale;
  }
}

TEST(Metamorphic, triangle_order_does_not_matter) {
  const Scene scene = cluttered_scene();
  Scene reversed = scene;
  std::ranges::reverse(reversed.triangles.edit());
  for (glm::uvec3& t : reversed.triangles.edit()) t = {t.y, t.z, t.x};
  const Frame a = render_reference(scene);
  const Frame b = render_reference(reversed);
  EXPECT_LT(rms_difference(a, b), 0.1 * rms_se(a));
  const auto id_a = a.image.plane("primitive_id");
  const auto id_b = b.image.plane("primitive_id");
  const auto last = static_cast<float>(scene.triangles.size() - 1);
  size_t mapped = 0;
  for (size_t i = 0; i < id_a.size(); ++i) {
    if (id_a[i] < 0.0f ? id_b[i] < 0.0f : id_b[i] == last - id_a[i]) ++mapped;
  }
  EXPECT_GE(mapped, id_a.size() * 99 / 100);  // pixels on a shared edge may take either side
}

TEST(Metamorphic, winding_does_not_matter) {
  const Scene scene = cluttered_scene();
  Scene turned = scene;
  for (glm::uvec3& t : turned.triangles.edit()) std::swap(t.y, t.z);
  EXPECT_LT(rms_difference(render_reference(scene), render_reference(turned)),
            0.1 * rms_se(render_reference(scene)));
}

TEST(Metamorphic, a_light_is_the_mean_of_its_quarters) {
  const Scene whole = cluttered_scene();
  const Frame reference = render_reference(whole, {.samples_per_pixel = 1024});
  std::vector<double> mean(reference.image.pixel_count(), 0.0);
  std::vector<double> variance(reference.image.pixel_count(), 0.0);
  for (int quarter = 0; quarter < 4; ++quarter) {
    Scene part = whole;
    Light& light = part.lights[0];
    light.size_world *= 0.5;
    light.center_world += light.tangent_world * light.size_world.x * (quarter % 2 - 0.5) +
                          light.bitangent_world * light.size_world.y * (quarter / 2 - 0.5);
    const Frame frame = render_reference(part, {.samples_per_pixel = 256, .seed = 10u + quarter});
    for (size_t i = 0; i < mean.size(); ++i) {
      mean[i] += 0.25 * frame.image.plane("visibility")[i];
      variance[i] += std::pow(0.25 * frame.image.plane("visibility_se")[i], 2);
    }
  }
  double difference_sum = 0.0, difference2 = 0.0, variance_sum = 0.0;
  for (size_t i = 0; i < mean.size(); ++i) {
    const double se = reference.image.plane("visibility_se")[i];
    const double difference = reference.image.plane("visibility")[i] - mean[i];
    difference_sum += difference;
    difference2 += difference * difference;
    variance_sum += variance[i] + se * se;
  }
  EXPECT_LT(std::abs(difference_sum), 4.0 * std::sqrt(variance_sum));
  EXPECT_LT(difference2,
            1.2 * variance_sum);  // lit and black pixels keep the error floor: it may be far smaller
}

TEST(Metamorphic, other_lights_of_the_file_do_not_matter) {
  const Scene one = cluttered_scene();
  Scene many = one;
  many.lights.assign(64, rect_light_above({-1.0, 3, 0.0}, {0.2, 0.2}));
  many.lights[63] = one.lights[0];
  many.active_light = 63;
  EXPECT_EQ(rms_difference(render_reference(one), render_reference(many)), 0.0);
  many.active_light = 0;
  EXPECT_GT(rms_difference(render_reference(one), render_reference(many)), 0.1);
}

TEST(Metamorphic, a_shrinking_light_tends_to_the_hard_shadow) {
  Scene scene = cluttered_scene();
  double penumbra_before = 1.0;
  for (const double size : {1.0, 0.25, 0.01}) {
    scene.lights[0].size_world = {size, size};
    const Frame frame = render_reference(scene);
    const auto v = frame.image.plane("visibility");
    const auto count = std::ranges::count_if(v, [](float x) { return x > 0.0f && x < 1.0f; });
    const double penumbra = static_cast<double>(count) / static_cast<double>(v.size());
    EXPECT_LT(penumbra, penumbra_before);
    penumbra_before = penumbra;
  }
  EXPECT_LT(penumbra_before, 0.02);
}

}  // namespace
}  // namespace umbrameter
