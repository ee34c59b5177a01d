// SPDX-License-Identifier: Apache-2.0
// Four moments: exact where theory says so, and what rounding may do to them.

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

}  // namespace
}  // namespace umbrameter
