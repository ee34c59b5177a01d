// SPDX-License-Identifier: Apache-2.0
// Without these the reference could be wrong by a factor in a penumbra and nothing else would notice.

#include "tests/statistical/agreement.h"
#include "tests/statistical/oracle_scenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace umbrameter {
namespace {

const glm::dvec3 kLightCenter{0, kLightHeight, 0};

std::vector<Light> one_of_each() {
  return {rect_light_above(kLightCenter, {1, 1}), disk_light_above(kLightCenter, 0.5),
          sphere_light(kLightCenter, 0.5), sun_light({0, 1, 0}, 0.02)};
}

void expect_everywhere(const Frame& frame, const char* channel, float value) {
  const auto plane = frame.image.plane(channel);
  for (size_t i = 0; i < plane.size(); ++i) ASSERT_EQ(plane[i], value) << channel << " at pixel " << i;
}

TEST(ClosedForm, an_empty_plane_is_fully_lit_by_every_light) {
  for (const Light& light : one_of_each()) {
    Scene scene = floor_under(light, 4.0);
    finish_scene(scene);
    const Frame frame = render_reference(scene);
    expect_everywhere(frame, "visibility", 1.0f);
    expect_everywhere(frame, "irradiance_ratio", 1.0f);
    expect_everywhere(frame, "half_a", 1.0f);
    expect_everywhere(frame, "half_b", 1.0f);
    expect_everywhere(frame, "blocker_distance", 0.0f);
    // Nothing stands between: proven, without a ray.
    expect_everywhere(frame, "visibility_se", 0.0f);
    expect_everywhere(frame, "sample_count", 0.0f);
  }
}

TEST(ClosedForm, a_covered_floor_is_black_under_every_light) {
  for (const Light& light : one_of_each()) {
    Scene scene = floor_under(light, 0.4);
    add_floor(scene, {4, 4}, kOccluderHeight);
    finish_scene(scene);
    const Frame frame = render_reference(scene);
    expect_everywhere(frame, "visibility", 0.0f);
    expect_everywhere(frame, "irradiance_ratio", 0.0f);
  }
}

TEST(ClosedForm, a_light_below_the_horizon_is_not_seen_with_certainty) {
  Scene scene = floor_under(disk_light_above({0, -2, 0}, 0.5), 1.0);
  finish_scene(scene);
  const Frame frame = render_reference(scene);
  expect_everywhere(frame, "visibility", 0.0f);
  expect_everywhere(frame, "visibility_se", 0.0f);
  expect_everywhere(frame, "unshadowed_irradiance", 0.0f);
}

TEST(ClosedForm, background_is_lit_and_holds_nothing) {
  Scene scene = floor_under(sun_light({0, 1, 0}, 0.01), 1.0);
  scene.camera.at_world.y = 10.0;
  scene.camera.up_world = {0, 0, 1};
  finish_scene(scene);
  const Frame frame = render_reference(scene);
  expect_everywhere(frame, "visibility", 1.0f);
  expect_everywhere(frame, "visibility_se", 0.0f);
  expect_everywhere(frame, "primitive_id", -1.0f);
  expect_everywhere(frame, "position.y", 0.0f);
}

TEST(ClosedForm, half_plane_under_a_square_light_is_a_linear_ramp) {
  Scene scene = floor_under(rect_light_above(kLightCenter, {1, 1}), 0.4);
  add_half_plane(scene);
  finish_scene(scene);
  const auto ramp = in_penumbra([](const glm::dvec3& p) { return half_plane_square(p.x, 1.0); });
  EXPECT_EQ(objection(compare(render_reference(scene), ramp)), "");
}

TEST(ClosedForm, half_plane_under_a_disk_light_is_a_segment_of_the_disk) {
  Scene scene = floor_under(disk_light_above(kLightCenter, 0.5), 0.4);
  add_half_plane(scene);
  finish_scene(scene);
  const auto segment = in_penumbra([](const glm::dvec3& p) { return half_plane_disk(p.x, 0.5); });
  EXPECT_EQ(objection(compare(render_reference(scene), segment)), "");
}

TEST(ClosedForm, half_plane_under_a_sphere_light_is_a_segment_of_its_cone) {
  Scene scene = floor_under(sphere_light(kLightCenter, 0.5), 0.4);
  add_half_plane(scene);
  finish_scene(scene);
  const auto segment = in_penumbra([](const glm::dvec3& p) { return half_plane_sphere(p, 0.5); });
  EXPECT_EQ(objection(compare(render_reference(scene), segment)), "");
}

TEST(ClosedForm, half_plane_under_the_sun_is_a_segment_of_its_disk) {
  const double half_angle_rad = 0.1;
  Scene scene = floor_under(sun_light({0, 1, 0}, half_angle_rad), 0.3);
  add_half_plane(scene);
  finish_scene(scene);
  const auto segment = in_penumbra([&](const glm::dvec3& p) { return half_plane_sun(p.x, half_angle_rad); });
  EXPECT_EQ(objection(compare(render_reference(scene), segment)), "");
}

TEST(ClosedForm, plate_under_a_rectangle_is_a_separable_overlap) {
  const glm::dvec2 half{0.1, 0.15};
  const glm::dvec2 size{1.0, 0.6};
  Scene scene = floor_under(rect_light_above(kLightCenter, size), 0.7);
  add_floor(scene, 2.0 * half, kOccluderHeight);
  finish_scene(scene);
  const auto overlap = in_penumbra([&](const glm::dvec3& p) { return plate_rect(p, half, size); });
  EXPECT_EQ(objection(compare(render_reference(scene), overlap)), "");
}

TEST(ClosedForm, disk_on_the_axis_of_a_disk_light_is_a_lens) {
  Scene scene = floor_under(disk_light_above(kLightCenter, 0.5), 0.6);
  add_disk(scene, {0, kOccluderHeight, 0}, 0.12, 720);  // the polygon lacks 1.3e-5 of the circle's area
  finish_scene(scene);
  const auto lens = in_penumbra([](const glm::dvec3& p) { return coaxial_disks(p, 0.12, 0.5); });
  EXPECT_EQ(objection(compare(render_reference(scene), lens)), "");
}

TEST(ClosedForm, thin_wire_darkens_by_its_share_of_the_light) {
  const glm::dvec2 half{0.004, 5.0};  // its shadow on the light is 0.04 wide: V = 0.96 at the darkest
  Scene scene = floor_under(rect_light_above(kLightCenter, {1, 1}), 0.4);
  add_floor(scene, 2.0 * half, kOccluderHeight);
  finish_scene(scene);
  const auto strip = in_penumbra([&](const glm::dvec3& p) { return plate_rect(p, half, {1, 1}); });
  EXPECT_EQ(objection(compare(render_reference(scene), strip)), "");
}

TEST(ClosedForm, unshadowed_irradiance_is_that_of_the_whole_light) {
  const double r = 0.5;
  const double h = kLightHeight;
  // Rectangle: corner form. Disk on the axis: pi r^2 / (r^2 + h^2). Sphere: pi (r/h)^2. Sun overhead: mean
  // cosine over the disk of radius t = tan(half angle): 2 (sqrt(1 + t^2) - 1) / t^2.
  const double t = std::tan(0.02);
  const double expected[] = {rectangle_irradiance(-0.5, 0.5, -0.5, 0.5, h),
                             std::numbers::pi * r * r / (r * r + h * h), std::numbers::pi * r * r / (h * h),
                             2.0 * (std::sqrt(1.0 + t * t) - 1.0) / (t * t)};
  const std::vector<Light> lights = one_of_each();
  for (size_t i = 0; i < lights.size(); ++i) {
    Scene scene = floor_under(lights[i], 1e-3);  // the picture is a point: r changes by 1e-7
    finish_scene(scene);
    const Frame frame = render_reference(scene, {.side_px = 4, .samples_per_pixel = 8});
    const auto irradiance = frame.image.plane("unshadowed_irradiance");
    for (const float e : irradiance) EXPECT_NEAR(e / expected[i], 1.0, 1e-4) << to_text(lights[i].type);
  }
}

TEST(ClosedForm, irradiance_ratio_is_the_seen_parts_share_of_irradiance) {
  // A big light near the floor, so that S and V differ: from x the half-plane leaves [-4x, 1] of [-1, 1] x
  // [-1, 1].
  const double size = 8.0;
  Scene scene = floor_under(rect_light_above(kLightCenter, {size, size}), 1.8);
  add_half_plane(scene);
  finish_scene(scene);
  const Frame frame = render_reference(scene, {.side_px = 32, .samples_per_pixel = 4096});
  const auto ratio = frame.image.plane("irradiance_ratio");
  double worst = 0.0;
  for (size_t i = 0; i < ratio.size(); ++i) {
    const glm::dvec3 p = position_of(frame, i);
    const double low = std::clamp(-4.0 * p.x, -0.5 * size, 0.5 * size) - p.x;
    const double high = 0.5 * size - p.x;
    const double near_z = -0.5 * size - p.z;
    const double far_z = 0.5 * size - p.z;
    const double seen = rectangle_irradiance(low, high, near_z, far_z, kLightHeight);
    const double whole = rectangle_irradiance(-0.5 * size - p.x, high, near_z, far_z, kLightHeight);
    worst = std::max(worst, std::abs(ratio[i] - seen / whole));
  }
  EXPECT_LT(worst, 5.0 * 5e-4);  // the standard error of S is about that of V: below 5e-4 at 4096 samples
}

}  // namespace
}  // namespace umbrameter
