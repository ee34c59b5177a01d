// SPDX-License-Identifier: Apache-2.0
// The percentage-closer filters that reach a known filter by another route: gathers, tents, jittered disks.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"
#include "tests/support/source_dir.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace umbrameter {
namespace {

using namespace test;
namespace fs = std::filesystem;

const std::vector<LightType> kLightTypes = {LightType::rect, LightType::disk, LightType::sphere,
                                            LightType::sun};

/// A texel position is up to 512 with rounding of 3e-5; a filter blends by such positions.
constexpr double kRoundingOfWeights = 1e-3;

ParameterValues small_map(ParameterValues values) {
  values["map_size"] = int64_t{512};
  return values;
}

TEST(pcf_gather, is_the_box_of_its_width) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : kLightTypes) {
    const Scene scene = busy_scene(light_at_4(type, 0.5));
    for (const int64_t width : {1, 2, 3, 6, 11}) {
      const auto gathered = visibility(scene, "pcf_gather", small_map({{"filter_width_texels", width}}));
      const auto box = visibility(scene, "pcf", small_map({{"filter_width_texels", double(width)}}));
      EXPECT_LT(largest_difference(gathered, box), kRoundingOfWeights) << width << " " << to_text(type);
    }
  }
}

/// pcf_tent with every texel read on its own and weighed by its centre's distance from the receiver, along each axis.
class BruteForceTent : public testing::Test {
 protected:
  void SetUp() override {
    UMBRAMETER_REQUIRE_GL();
    fs::copy(source_dir() / "realtime/techniques/pcf_tent", path());
    std::ofstream(path() / "pcf_tent.frag") << R"(
#include "pixel.glsl"
#include "shadow_map.glsl"
const int kReach = SIZE + 2;  // texels farther off weigh nothing
float at(int distance) {
  int witness[3 * 5] = int[](2, 1, 0, 0, 0, 4, 3, 1, 0, 0, 16, 12, 5, 1, 0);
  if (distance >= kReach) return 0.0;
  return WEIGHTS == WEIGHTS_TENT ? float(kReach - distance) : float(witness[5 * SIZE + distance]);
}
float weight(float distance) { return mix(at(int(distance)), at(int(distance) + 1), fract(distance)); }
void main() {
  Receiver receiver;
  float known = 1.0;
  bool is_surface = fetch_receiver(receiver);
  if (!is_surface || is_known(view_light, receiver, known)) {
    out_visibility = is_surface ? known : 1.0;
    return;
  }
  vec2 center = texel_position(view_light, receiver.lateral);
  vec2 lit_and_total = vec2(0.0);
  for (int y = -kReach - 1; y <= kReach + 1; ++y) {
    for (int x = -kReach - 1; x <= kReach + 1; ++x) {
      ivec2 texel = ivec2(floor(center)) + ivec2(x, y);
      vec2 offset = abs(vec2(texel) + 0.5 - center);
      float lit = is_blocked(shadow_map, view_light, receiver, texel) ? 0.0 : 1.0;
      lit_and_total += weight(offset.x) * weight(offset.y) * vec2(lit, 1.0);
    }
  }
  out_visibility = lit_and_total.x / lit_and_total.y;
}
)";
  }
  fs::path path() const { return folder_.path() / "tent"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(BruteForceTent, is_what_the_gathers_give) {
  for (const LightType type : kLightTypes) {
    const Scene scene = busy_scene(light_at_4(type, 0.5));
    for (const std::string size : {"3x3", "5x5", "7x7"}) {
      for (const std::string weights : {"tent", "witness"}) {
        const ParameterValues values = small_map({{"size", size}, {"weights", weights}});
        const auto gathered = visibility(scene, "pcf_tent", values);
        const auto brute_force = visibility(scene, path().string(), values);
        EXPECT_LT(largest_difference(gathered, brute_force), kRoundingOfWeights)
            << size << " " << weights << " " << to_text(type);
      }
    }
  }
}

TEST(pcf_tent, spreads_an_edge_as_far_as_a_tent_of_its_base) {
  UMBRAMETER_REQUIRE_GL();
  // A filter moves the edge's step by its mean |x|: h / 3 for a tent of half base h, W / 4 for a box. The tent is
  // stepwise, a texel at a time, as is the map: hence 7 x 7, h = 4, box 16 / 3.
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 0.5));
  const auto hard = visibility(scene, "hard", small_map({}));
  const auto tent = visibility(scene, "pcf_tent", small_map({{"size", std::string("7x7")}}));
  const auto box = visibility(scene, "pcf", small_map({{"filter_width_texels", 16.0 / 3.0}}));
  EXPECT_NEAR(mean_difference(tent, hard) / mean_difference(box, hard), 1.0, 0.03);
}

TEST(pcf_tent, of_3x3_is_the_same_with_either_weights) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues tent = small_map({{"size", std::string("3x3")}});
  ParameterValues witness = tent;
  witness["weights"] = std::string("witness");
  EXPECT_EQ(visibility(plate_scene(), "pcf_tent", tent), visibility(plate_scene(), "pcf_tent", witness));
}

ParameterValues adaptive(const std::string& early_out, double radius_texels) {
  return small_map({{"early_out", early_out}, {"radius_texels", radius_texels}, {"probe_inner", int64_t{0}}});
}

TEST(pcf_adaptive, min_max_loses_nothing) {
  UMBRAMETER_REQUIRE_GL();
  for (const LightType type : kLightTypes) {
    const Light light = light_at_4(type, 0.5);
    for (const Scene& scene : {half_plane_scene(light), busy_scene(light)}) {
      for (const double radius : {0.0, 5.0, 17.3, 64.0}) {
        for (const std::string receiver_plane : {"none", "tap", "texel_center"}) {
          ParameterValues all = adaptive("none", radius);
          ParameterValues culled = adaptive("min_max", radius);
          all["receiver_plane"] = culled["receiver_plane"] = receiver_plane;
          EXPECT_EQ(visibility(scene, "pcf_adaptive", culled), visibility(scene, "pcf_adaptive", all))
              << to_text(type) << " " << radius << " " << receiver_plane;
        }
      }
    }
  }
}

/// A floor in the sun and, one above it, a plate that its map sees about a dozen texels wide.
Scene small_plate_scene() {
  Scene scene;
  add_floor(scene, {12, 12});
  add_floor(scene, {0.1, 0.1}, 1.0);
  scene.lights = {sun_light({0, 1, 0}, 0.01)};
  scene.camera.eye_world = {2.5, 2.0, 2.0};
  scene.camera.at_world = {0, 0.2, 0};
  finish_scene(scene);
  return scene;
}

TEST(pcf_adaptive, ring_loses_a_blocker_inside_the_ring_and_probes_find_it) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = small_plate_scene();
  const auto all = visibility(scene, "pcf_adaptive", adaptive("none", 24.0));
  const auto ring = visibility(scene, "pcf_adaptive", adaptive("ring", 24.0));
  ParameterValues with_probes = adaptive("ring", 24.0);
  with_probes["probe_inner"] = int64_t{16};
  const auto probed = visibility(scene, "pcf_adaptive", with_probes);
  EXPECT_GT(largest_difference(ring, all), 0.03);
  EXPECT_LT(mean_difference(probed, all), 0.7 * mean_difference(ring, all));
  EXPECT_EQ(visibility(scene, "pcf_adaptive", adaptive("min_max", 24.0)), all);
}

TEST(pcf_adaptive, ring_is_wrong_only_where_all_of_the_ring_agrees) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = busy_scene(light_at_4(LightType::rect, 0.5));
  const auto all = visibility(scene, "pcf_adaptive", adaptive("none", 9.0));
  const auto ring = visibility(scene, "pcf_adaptive", adaptive("ring", 9.0));
  for (size_t i = 0; i < all.size(); ++i)
    ASSERT_TRUE(ring[i] == all[i] || ring[i] == std::round(ring[i])) << i;
}

TEST(pcf_adaptive, of_no_radius_is_the_hard_shadow) {
  UMBRAMETER_REQUIRE_GL();
  for (const std::string early_out : {"none", "ring", "min_max"}) {
    const Scene scene = busy_scene(light_at_4(LightType::rect, 0.5));
    EXPECT_EQ(visibility(scene, "pcf_adaptive", adaptive(early_out, 0.0)),
              visibility(scene, "hard", small_map({})))
        << early_out;
  }
}

TEST(pcf_adaptive, spreads_an_edge_as_far_as_a_disk_of_its_radius) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 0.5));
  const auto hard = visibility(scene, "hard", small_map({}));
  const auto jittered = visibility(scene, "pcf_adaptive", adaptive("min_max", 6.0));
  const auto disk = visibility(
      scene, "pcf_disk", small_map({{"radius_texels", 6.0}, {"taps", int64_t{256}}, {"bilinear", false}}));
  EXPECT_NEAR(mean_difference(jittered, hard) / mean_difference(disk, hard), 1.0, 0.03);
}

TEST(pcf_adaptive, noise_follows_the_seed_and_a_tile_of_one_has_none) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const ParameterValues still = small_map({{"tile_px", int64_t{1}}});
  EXPECT_NE(visibility(scene, "pcf_adaptive", small_map({}), 1),
            visibility(scene, "pcf_adaptive", small_map({}), 2));
  EXPECT_EQ(visibility(scene, "pcf_adaptive", still, 1), visibility(scene, "pcf_adaptive", still, 2));
}

ParameterValues disk_values(const std::string& pattern, const std::string& rotation) {
  return small_map({{"pattern", pattern},
                    {"rotation", rotation},
                    {"taps", int64_t{64}},
                    {"radius_texels", 6.0},
                    {"bilinear", false}});
}

TEST(pcf_disk, patterns_spread_an_edge_alike) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 0.5));
  const auto hard = visibility(scene, "hard", small_map({}));
  const double vogel =
      mean_difference(visibility(scene, "pcf_disk", disk_values("vogel", "gradient_noise")), hard);
  for (const std::string pattern : {"poisson", "blue_noise"}) {
    const auto other = visibility(scene, "pcf_disk", disk_values(pattern, "white_noise"));
    EXPECT_NEAR(mean_difference(other, hard) / vogel, 1.0, 0.05) << pattern;
  }
}

TEST(pcf_disk, turns_by_the_seed_or_not_at_all) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  const auto at = [&](const std::string& rotation, uint64_t seed) {
    return visibility(scene, "pcf_disk", disk_values("blue_noise", rotation), seed);
  };
  EXPECT_EQ(at("none", 1), at("none", 2));
  EXPECT_NE(at("white_noise", 1), at("white_noise", 2));
  EXPECT_NE(at("white_noise", 1), at("gradient_noise", 1));
}

TEST(pcf_disk, rejects_more_taps_than_a_table_holds) {
  UMBRAMETER_REQUIRE_GL();
  ParameterValues values = disk_values("poisson", "none");
  values["taps"] = int64_t{65};
  EXPECT_ANY_THROW(visibility(plate_scene(), "pcf_disk", values));
}

}  // namespace
}  // namespace umbrameter
