// SPDX-License-Identifier: Apache-2.0
// The second surface along the light's rays: what it makes bias unnecessary for, and what it loses.

#include "realtime/inspect.h"
#include "realtime/realtime.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbrameter {
namespace {

using namespace test;

/// No bias, and no help from the receiver's plane.
ParameterValues bare(ParameterValues more = {}) {
  return with({{"map_size", int64_t{256}},
               {"bias_texels", 0.0},
               {"normal_offset_texels", 0.0},
               {"receiver_plane", std::string("none")}},
              more);
}

/// A box on a floor under a slanting sun.
Scene box_under_sun() {
  Scene scene;
  add_floor(scene, {6, 6});
  add_box(scene, {-0.5, 0.5, -0.5}, {0.5, 1.0, 0.5});
  scene.lights = {sun_light({0.5, 1, 0.3}, 0.005)};
  scene.camera.eye_world = {0.5, 3, 3};
  scene.camera.at_world = {0, 0.5, 0};
  scene.camera.vertical_fov_deg = 40.0;
  finish_scene(scene);
  return scene;
}

/// Share of the pixels on the box's top that are dark.
double acne_on_top(const std::string& technique, const ParameterValues& values) {
  const Frame frame = render(box_under_sun(), technique, values);
  const auto v = frame.image.plane("visibility"), y = frame.image.plane("position.y");
  const auto id = frame.image.plane("primitive_id");
  double dark = 0.0, all = 0.0;
  for (size_t i = 0; i < v.size(); ++i) {
    if (id[i] < 0.0f || y[i] < 0.999f) continue;
    all += 1.0;
    dark += 1.0 - v[i];
  }
  EXPECT_GT(all, 300.0);
  return dark / all;
}

TEST(second_depth, needs_no_bias_on_solid_casters) {
  UMBRAMETER_REQUIRE_GL();
  EXPECT_GT(acne_on_top("hard", bare()), 0.1);
  EXPECT_EQ(acne_on_top("second_depth", bare()), 0.0);
  EXPECT_EQ(acne_on_top("second_depth", bare({{"limits_depth", false}})), 0.0);
}

TEST(second_depth, keeps_the_shadow_of_a_caster_without_a_back_only_within_its_limit) {
  UMBRAMETER_REQUIRE_GL();
  const auto dark = [](bool limits) {
    const auto v = visibility(plate_scene(), "second_depth", bare({{"limits_depth", limits}}));
    return std::ranges::count(v, 0.0f);
  };
  const auto hard = std::ranges::count(visibility(plate_scene(), "hard", {{"map_size", int64_t{256}}}), 0.0f);
  EXPECT_GT(hard, 300);
  EXPECT_NEAR(static_cast<double>(dark(true)), static_cast<double>(hard), 0.05 * static_cast<double>(hard));
  EXPECT_LT(dark(false), hard);  // the floor under the plate is the second surface, and compared with itself
}

TEST(second_depth, holds_the_nearer_of_second_surface_and_limit) {
  UMBRAMETER_REQUIRE_GL();
  const auto realtime = source_dir() / "realtime";
  const auto renderer = make_realtime_renderer({realtime / "techniques", realtime / "shaders", {}});
  const auto held = [&](const char* resource, bool limits) {
    const RenderRequest request{.width_px = 160,
                                .height_px = 90,
                                .technique = "second_depth",
                                .parameters = bare({{"limits_depth", limits}, {"deepest_texels", 8.0}})};
    SilentProgress progress;
    const Image image = dump_resource(*renderer, box_under_sun(), request, {resource, 0, 0}, progress);
    const auto plane = image.plane("Y");
    return std::vector<float>(plane.begin(), plane.end());
  };
  const auto first = held("first_layer", true), second = held("shadow_map", false);
  const auto limited = held("shadow_map", true);
  int limited_here = 0, own = 0;
  for (size_t i = 0; i < first.size(); ++i) {
    ASSERT_LE(second[i], first[i]) << i;
    if (first[i] == 0.0f) {
      ASSERT_EQ(limited[i], 0.0f) << i;
      continue;
    }
    ASSERT_GE(limited[i], second[i]) << i;
    ASSERT_LE(limited[i], first[i]) << i;
    (limited[i] == second[i] ? own : limited_here) += 1;
  }
  EXPECT_GT(limited_here, 1000);
  EXPECT_GT(own, 10);
}

}  // namespace
}  // namespace umbrameter
