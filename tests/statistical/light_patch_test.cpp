// SPDX-License-Identifier: Apache-2.0
// The fast many-ray sampler must be the light of scenes/light.h, sample by sample.

#include "reference/shadow_rays.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <cmath>

namespace umbrameter {
namespace {

Receiver receiver_at(const glm::dvec3& p, const glm::dvec3& n_geometric, const glm::dvec3& n_shading) {
  return {p, glm::normalize(n_geometric), glm::normalize(n_shading), glm::vec3(p)};
}

/// The uv that a stream's sample stands for: patch coordinates are 2 uv - 1, read from the shifted bits as
/// signed.
glm::dvec2 uv_of(const SampleStream& stream, uint32_t i) {
  const auto signed_fraction = [](uint32_t bits) { return static_cast<int32_t>(bits) * 0x1p-31; };
  return {0.5 * (signed_fraction(stream.x[i] ^ stream.shift_x) + 1.0),
          0.5 * (signed_fraction(stream.y[i] ^ stream.shift_y) + 1.0)};
}

void expect_same_samples(const Light& light, const Receiver& receiver) {
  const SampleSets sets(64);
  const SampleStream stream = sets.stream(7, 3);
  const LightPatch patch = make_light_patch(light, receiver, 1.0);
  ASSERT_FALSE(patch.dark);
  for (uint32_t first = 0; first < 64; first += kBatch) {
    ShadowRayBatch batch(receiver.ray_origin_world);
    make_shadow_rays(patch, stream, first, 64, batch);
    for (uint32_t i = 0; i < kBatch; ++i) {
      const LightSample expected =
          sample_light(light, receiver.p_world, receiver.n_shading_world, uv_of(stream, first + i));
      const glm::dvec3 d{batch.rays.dir_x[i], batch.rays.dir_y[i], batch.rays.dir_z[i]};
      const double length = glm::length(d);
      // Float coordinates of a light a few units away: a few 1e-7.
      ASSERT_LT(glm::distance(d / length, expected.to_light_world), 2e-6);
      if (std::isfinite(expected.distance_world)) {
        ASSERT_NEAR(batch.rays.tfar[i] * length / expected.distance_world, 1.0, 1e-4);
      } else {
        ASSERT_EQ(batch.rays.tfar[i], std::numeric_limits<float>::infinity());
      }
      ASSERT_NEAR(batch.weight[i], expected.irradiance_weight, 2e-6);
      const double height = glm::dot(expected.to_light_world, receiver.n_geometric_world);
      if (std::abs(height) > 1e-6) {
        ASSERT_EQ(batch.is_facing[i] != 0, height > 0.0);
      }
    }
  }
}

TEST(LightPatch, makes_the_samples_of_every_light) {
  // The second receiver's horizon cuts through the lights, the third one's shading normal leans away.
  const Receiver receivers[] = {receiver_at({0.3, 0, 0.1}, {0, 1, 0}, {0, 1, 0}),
                                receiver_at({-3, 1.9, 0.2}, {-0.05, 1, 0}, {-0.05, 1, 0}),
                                receiver_at({1, 0, -1}, {0.1, 1, 0}, {-0.9, 0.5, 0.3})};
  for (const Receiver& receiver : receivers) {
    expect_same_samples(rect_light_above({0.2, 2, 0}, {1.0, 0.5}), receiver);
    expect_same_samples(disk_light_above({0.2, 2, 0}, 0.7), receiver);
    expect_same_samples(sphere_light({0.2, 2, 0}, 0.5), receiver);
    expect_same_samples(sun_light({0.3, 1, -0.2}, 0.3), receiver);
  }
}

TEST(LightPatch, is_dark_behind_a_one_sided_light_and_inside_a_sphere) {
  const Receiver above = receiver_at({0, 3, 0}, {0, -1, 0}, {0, -1, 0});
  EXPECT_TRUE(make_light_patch(rect_light_above({0, 2, 0}, {1, 1}), above, 1.0).dark);
  EXPECT_TRUE(make_light_patch(disk_light_above({0, 2, 0}, 0.5), above, 1.0).dark);
  EXPECT_TRUE(make_light_patch(sphere_light({0, 3.1, 0}, 0.5), above, 1.0).dark);
  EXPECT_FALSE(make_light_patch(sphere_light({0, 2, 0}, 0.5), above, 1.0).dark);
}

TEST(LightPatch, knows_when_the_whole_light_is_below_the_horizon) {
  const Light light = disk_light_above({0, 2, 0}, 0.5);
  // The horizon of a wall at x = 1 that faces +x passes 0.5 beyond the light's rim; at x = 0.4 it cuts the
  // light.
  EXPECT_TRUE(is_below_horizon(make_light_patch(light, receiver_at({1, 0, 0}, {1, 0, 0}, {1, 0, 0}), 1.0)));
  EXPECT_FALSE(
      is_below_horizon(make_light_patch(light, receiver_at({0.4, 0, 0}, {1, 0, 0}, {1, 0, 0}), 1.0)));
}

TEST(SampleSets, first_powers_of_two_are_stratified_in_every_stream) {
  const SampleSets sets(64);
  for (uint32_t replicate = 0; replicate < 32; ++replicate) {
    const SampleStream stream = sets.stream(99, replicate);
    // A (0,6,2)-net: each of the 8 x 8 cells, and each of the 64 slabs, holds one of the 64 points.
    std::array<int, 64> cells{}, columns{}, rows{};
    for (uint32_t i = 0; i < 64; ++i) {
      const uint32_t x = stream.x[i] ^ stream.shift_x;
      const uint32_t y = stream.y[i] ^ stream.shift_y;
      ++cells[(x >> 29) * 8 + (y >> 29)];
      ++columns[x >> 26];
      ++rows[y >> 26];
    }
    for (int i = 0; i < 64; ++i) ASSERT_TRUE(cells[i] == 1 && columns[i] == 1 && rows[i] == 1);
  }
}

}  // namespace
}  // namespace umbrameter
