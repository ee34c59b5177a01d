// SPDX-License-Identifier: Apache-2.0
// What must not change a shadow: where a scene stands, how big it is, which hand it has, how its surfaces are cut up.

#include "tests/statistical/agreement.h"

#include "scenes/rounding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

Scene furnished_scene(const Light& light) {
  Scene scene;
  add_floor(scene, {8, 8});
  add_box(scene, {-1.0, 0.0, -0.5}, {-0.4, 0.9, 0.1});
  add_box(scene, {0.2, 0.3, -0.8}, {0.9, 0.5, 0.6});
  add_sphere(scene, {0.0, 0.7, 1.0}, 0.4, 16);
  scene.lights = {light};
  scene.camera.eye_world = {2.5, 2.0, 3.5};
  scene.camera.at_world = {0, 0.3, 0};
  finish_scene(scene);
  return scene;
}

std::vector<Light> one_of_each(const glm::dvec3& center) {
  return {rect_light_above(center, {1.5, 1.0}), disk_light_above(center, 0.6), sphere_light(center, 0.5),
          sun_light({0.3, 1, 0.2}, 0.05)};
}

double rms_of(std::span<const float> values) {
  double sum = 0.0;
  for (const float v : values) sum += static_cast<double>(v) * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double rms_difference(const Frame& a, const Frame& b) {
  std::vector<float> difference(a.image.pixel_count());
  std::ranges::transform(a.image.plane("visibility"), b.image.plane("visibility"), difference.begin(),
                         std::minus<>());
  return rms_of(difference);
}

/// Four triangles for each, cut at the middles of its edges.
Scene split_scene(const Scene& scene) {
  Scene split = scene;
  std::vector<glm::uvec3> triangles;
  for (const glm::uvec3& t : scene.triangles) {
    const auto first = static_cast<uint32_t>(split.positions_world.size());
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 a = scene.positions_world[t[k]], b = scene.positions_world[t[(k + 1) % 3]];
      split.positions_world.edit().emplace_back(0.5 * (a + b));
    }
    const glm::uvec3 m{first, first + 1, first + 2};
    triangles.insert(triangles.end(), {{t.x, m.x, m.z}, {m.x, t.y, m.y}, {m.z, m.y, t.z}, m});
  }
  split.triangles = std::move(triangles);
  finish_scene(split);
  return split;
}

glm::dvec3 mirrored(glm::dvec3 v) {
  v.x = -v.x;
  return v;
}

Scene mirrored_scene(const Scene& scene) {
  Scene mirror = scene;
  for (glm::vec3& p : mirror.positions_world.edit()) p.x = -p.x;
  for (glm::uvec3& t : mirror.triangles.edit()) std::swap(t.y, t.z);
  mirror.camera.eye_world = mirrored(scene.camera.eye_world);
  mirror.camera.at_world = mirrored(scene.camera.at_world);
  Light& light = mirror.lights[0];
  light.center_world = mirrored(light.center_world);
  light.direction_world = mirrored(light.direction_world);
  light.bitangent_world = mirrored(light.bitangent_world);
  light.tangent_world =
      glm::cross(light.bitangent_world, light.direction_world);  // the frame stays right-handed
  finish_scene(mirror);
  return mirror;
}

TEST(Invariance, any_size_from_a_thousandth_to_a_thousand_gives_the_same_shadow) {
  for (const Light& light : one_of_each({0.7, 4, 0.5})) {
    const Scene scene = furnished_scene(light);
    const Frame plain = render_reference(scene);
    for (const double scale : {1e-3, 0.03, 30.0, 1e3}) {
      // The same samples meet the same geometry up to rounding: only those at an edge change sides.
      EXPECT_LT(rms_difference(plain, render_reference(scaled_scene(scene, scale))),
                0.5 * rms_of(plain.image.plane("visibility_se")))
          << to_text(light.type) << " " << scale;
    }
  }
}

TEST(Invariance, cutting_triangles_up_does_not_matter) {
  for (const Light& light : one_of_each({0.7, 4, 0.5})) {
    const Scene scene = furnished_scene(light);
    const Frame plain = render_reference(scene);
    const Frame split = render_reference(split_scene(split_scene(scene)));
    EXPECT_LT(rms_difference(plain, split), 0.5 * rms_of(plain.image.plane("visibility_se")))
        << to_text(light.type);
  }
}

TEST(Invariance, the_mirror_shows_the_mirrored_shadow) {
  for (const Light& light : one_of_each({0.7, 4, 0.5})) {
    const Frame plain = render_reference(furnished_scene(light));
    const Frame mirror = render_reference(mirrored_scene(furnished_scene(light)), {.seed = 2});
    const int width = plain.image.width;
    double difference_sum = 0.0, difference2 = 0.0, variance_sum = 0.0;
    for (size_t i = 0; i < plain.image.pixel_count(); ++i) {
      const size_t column = i % static_cast<size_t>(width);
      const size_t j = i - column + static_cast<size_t>(width) - 1 - column;
      const double difference =
          static_cast<double>(plain.image.plane("visibility")[i]) - mirror.image.plane("visibility")[j];
      difference_sum += difference;
      difference2 += difference * difference;
      variance_sum += std::pow(static_cast<double>(plain.image.plane("visibility_se")[i]), 2) +
                      std::pow(static_cast<double>(mirror.image.plane("visibility_se")[j]), 2);
    }
    EXPECT_LT(std::abs(difference_sum), 4.0 * std::sqrt(variance_sum)) << to_text(light.type);
    EXPECT_LT(difference2, 1.2 * variance_sum) << to_text(light.type);
  }
}

TEST(Invariance, far_from_the_origin_shadows_get_coarse_but_stay_and_the_picture_says_so) {
  const Scene scene = furnished_scene(rect_light_above({0.7, 4, 0.5}, {1.5, 1.0}));
  const Frame near = render_reference(scene);
  EXPECT_FALSE(rounding_warning(scene));
  const auto moved = [&](double offset) {
    return moved_scene(scene, glm::translate(glm::dmat4(1.0), glm::dvec3(offset, offset, -offset)));
  };
  // At 1e5 corners are rounded by up to 0.006, less than a hundredth of any solid here.
  const Frame far = render_reference(moved(1e5));
  EXPECT_THAT(rounding_warning(moved(1e5)), testing::Optional(testing::HasSubstr("rounded by up to 0.006")));
  EXPECT_LT(rms_difference(near, far), 0.1);
  for (const float v : far.image.plane("visibility")) ASSERT_TRUE(v >= 0.0f && v <= 1.0f);
  EXPECT_LT(rms_difference(near, render_reference(moved(1e2))), 0.01);
}

/// How far p's tangent plane is from the light: at least 1 = all of it is above, at most -1 = all below.
double clearance(const Light& light, const glm::dvec3& p, const glm::dvec3& n) {
  if (light.type == LightType::sun)
    return -glm::dot(n, light.direction_world) / std::sin(light.half_angle_rad);
  const double radius =
      light.type == LightType::rect ? 0.5 * glm::length(light.size_world) : light.radius_world;
  return glm::dot(n, light.center_world - p) / radius;
}

void expect_no_false_shadow(const Scene& scene, const std::string& what) {
  const Frame frame = render_reference(scene);
  size_t lit = 0, dark = 0, wrong = 0;
  for (size_t i = 0; i < frame.image.pixel_count(); ++i) {
    if (frame.image.plane("primitive_id")[i] < 0.0f) continue;
    const glm::dvec3 n{frame.image.plane("normal.x")[i], frame.image.plane("normal.y")[i],
                       frame.image.plane("normal.z")[i]};
    const double c = clearance(scene.light(), position_of(frame, i), n);
    const float v = frame.image.plane("visibility")[i];
    if (c > 1.01) ++lit;
    if (c < -1.01) ++dark;
    if ((c > 1.01 && v != 1.0f) || (c < -1.01 && v != 0.0f)) ++wrong;
  }
  EXPECT_GT(lit + dark, 100u) << what;
  EXPECT_EQ(wrong, 0u) << what << ", lit " << lit << ", dark " << dark;
}

glm::dmat4 tilted_and_moved(const glm::dvec3& offset) {
  return glm::rotate(glm::translate(glm::dmat4(1.0), offset), 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
}

TEST(Invariance, no_convex_solid_shadows_itself_under_any_light) {
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> solids{
      {"cube",
       [](Scene& s) {
         add_box(s, {-0.7, -0.7, -0.7}, {0.7, 0.7, 0.7});
       }},
      {"plate",
       [](Scene& s) {
         add_box(s, {-1, -0.005, -1}, {1, 0.005, 1});
       }},
      {"needle",
       [](Scene& s) {
         add_box(s, {-0.3, -1, -0.3}, {0.3, 1, 0.3});
       }},
      {"ball",
       [](Scene& s) {
         add_sphere(s, {0, 0, 0}, 1.0, 64);
       }},
      {"octahedron", [](Scene& s) {
         add_sphere(s, {0, 0, 0}, 1.0, 2);
       }}};
  for (const auto& [name, add_solid] : solids) {
    for (const Light& light : one_of_each({0.4, 3, 0.3})) {
      Scene scene;
      add_solid(scene);
      scene.lights = {light};
      scene.camera.eye_world = {1.5, 2.2, 2.0};
      scene.camera.at_world = {0, 0, 0};
      scene.camera.vertical_fov_deg = 35.0;
      finish_scene(scene);
      const std::string what = name + ", " + std::string(to_text(light.type));
      expect_no_false_shadow(scene, what);
      expect_no_false_shadow(moved_scene(scene, tilted_and_moved({30, -10, 20})), what + ", moved");
      expect_no_false_shadow(scaled_scene(scene, 1e-3), what + ", small");
    }
  }
}

TEST(Invariance, no_closed_solid_lets_any_light_in) {
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> solids{
      {"box",
       [](Scene& s) {
         add_box(s, {-1, -1, -1}, {1, 1, 1});
       }},
      {"ball",
       [](Scene& s) {
         add_sphere(s, {0, 0, 0}, 1.0, 64);
       }},
      {"octahedron", [](Scene& s) {
         add_sphere(s, {0, 0, 0}, 1.2, 2);
       }}};
  for (const auto& [name, add_solid] : solids) {
    for (const Light& light : one_of_each({0.4, 2, 0.3})) {
      Scene scene;
      add_solid(scene);
      scene.lights = {light};
      scene.camera.eye_world = {0.1, 0.05, 0};
      scene.camera.at_world = {0.3, -0.7, -0.4};
      scene.camera.vertical_fov_deg = 110.0;
      finish_scene(scene);
      for (const Scene& placed : {scene, moved_scene(scene, tilted_and_moved({30, -10, 20}))}) {
        const Frame frame = render_reference(placed);
        EXPECT_GE(*std::ranges::min_element(frame.image.plane("primitive_id")), 0.0f) << name;
        EXPECT_EQ(*std::ranges::max_element(frame.image.plane("visibility")), 0.0f)
            << name << ", " << to_text(light.type);
      }
    }
  }
}

}  // namespace
}  // namespace umbrameter
