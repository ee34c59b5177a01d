// SPDX-License-Identifier: Apache-2.0
// Prefiltered maps: exact where theory says so, wrong by as much as theory says elsewhere.

#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using namespace test;

/// Without biases, so that nothing but the filter is compared, over a small map.
ParameterValues exact(ParameterValues values) {
  values["map_size"] = int64_t{512};
  values["bias_texels"] = 0.0;
  values["normal_offset_texels"] = 0.0;
  return values;
}

/// A deviation of 1 mm keeps rounding on lit planes from counting as a blocker; behind blockers 0.5 and more
/// away it lets (0.001 / 0.5)^2 = 4e-6 through. Weights of a filter are rounded like positions of up to 512
/// texels.
constexpr double kMinDeviation = 1e-3;
constexpr double kRounding = 2e-3;

ParameterValues exact_moments(ParameterValues values) {
  values["min_deviation_world"] = kMinDeviation;
  return exact(std::move(values));
}

std::vector<float> pcf_box(const Scene& scene, double width_texels) {
  return visibility(scene, "pcf", exact({{"filter_width_texels", width_texels}, {"bias_world", 1e-3}}));
}

TEST(vsm, is_the_box_filter_for_one_flat_blocker) {
  UMBRAMETER_REQUIRE_GL();
  // Odd widths: the prefilter at texel centres plus the bilinear read is then the box itself.
  for (const Scene& scene : {plate_scene(), half_plane_scene(light_at_4(LightType::sun, 0.5))}) {
    for (const double width : {1.0, 3.0, 9.0}) {
      const auto bound = visibility(scene, "vsm", exact_moments({{"filter_width_texels", width}}));
      EXPECT_LT(largest_difference(bound, pcf_box(scene, width)), kRounding) << scene.name << " " << width;
    }
  }
}

TEST(vsm, has_no_blur_passes_up_to_the_width_of_its_bilinear_read) {
  UMBRAMETER_REQUIRE_GL();
  const Frame narrow = render(plate_scene(), "vsm", exact_moments({{"filter_width_texels", 0.0}}));
  const Frame wide = render(plate_scene(), "vsm", exact_moments({{"filter_width_texels", 1.5}}));
  EXPECT_EQ(wide.memory_bytes - narrow.memory_bytes, 512u * 512u * 8u);
  const auto v = narrow.image.plane("visibility");
  EXPECT_LT(largest_difference({v.begin(), v.end()}, pcf_box(plate_scene(), 1.0)), kRounding);
}

TEST(vsm_inline, of_odd_grids_is_vsm_of_that_width) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = plate_scene();
  for (const int64_t grid : {1, 3, 5}) {
    const auto read = visibility(scene, "vsm_inline", exact_moments({{"grid_taps", grid}}));
    const auto blurred =
        visibility(scene, "vsm", exact_moments({{"filter_width_texels", static_cast<double>(grid)}}));
    EXPECT_LT(largest_difference(read, blurred), kRounding) << grid;
  }
}

/// Floor, a plate B over all of it at `height_b`, and above a plate A over x < 0 at `height_a`, under an
/// overhead sun: the floor is in full shadow.
Scene two_layer_scene(double height_b, double height_a) {
  Scene scene;
  scene.name = "two-layers";
  add_floor(scene, {12, 12});
  add_floor(scene, {20, 40}, height_b);
  add_floor(scene, {20, 40}, height_a, {-10, 0});
  scene.lights = {light_at_4(LightType::sun, 0.5)};
  scene.camera.eye_world = {0.8, 0.4, 0.1};
  scene.camera.at_world = {0, 0, 0};
  scene.camera.vertical_fov_deg = 40.0;
  finish_scene(scene);
  return scene;
}

/// Largest leak over the share p of the kernel that sees B: p(1-p) x^2 / (p(1-p) x^2 + (y + (1-p) x)^2), x =
/// A to B, y = B to floor.
double largest_leak(double a_to_b, double b_to_floor) {
  double largest = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double p = i / 1000.0;
    const double variance = p * (1 - p) * a_to_b * a_to_b;
    const double beyond = b_to_floor + (1 - p) * a_to_b;
    largest = std::max(largest, variance / (variance + beyond * beyond));
  }
  return largest;
}

double largest_visibility(const Scene& scene, const std::string& technique, const ParameterValues& values) {
  const auto v = visibility(scene, technique, values);
  return *std::ranges::max_element(v);
}

TEST(vsm, leaks_between_two_layers_what_chebyshev_lets_through) {
  UMBRAMETER_REQUIRE_GL();
  // The box is wide enough for pixels to come within 0.01 of the worst share.
  const ParameterValues wide = exact_moments({{"filter_width_texels", 25.0}});
  for (const double a_to_b : {0.5, 1.0, 2.0}) {
    const Scene scene = two_layer_scene(1.0, 1.0 + a_to_b);
    EXPECT_NEAR(largest_visibility(scene, "vsm", wide), largest_leak(a_to_b, 1.0), 0.01) << a_to_b;
    EXPECT_LT(largest_visibility(scene, "pcf", exact({{"filter_width_texels", 25.0}})), 1e-6);
  }
}

TEST(vsm, bleed_reduction_removes_leaks_below_it) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = two_layer_scene(1.0, 2.0);
  const double leak = largest_leak(1.0, 1.0);
  const ParameterValues more =
      exact_moments({{"filter_width_texels", 25.0}, {"bleed_reduction", leak + 0.02}});
  const ParameterValues less =
      exact_moments({{"filter_width_texels", 25.0}, {"bleed_reduction", 0.5 * leak}});
  EXPECT_EQ(largest_visibility(scene, "vsm", more), 0.0);
  EXPECT_NEAR(largest_visibility(scene, "vsm", less), (leak - 0.5 * leak) / (1 - 0.5 * leak), 0.01);
}

ParameterValues esm_with(const std::string& form, double exponent, double width_texels = 5.0) {
  return exact({{"form", form},
                {"exponent", exponent},
                {"filter_width_texels", width_texels},
                {"bias_world", kMinDeviation}});
}

double darkest(const std::vector<float>& v) {
  return *std::ranges::min_element(v);
}

TEST(esm, lets_through_the_exponential_of_the_distance_behind_one_flat_blocker) {
  UMBRAMETER_REQUIRE_GL();
  // One blocker distance d everywhere: V = p + (1 - p) exp(-c d), p the pcf box; and exp(-2 c d) is the square of
  // exp(-c d). The bias b multiplies by exp(c b): under 1.01 for c = 20, since the map's range is over 2 m.
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 0.5));
  const auto box = pcf_box(scene, 5.0);
  const auto v = visibility(scene, "esm", esm_with("exponential", 10.0));
  const double leak = darkest(v);
  EXPECT_GT(leak, 0.0);
  EXPECT_LT(leak, 0.9);
  EXPECT_NEAR(darkest(visibility(scene, "esm", esm_with("exponential", 20.0))), leak * leak,
              0.01 * leak * leak);
  for (size_t i = 0; i < v.size(); ++i) ASSERT_NEAR(v[i], box[i] + (1 - box[i]) * leak, 0.01) << i;
}

TEST(esm, of_a_high_exponent_is_the_box_filter_for_one_flat_blocker) {
  UMBRAMETER_REQUIRE_GL();
  // exp(-1000 d) vanishes, in log space without overflow. A bias b would multiply the lit share by exp(c b); parallel
  // planes need none.
  ParameterValues values = esm_with("log_space", 1000.0);
  values["bias_world"] = 0.0;
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 0.5));
  EXPECT_LT(largest_difference(visibility(scene, "esm", values), pcf_box(scene, 5.0)), kRounding);
}

TEST(esm, log_space_is_the_same_mean) {
  UMBRAMETER_REQUIRE_GL();
  for (const Scene& scene : {plate_scene(), two_layer_scene(1.0, 2.0)}) {
    for (const double width : {1.0, 4.5}) {
      const auto direct = visibility(scene, "esm", esm_with("exponential", 60.0, width));
      EXPECT_LT(largest_difference(direct, visibility(scene, "esm", esm_with("log_space", 60.0, width))),
                kRounding)
          << scene.name << " " << width;
    }
  }
}

TEST(esm, linear_depth_is_darker_never_lighter) {
  UMBRAMETER_REQUIRE_GL();
  // Jensen: exp(c mean z) <= mean exp(c z), and less wherever z differs.
  const Scene scene = plate_scene();
  const auto exponential = visibility(scene, "esm", esm_with("exponential", 60.0));
  const auto linear = visibility(scene, "esm", esm_with("linear_depth", 60.0));
  for (size_t i = 0; i < linear.size(); ++i) ASSERT_LE(linear[i], exponential[i] + 1e-4) << i;
  EXPECT_GT(largest_difference(exponential, linear), 0.3);
}

TEST(evsm, is_the_box_filter_for_one_flat_blocker) {
  UMBRAMETER_REQUIRE_GL();
  for (const double width : {1.0, 5.0}) {
    const auto bound = visibility(plate_scene(), "evsm", exact_moments({{"filter_width_texels", width}}));
    EXPECT_LT(largest_difference(bound, pcf_box(plate_scene(), width)), kRounding) << width;
  }
}

TEST(evsm, without_exponents_is_vsm) {
  UMBRAMETER_REQUIRE_GL();
  // exp(c t) is 1 + c t + (c t)^2 / 2 and the bound does not change under 1 + c t: what is left falls with c, until the
  // floats of squares near 1 run out (6e-8 of variances over (2 c / 8)^2 = 2e-4).
  const Scene scene = two_layer_scene(1.0, 2.0);
  ParameterValues values = exact_moments({{"filter_width_texels", 9.0}});
  const auto plain = visibility(scene, "vsm", values);
  double before = 1.0;
  for (const double exponent : {1.0, 0.25, 0.0625}) {
    values["positive_exponent"] = exponent;
    values["negative_exponent"] = exponent;
    const double apart = largest_difference(visibility(scene, "evsm", values), plain);
    EXPECT_LT(apart, 0.5 * before) << exponent;
    before = apart;
  }
  EXPECT_LT(before, 0.01);
}

TEST(evsm, leaks_between_two_layers_far_less_than_vsm) {
  UMBRAMETER_REQUIRE_GL();
  // The positive warp makes A to B small against B to floor: leak p(1-p) x^2 / (...) with x = w(B) - w(A) and
  // y = w(floor) - w(B), and w grows by exp(2 c / range) = exp(80 / range) a metre; with a range under 8 m, y / x >
  // e^10 - 1.
  const Scene scene = two_layer_scene(1.0, 2.0);
  const ParameterValues wide = exact_moments({{"filter_width_texels", 25.0}});
  EXPECT_GT(largest_visibility(scene, "vsm", wide), 0.1);
  EXPECT_LT(largest_visibility(scene, "evsm", wide), 1e-3);
}

TEST(evsm, stays_finite_at_its_highest_exponents) {
  UMBRAMETER_REQUIRE_GL();
  const ParameterValues highest = {
      {"positive_exponent", 42.0}, {"negative_exponent", 42.0}, {"map_size", int64_t{512}}};
  for (const float v : visibility(plate_scene(), "evsm", highest)) ASSERT_TRUE(v >= 0.0f && v <= 1.0f) << v;
}

}  // namespace
}  // namespace umbrameter
