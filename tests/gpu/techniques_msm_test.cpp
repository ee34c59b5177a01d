// SPDX-License-Identifier: Apache-2.0
// Four and six moments: exact where theory says so, and what rounding may do to them.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace umbrameter {
namespace {

using namespace test;

/// Without biases of its own, over a small map.
ParameterValues plain(ParameterValues values) {
  return with(values, {{"map_size", int64_t{512}}, {"bias_texels", 0.1}, {"normal_offset_texels", 0.0}});
}

const std::vector<ParameterValues> kForms = {
    {},
    {{"preset", std::string("peters-klein-2015")}},
    {{"preset", std::string("peters-2017")}},
    {{"preset", std::string("peters-2017-128")}},
};

TEST(msm4, is_the_box_filter_for_one_flat_blocker) {
  UMBRAMETER_REQUIRE_GL();
  // Two layers are two points, which four moments describe whatever the shares are; the bias and 16 bits move shares by less.
  for (const Scene& scene : {plate_scene(), half_plane_scene(light_at_4(LightType::sun, 0.5))}) {
    for (const double width : {1.0, 3.0, 9.0}) {
      const auto box =
          visibility(scene, "pcf", plain({{"filter_width_texels", width}, {"bias_world", 1e-3}}));
      for (const ParameterValues& form : kForms) {
        const auto v = visibility(scene, "msm4", plain(with(form, {{"filter_width_texels", width}})));
        EXPECT_LT(largest_difference(v, box), 0.01) << scene.name << " " << width;
      }
    }
  }
}

/// Floor, a plate over all of it, and above that a plate over x < 0, under an overhead sun: the floor is in full shadow.
Scene shadowed_twice() {
  Scene scene;
  add_floor(scene, {12, 12});
  add_floor(scene, {20, 40}, 1.0);
  add_floor(scene, {20, 40}, 2.0, {-10, 0});
  scene.lights = {light_at_4(LightType::sun, 0.5)};
  scene.camera.eye_world = {0.8, 0.4, 0.1};
  scene.camera.vertical_fov_deg = 40.0;
  finish_scene(scene);
  return scene;
}

float brightest(const std::vector<float>& v) {
  return *std::ranges::max_element(v);
}

TEST(msm4, does_not_leak_under_two_flat_blockers_where_vsm_does) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues wide = plain({{"filter_width_texels", 25.0}});
  EXPECT_GT(brightest(visibility(shadowed_twice(), "vsm", wide)), 0.09);  // 1/10 where half is covered
  for (const ParameterValues& form : kForms)
    EXPECT_LT(brightest(visibility(shadowed_twice(), "msm4", with(form, wide))), 0.01);
}

TEST(msm4, sixteen_bits_hold_published_combinations_better_than_the_moments) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::disk, 0.5));
  const auto whole = visibility(scene, "msm4", plain({}));
  const auto error = [&](const char* quantisation) {
    const ParameterValues values =
        plain({{"moment_format", std::string("rgba16")}, {"quantisation", std::string(quantisation)}});
    return mean_difference(whole, visibility(scene, "msm4", values));
  };
  const double none = error("none");
  EXPECT_LT(error("peters_klein_2015"), 0.5 * none);
  EXPECT_LT(error("peters_2017"), 0.5 * none);
}

TEST(msm4, bits_are_what_the_format_says) {
  UMBRAMETER_REQUIRE_GL();
  const auto bytes = [](const char* format) {
    return render(plate_scene(), "msm4", plain({{"moment_format", std::string(format)}})).memory_bytes;
  };
  EXPECT_EQ(bytes("rgba32f") - bytes("rgba16"), 2u * 512 * 512 * 8);  // of the map and its half-blurred copy
}

const std::vector<ParameterValues> kSixForms = {{},
                                                {{"preset", std::string("muenstermann-2018-192")}},
                                                {{"preset", std::string("muenstermann-2018-96")}}};

/// What a form's bias and bits move shares by.
double slack_of(const ParameterValues& form) {
  return form.contains("preset") && to_text(form.at("preset")) == "muenstermann-2018-96" ? 0.05 : 0.005;
}

TEST(msm6, is_the_box_filter_for_one_flat_blocker) {
  UMBRAMETER_REQUIRE_GL();
  for (const Scene& scene : {plate_scene(), half_plane_scene(light_at_4(LightType::sun, 0.5))}) {
    for (const double width : {1.0, 3.0, 9.0}) {
      const auto box =
          visibility(scene, "pcf", plain({{"filter_width_texels", width}, {"bias_world", 1e-3}}));
      for (const ParameterValues& form : kSixForms) {
        const auto v = visibility(scene, "msm6", plain(with(form, {{"filter_width_texels", width}})));
        EXPECT_LT(largest_difference(v, box), 2.0 * slack_of(form)) << scene.name << " " << width;
      }
    }
  }
}

/// Two plates, a high one over x < 0 and a low one over z < 0, over a floor: filters of the floor hold three layers.
Scene quartered() {
  Scene scene;
  add_floor(scene, {12, 12});
  add_floor(scene, {20, 40}, 2.0, {-10, 0});
  add_floor(scene, {40, 20}, 1.0, {0, -10});
  scene.lights = {light_at_4(LightType::sun, 0.5)};
  scene.camera.eye_world = {0.4, 0.7, 0.5};
  scene.camera.vertical_fov_deg = 70.0;
  finish_scene(scene);
  return scene;
}

TEST(msm6, reproduces_two_blockers_and_a_receiver_in_one_filter) {
  UMBRAMETER_REQUIRE_GL();
  // Three points, one of them the receiver's: exact, as with four moments, though one of four points has no share then.
  const ParameterValues wide = plain({{"filter_width_texels", 33.0}});
  const auto box = visibility(quartered(), "pcf", with(wide, {{"bias_world", 1e-3}}));
  EXPECT_GT(*std::ranges::max_element(box), 0.9f);
  EXPECT_LT(*std::ranges::min_element(box), 0.1f);
  const auto six =
      visibility(quartered(), "msm6", with(wide, {{"preset", std::string("muenstermann-2018-192")}}));
  RecordProperty("six", fmt::format("{:.4f}", largest_difference(six, box)));
  EXPECT_LT(largest_difference(six, box), 0.01);
}

/// The floor of shadowed_twice() under a third plate, over z < 0.
Scene shadowed_thrice() {
  Scene scene = shadowed_twice();
  add_floor(scene, {40, 20}, 3.0, {0, -10});
  finish_scene(scene);
  return scene;
}

TEST(msm6, does_not_leak_under_three_flat_blockers_where_four_moments_do) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues wide = plain({{"filter_width_texels", 25.0}, {"steepest_lit", 0.0}});
  const double four = brightest(visibility(shadowed_thrice(), "msm4", wide));
  RecordProperty("four", fmt::format("{:.4f}", four));
  EXPECT_GT(four, 0.02);
  EXPECT_LT(brightest(visibility(shadowed_thrice(), "msm6", wide)), 0.01);
}

TEST(msm6, bits_are_what_the_format_says) {
  UMBRAMETER_REQUIRE_GL();
  const auto bytes = [](const char* format) {
    return render(plate_scene(), "msm6", plain({{"moment_format", std::string(format)}})).memory_bytes;
  };
  EXPECT_EQ(bytes("rg32f") - bytes("rg16"), 6u * 512 * 512 * 4);  // three maps and their half-blurred copies
}

}  // namespace
}  // namespace umbrameter
