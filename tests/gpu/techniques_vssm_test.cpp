// SPDX-License-Identifier: Apache-2.0
// Tables of sums: their boxes against closed forms, and against the map that they add up.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace umbrameter {
namespace {

using namespace test;

/// Without biases of its own, over a small map.
ParameterValues plain(ParameterValues values) {
  return with(values, {{"map_size", int64_t{512}}, {"bias_texels", 0.1}, {"normal_offset_texels", 0.0}});
}

double floor_rmse(const Scene& scene, const std::string& technique, const ParameterValues& values,
                  const std::function<double(const glm::dvec3&)>& truth) {
  return floor_error(render(scene, technique, values), truth).rmse;
}

TEST(vssm, is_within_001_of_the_half_plane_and_the_plate) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues values{{"map_size", int64_t{1024}}};
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun}) {
    // The square of a round light's area errs by up to 0.02 of a straight edge's profile.
    const Light light = light_at_4(type, 1.0);
    const double most = type == LightType::rect ? 0.01 : 0.02;
    const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p); };
    EXPECT_LE(floor_rmse(half_plane_scene(light), "vssm", values, truth), most) << to_text(type);
  }
  EXPECT_LE(floor_rmse(plate_scene(), "vssm", values, plate_visibility), 0.01);
}

TEST(vssm, sums_are_those_of_the_map) {
  UMBRAMETER_REQUIRE_GL();
  // Under a light without size cells are a texel, as vsm without a blur is; their variance is known to 2^-17.
  const Scene scene = half_plane_scene(light_at_4(LightType::rect, 1e-6));
  const ParameterValues values = plain({{"min_deviation_world", 0.01}});
  const auto sums =
      visibility(scene, "vssm", with(values, {{"cells", int64_t{1}}, {"most_width_texels", int64_t{8}}}));
  const auto map = visibility(scene, "vsm", with(values, {{"filter_width_texels", 1.0}}));
  EXPECT_LT(largest_difference(sums, map), 0.01);
}

}  // namespace
}  // namespace umbrameter
