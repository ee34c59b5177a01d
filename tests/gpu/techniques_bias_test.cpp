// SPDX-License-Identifier: Apache-2.0
// Each bias scheme alone must keep a slope from shadowing itself and must not lose the shadow of a box; without any
// there must be acne, or these tests prove nothing.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using namespace test;

ParameterValues no_bias() {
  return {{"map_size", int64_t{256}},
          {"receiver_plane", std::string("none")},
          {"bias_texels", 0.0},
          {"normal_offset_texels", 0.0}};
}

struct Scheme {
  std::string name;
  ParameterValues values;
};

std::vector<Scheme> schemes() {
  const auto text = [](const char* choice) { return ParameterValue(std::string(choice)); };
  return {
      {"constant", {{"bias_texels", 4.0}}},
      {"slope-scaled", {{"slope_bias", 1.5}, {"bias_texels", 0.1}}},
      {"normal offset by sine", {{"normal_offset_texels", 1.5}}},
      {"constant normal offset", {{"normal_offset_texels", 1.5}, {"normal_offset_form", text("constant")}}},
      {"normal offset by 1 - cosine",
       {{"normal_offset_texels", 3.0}, {"normal_offset_form", text("one_minus_cosine")}}},
      {"plane at the tap", {{"receiver_plane", text("tap")}, {"bias_texels", 0.1}}},
      {"plane at the texel's centre", {{"receiver_plane", text("texel_center")}, {"bias_texels", 0.1}}},
      {"cone", {{"cone_bias", 1.0}, {"bias_texels", 0.5}}},
      {"auto", {{"bias_mode", text("auto")}}},
      {"back faces", {{"caster_layer", text("back_faces")}}},
      {"midpoint", {{"caster_layer", text("midpoint")}}},
  };
}

/// A floor under a sun at 30 degrees of elevation, with a closed box on it where `is_boxed`.
Scene sloped_scene(bool is_boxed) {
  Scene scene;
  add_floor(scene, {8, 8});
  if (is_boxed) add_box(scene, {-0.5, 0, -0.5}, {0.5, 1, 0.5});
  scene.lights = {sun_light({std::sqrt(3.0), 1.0, 0.0}, 0.02)};
  scene.camera = camera_above({-1, 0, 0}, 5, 10);
  finish_scene(scene);
  return scene;
}

double darkest(const std::vector<float>& plane) {
  return static_cast<double>(*std::ranges::min_element(plane));
}

TEST(bias, none_at_all_gives_acne) {
  UMBRAMETER_REQUIRE_GL();
  EXPECT_LT(darkest(visibility(sloped_scene(false), "hard", no_bias())), 0.5);
}

TEST(bias, every_scheme_alone_lights_a_slope) {
  UMBRAMETER_REQUIRE_GL();
  for (const Scheme& scheme : schemes()) {
    EXPECT_EQ(darkest(visibility(sloped_scene(false), "hard", with(no_bias(), scheme.values))), 1.0)
        << scheme.name;
  }
}

TEST(bias, every_scheme_keeps_the_shadow_of_a_box) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = sloped_scene(true);
  for (const Scheme& scheme : schemes()) {
    const Frame frame = render(scene, "hard", with(no_bias(), scheme.values));
    // The box of height 1 at x > -0.5 throws sqrt(3) of shadow towards -x.
    const ErrorSummary error = floor_error(frame, [](const glm::dvec3& p) {
      return p.x < -0.5 && p.x > -0.5 - std::sqrt(3.0) && std::abs(p.z) < 0.5 ? 0.0 : 1.0;
    });
    EXPECT_LT(error.rmse, 0.15) << scheme.name << ": only texels at the edges may differ";
  }
}

TEST(bias, wide_filters_need_the_slope_times_their_radius) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues wide = with(no_bias(), {{"filter_width_texels", 9.0}});
  const Scene scene = sloped_scene(false);
  EXPECT_LT(darkest(visibility(scene, "pcf", with(wide, {{"slope_bias", 1.0}}))), 0.9);
  EXPECT_EQ(darkest(visibility(scene, "pcf", with(wide, {{"slope_bias", 6.0}}))), 1.0);
  EXPECT_EQ(darkest(visibility(scene, "pcf", with(wide, {{"bias_mode", std::string("auto")}}))), 1.0);
  EXPECT_EQ(darkest(visibility(scene, "pcf",
                               with(wide, {{"receiver_plane", std::string("tap")}, {"bias_texels", 0.1}}))),
            1.0);
}

TEST(bias, fits_change_the_score_little_at_equal_texels) {
  UMBRAMETER_REQUIRE_GL();
  for (const char* fit : {"none", "frustum", "scene", "full", "visible"}) {
    const Frame frame = render(plate_scene(), "pcss",
                               {{"map_fit", std::string(fit)},
                                {"map_size", int64_t{4096}},
                                {"search_taps", int64_t{64}},
                                {"filter_taps", int64_t{64}}});
    EXPECT_LT(floor_error(frame, plate_visibility).rmse, 0.02) << fit;
  }
}

}  // namespace
}  // namespace umbrameter
