// SPDX-License-Identifier: Apache-2.0
// Cascades fitted on the GPU: what the reductions find is what the host finds in the G-buffer.

#include "realtime/inspect.h"
#include "realtime/realtime.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

using namespace test;

constexpr int kCascades = 3;
constexpr double kOverlap = 0.1;
constexpr int64_t kSize = 512;

/// A floor of 400 m under a sun, and plates above it near the camera and far from it.
Scene street_of_plates() {
  Scene scene;
  add_floor(scene, {60, 400}, 0.0, {0, -195});
  for (const double z : {-6.0, -60.0, -250.0}) add_floor(scene, {-0.1 * z, -0.1 * z}, 2.0, {0.02 * z, z});
  scene.lights = {sun_light({0.4, 1, 0.1}, 0.005)};
  scene.camera.eye_world = {0, 4, 3};
  scene.camera.at_world = {0, 0, -14};
  scene.camera.vertical_fov_deg = 50.0;
  finish_scene(scene);
  return scene;
}

ParameterValues small(ParameterValues more = {}) {
  return with({{"cascade_count", int64_t{kCascades}}, {"cascade_size", kSize}}, more);
}

/// A point that needs a map: along the camera's axis, and in the sun's axes.
struct LitPoint {
  double distance_world;
  glm::dvec3 p_light;
};

std::vector<LitPoint> lit_points(const Scene& scene, const Image& image) {
  std::array<std::span<const float>, 3> p, n;
  for (size_t k = 0; k < 3; ++k) {
    p[k] = image.plane(std::string("position.") + "xyz"[k]);
    n[k] = image.plane(std::string("normal.") + "xyz"[k]);
  }
  const auto id = image.plane("primitive_id");
  const Light& light = scene.light();
  const glm::dvec3 axis = glm::normalize(scene.camera.at_world - scene.camera.eye_world);
  std::vector<LitPoint> points;
  for (size_t i = 0; i < id.size(); ++i) {
    const glm::dvec3 point(p[0][i], p[1][i], p[2][i]), normal(n[0][i], n[1][i], n[2][i]);
    if (id[i] < 0.0f || glm::dot(normal, light.direction_world) >= 0.0) continue;
    points.push_back({glm::dot(axis, point - scene.camera.eye_world),
                      {glm::dot(point, light.tangent_world), glm::dot(point, light.bitangent_world),
                       glm::dot(point, light.direction_world)}});
  }
  return points;
}

struct Box {
  glm::dvec3 min{1e30}, max{-1e30};
};

/// What a plan's buffer `cascade_data` holds: five vectors a cascade (sdsm.glsl).
class Fitted {
 public:
  explicit Fitted(const Image& dumped) {
    for (size_t k = 0; k < 4; ++k) {
      const auto plane = dumped.plane(std::string(1, "RGBA"[k]));
      planes_[k].assign(plane.begin(), plane.end());
    }
  }
  glm::dvec4 at(int cascade, int vector) const {
    const auto i = static_cast<size_t>(5 * cascade + vector);
    return {planes_[0].at(i), planes_[1].at(i), planes_[2].at(i), planes_[3].at(i)};
  }

 private:
  std::array<std::vector<float>, 4> planes_;
};

Fitted fitted(const Scene& scene, const ParameterValues& parameters) {
  const auto realtime = source_dir() / "realtime";
  const auto renderer = make_realtime_renderer({realtime / "techniques", realtime / "shaders", {}});
  RenderRequest request{
      .width_px = 160, .height_px = 90, .technique = "sdsm_cascades", .parameters = parameters};
  SilentProgress progress;
  return Fitted(dump_resource(*renderer, scene, request, {"cascade_data", 0, 0}, progress));
}

TEST(sdsm_cascades, bounds_are_those_of_the_host) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = street_of_plates();
  const Frame frame = render(scene, "sdsm_cascades", small());
  const auto points = lit_points(scene, frame.image);
  ASSERT_GT(points.size(), 5000u);
  const auto nearest = std::ranges::min_element(points, {}, &LitPoint::distance_world)->distance_world;
  const auto farthest = std::ranges::max_element(points, {}, &LitPoint::distance_world)->distance_world;
  const Fitted views = fitted(scene, small());
  for (int k = 0; k < kCascades; ++k) {
    const double from = nearest * std::pow(farthest / nearest, std::max(0.0, k - kOverlap) / kCascades);
    const double to = nearest * std::pow(farthest / nearest, (k + 1.0) / kCascades);
    const glm::dvec4 slice = views.at(k, 2);
    EXPECT_NEAR(slice.x, from, 1e-4 * from) << k;
    if (k + 1 < kCascades) {
      EXPECT_NEAR(slice.y, to, 1e-4 * to) << k;
    } else {
      EXPECT_GT(slice.y, farthest);
    }
    Box box;
    for (const LitPoint& point : points) {
      if (point.distance_world < slice.x || point.distance_world > slice.y) continue;
      box.min = glm::min(box.min, point.p_light);
      box.max = glm::max(box.max, point.p_light);
    }
    const glm::dvec4 least = views.at(k, 3), greatest = views.at(k, 4), bounds = views.at(k, 0);
    EXPECT_EQ(least.w, 1.0);
    // One pixel at a slice's end may fall on either side by rounding; it is as wide as pixels are there.
    const double pixel = 0.02 * to;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(least[axis], box.min[axis], pixel) << k << " axis " << axis;
      EXPECT_NEAR(greatest[axis], box.max[axis], pixel) << k << " axis " << axis;
    }
    // Two texels on either side, and no more.
    for (int axis = 0; axis < 2; ++axis) {
      const double inner = greatest[axis] - least[axis], whole = bounds[axis + 2] - bounds[axis];
      EXPECT_NEAR(inner / whole, 1.0 - 4.0 / kSize, 1e-3) << k;
      EXPECT_NEAR(bounds[axis] + bounds[axis + 2], least[axis] + greatest[axis], 1e-3 * whole) << k;
    }
  }
}

TEST(sdsm_cascades, of_one_map_over_all_are_exactly_the_box_of_all_receivers) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = street_of_plates();
  const ParameterValues one = small({{"cascade_count", int64_t{1}}});
  const auto points = lit_points(scene, render(scene, "sdsm_cascades", one).image);
  Box box;
  for (const LitPoint& point : points) {
    box.min = glm::min(box.min, point.p_light);
    box.max = glm::max(box.max, point.p_light);
  }
  const Fitted views = fitted(scene, one);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(views.at(0, 3)[axis], box.min[axis], 1e-4 * (box.max - box.min)[axis]) << axis;
    EXPECT_NEAR(views.at(0, 4)[axis], box.max[axis], 1e-4 * (box.max - box.min)[axis]) << axis;
  }
}

TEST(sdsm_cascades, of_one_map_are_the_hard_shadow) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 0.5));
  const auto single = visibility(scene, "hard", {{"map_size", int64_t{1024}}});
  const auto one =
      visibility(scene, "sdsm_cascades", {{"cascade_count", int64_t{1}}, {"cascade_size", int64_t{1024}}});
  EXPECT_LT(mean_difference(single, one), 0.01);
  EXPECT_GT(std::ranges::count(one, 0.0f), 2000);
}

TEST(sdsm_cascades, leave_nothing_lit_outside_their_maps) {
  UMBRAMETER_REQUIRE_GL();
  // A roof over all that the camera sees: whatever lies outside a map would be lit.
  Scene scene;
  add_floor(scene, {60, 400}, 0.0, {0, -195});
  add_floor(scene, {600, 2000}, 20.0, {0, -195});
  scene.lights = {sun_light({0.4, 1, 0.1}, 0.005)};
  scene.camera.eye_world = {0, 4, 3};
  scene.camera.at_world = {0, 0, -14};
  scene.camera.vertical_fov_deg = 50.0;
  finish_scene(scene);
  for (const char* filter : {"hard", "pcf"}) {
    for (const char* blend : {"none", "mix", "dither"}) {
      const Frame frame =
          render(scene, "sdsm_cascades",
                 small({{"map_filter", std::string(filter)}, {"cascade_blend", std::string(blend)}}));
      const auto v = frame.image.plane("visibility"), id = frame.image.plane("primitive_id");
      for (size_t i = 0; i < v.size(); ++i) {
        if (id[i] >= 0.0f) {
          ASSERT_EQ(v[i], 0.0f) << filter << " " << blend << " " << i;
        }
      }
    }
  }
}

TEST(sdsm_cascades, find_no_map_worth_more_than_the_receivers) {
  UMBRAMETER_REQUIRE_GL();
  // Nothing that the sun lights: no receiver, no map, and no fault.
  Scene scene;
  add_floor(scene, {60, 60});
  scene.lights = {sun_light({0.0, -1, 0.1}, 0.005)};
  scene.camera = camera_above({0, 0, 0}, 2, 20);
  finish_scene(scene);
  EXPECT_THAT(visibility(scene, "sdsm_cascades", small()), testing::Each(0.0f));
  EXPECT_EQ(fitted(scene, small()).at(0, 3).w, 0.0);
}

}  // namespace
}  // namespace umbrameter
