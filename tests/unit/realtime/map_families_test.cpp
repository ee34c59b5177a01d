// SPDX-License-Identifier: Apache-2.0
// Without these a cube's face could be turned otherwise than GL samples it, and a cascade could leave out a part of its
// slice, or crawl while the camera turns.
#include "realtime/views/camera_slice.h"
#include "realtime/views/light_view.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace umbrameter {
namespace {

constexpr glm::ivec2 kScreen(160, 90);

void add_quad(Scene& scene, const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
  const auto first = static_cast<uint32_t>(scene.positions_world.size());
  for (const glm::vec3& p : {corner, corner + u, corner + u + v, corner + v}) {
    scene.positions_world.edit().push_back(p);
    scene.bounds_world.min = glm::min(scene.bounds_world.min, glm::dvec3(p));
    scene.bounds_world.max = glm::max(scene.bounds_world.max, glm::dvec3(p));
  }
  scene.triangles.edit().emplace_back(first, first + 1, first + 2);
  scene.triangles.edit().emplace_back(first, first + 2, first + 3);
}

/// A lamp at (1, 2, 3), a floor at y = 0 and a plate 0.5 beside the lamp.
Scene lamp_scene() {
  Scene scene;
  add_quad(scene, {-5, 0, -5}, {10, 0, 0}, {0, 0, 10});
  add_quad(scene, {1.5f, 1.9f, 2.9f}, {0, 0.2f, 0}, {0, 0, 0.2f});
  Light lamp;
  lamp.type = LightType::sphere;
  lamp.center_world = {1, 2, 3};
  lamp.radius_world = 0.1;
  scene.lights = {lamp};
  return scene;
}

TEST(CubeFaces, ShareTheRangeFromTheNearestCasterToTheFarthestCorner) {
  const DistanceRange range = cube_range(lamp_scene());
  EXPECT_NEAR(range.near_world, 0.5, 1e-3);  // the plate, along +x
  EXPECT_NEAR(range.far_world, 8.0, 0.01);   // z from 3 to -5
}

/// Where GL's rule (OpenGL 4.5 core, table 8.19) finds a direction on a face: s and t in [0, 1].
glm::dvec2 sampled_at(const glm::dvec3& r, int face) {
  const std::array<glm::dvec2, 6> st = {
      glm::dvec2(-r.z, -r.y), {r.z, -r.y}, {r.x, r.z}, {r.x, -r.z}, {r.x, -r.y}, {-r.x, -r.y}};
  const double major = std::max({std::abs(r.x), std::abs(r.y), std::abs(r.z)});
  return 0.5 * (st.at(static_cast<size_t>(face)) / major + 1.0);
}

TEST(CubeFaces, DrawWhereTheHardwareSamples) {
  const Scene scene = lamp_scene();
  const DistanceRange range = cube_range(scene);
  const std::array<glm::dvec3, 6> directions = {
      {{2, 0.3, -0.5}, {-2, 0.7, 1}, {0.4, 3, -1}, {1, -2, 0.5}, {0.1, -0.6, 1}, {-0.7, 0.2, -1}}};
  for (int face = 0; face < 6; ++face) {
    const LightView view = fit_face_view(scene, face, range);
    const glm::dvec3& direction = directions.at(static_cast<size_t>(face));
    const glm::dvec3 p = scene.light().center_world + direction;
    EXPECT_TRUE(covers(view, p)) << face;
    const glm::dvec4 clip =
        glm::dmat4(view.clip_from_light) * (glm::dmat4(view.light_from_world) * glm::dvec4(p, 1.0));
    const glm::dvec2 drawn = 0.5 * (glm::dvec2(clip) / clip.w + 1.0);
    EXPECT_NEAR(glm::distance(drawn, sampled_at(direction, face)), 0.0, 1e-6) << face;
    for (int other = 0; other < 6; ++other) {
      EXPECT_EQ(covers(fit_face_view(scene, other, range), p), other == face) << face << " " << other;
    }
  }
}

/// A long floor under a sun, and a camera that looks along -z.
Scene long_floor() {
  Scene scene;
  add_quad(scene, {-50, 0, -500}, {100, 0, 0}, {0, 0, 510});
  add_quad(scene, {-1, 3, -22}, {2, 0, 0}, {0, 0, 2});
  Light sun;
  sun.type = LightType::sun;
  sun.direction_world = glm::normalize(glm::dvec3(-0.6, -0.8, 0));
  sun.tangent_world = {0, 0, 1};
  sun.bitangent_world = glm::cross(sun.direction_world, sun.tangent_world);
  sun.half_angle_rad = 0.005;
  scene.lights = {sun};
  scene.camera.eye_world = {0, 2, 0};
  scene.camera.at_world = {0, 1.5, -10};
  scene.camera.vertical_fov_deg = 50;
  scene.camera.near_world = 0.1;
  return scene;
}

TEST(CameraSlice, CornersLieOnTheFrustumAtTheirDistances) {
  const Scene scene = long_floor();
  const glm::dvec4 axis = camera_axis(scene.camera);
  const auto corners = corners_world(scene.camera, kScreen, {2.0, 8.0});
  const double up = std::tan(glm::radians(25.0));
  for (size_t i = 0; i < corners.size(); ++i) {
    const double distance = i < 4 ? 2.0 : 8.0;
    EXPECT_NEAR(glm::dot(axis, glm::dvec4(corners[i], 1.0)), distance, 1e-9);
    const double off_axis =
        std::sqrt(std::pow(glm::distance(corners[i], scene.camera.eye_world), 2) - distance * distance);
    EXPECT_NEAR(off_axis, distance * up * std::hypot(1.0, 16.0 / 9.0), 1e-9);
  }
}

TEST(CameraSlice, SphereTouchesTheFarthestCornersAndHoldsAll) {
  const Camera camera = long_floor().camera;
  for (const CameraSlice& slice : {CameraSlice{0.1, 4.0}, CameraSlice{40.0, 50.0}}) {
    const Sphere sphere = sphere_around(camera, kScreen, slice);
    double farthest = 0.0;
    for (const glm::dvec3& corner : corners_world(camera, kScreen, slice))
      farthest = std::max(farthest, glm::distance(corner, sphere.center_world));
    EXPECT_NEAR(farthest, sphere.radius_world, 1e-9);
  }
}

TEST(SliceView, CoversItsSliceOfTheSceneAndNothingBeyondItsDistances) {
  const Scene scene = long_floor();
  const CameraSlice slice{5.0, 30.0};
  for (const LightFit fit : {LightFit::frustum, LightFit::full, LightFit::visible, LightFit::sphere}) {
    const LightView view = fit_slice_view(scene, kScreen, {}, fit, slice);
    for (const double z : {-5.2, -12.0, -29.0}) EXPECT_TRUE(covers(view, {0, 0, z})) << z;
    EXPECT_FALSE(covers(view, {0, 0, -4.0}));
    EXPECT_FALSE(covers(view, {0, 0, -40.0}));
  }
}

TEST(SliceView, VisibleIsAsTightAsItsReceivers) {
  const Scene scene = long_floor();
  const ReceiverTile tile{{-1, 0, -12}, {1, 0, -10}};
  const auto width = [&](const LightView& view) { return view.lateral_bounds.z - view.lateral_bounds.x; };
  const LightView visible = fit_slice_view(scene, kScreen, {&tile, 1}, LightFit::visible, {5.0, 30.0});
  const LightView full = fit_slice_view(scene, kScreen, {&tile, 1}, LightFit::full, {5.0, 30.0});
  EXPECT_NEAR(width(visible), 2.0, 0.2);
  EXPECT_GT(width(full), 10.0f);
}

TEST(SliceView, StabilisedSpheresKeepTheirTexelsWhileTheCameraTurnsAndMoves) {
  constexpr int kTexels = 512;
  Scene scene = long_floor();
  const CameraSlice slice{1.0, 20.0};
  const auto stable = [&] {
    return snapped(fit_slice_view(scene, kScreen, {}, LightFit::sphere, slice), kTexels);
  };
  const glm::dvec4 first(stable().lateral_bounds);
  const double texel = (first.z - first.x) / kTexels;
  for (int step = 1; step < 20; ++step) {
    scene.camera.eye_world.z = -0.037 * step;
    scene.camera.at_world = {std::sin(0.3 * step), 1.5, -10};
    const glm::dvec4 bounds(stable().lateral_bounds);
    EXPECT_NEAR((bounds.z - bounds.x) / kTexels, texel, 1e-6);
    for (int k = 0; k < 2; ++k) {
      const double moved = (bounds[k] - first[k]) / texel;
      EXPECT_NEAR(moved, std::round(moved), 2e-3) << step;
    }
  }
}

}  // namespace
}  // namespace umbrameter
