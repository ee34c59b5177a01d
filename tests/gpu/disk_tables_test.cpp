// SPDX-License-Identifier: Apache-2.0
// The tables of scripts/disk_tables.py keep what they are used for; a table edited by hand would not show elsewhere.

#include "tests/gpu/gl_test.h"
#include "tests/gpu/twin_runner.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

using DiskTables = test::GlTest;
using test::run_glsl;

constexpr size_t kCount = 64;

std::vector<glm::vec2> table(const std::string& name) {
  std::vector<glm::vec4> inputs;
  for (size_t i = 0; i < kCount; ++i) inputs.emplace_back(i, 0, 0, 0);
  std::vector<glm::vec2> points;
  for (const glm::vec4& output :
       run_glsl("disk_tables.glsl", "vec4(" + name + "[int(x.x)], 0.0, 0.0)", inputs))
    points.emplace_back(output);
  return points;
}

float least_distance(const std::vector<glm::vec2>& points, size_t count) {
  float least = 2.0f;
  for (size_t i = 0; i < count; ++i) {
    for (size_t j = 0; j < i; ++j) least = std::min(least, glm::distance(points[i], points[j]));
  }
  return least;
}

/// 1/2 over a disk.
float mean_squared_radius(const std::vector<glm::vec2>& points, size_t count) {
  float sum = 0.0f;
  for (size_t i = 0; i < count; ++i) sum += glm::dot(points[i], points[i]);
  return sum / static_cast<float>(count);
}

TEST_F(DiskTables, points_lie_in_the_unit_disk_and_spread_as_far_as_it) {
  for (const std::string name : {"kPoissonDisk", "kBlueNoiseDisk"}) {
    const auto points = table(name);
    for (const glm::vec2& point : points) ASSERT_LE(glm::length(point), 1.0f) << name;
    EXPECT_NEAR(mean_squared_radius(points, kCount), 0.5f, 0.05f) << name;
  }
}

TEST_F(DiskTables, poisson_points_keep_their_distance) {
  EXPECT_GE(least_distance(table("kPoissonDisk"), kCount), 0.18f - 1e-5f);  // six digits in the table
}

TEST_F(DiskTables, every_prefix_of_blue_noise_is_spread_evenly) {
  // n points packed hexagonally over the area pi are sqrt(2 pi / sqrt(3)) / sqrt(n) = 1.9 / sqrt(n) apart;
  // choosing each farthest from those before it keeps half of the best distance.
  const auto points = table("kBlueNoiseDisk");
  for (size_t count = 2; count <= kCount; ++count) {
    EXPECT_GE(least_distance(points, count) * std::sqrt(static_cast<float>(count)), 0.95f) << count;
  }
  for (size_t count = 8; count <= kCount; ++count)
    EXPECT_NEAR(mean_squared_radius(points, count), 0.5f, 0.06f) << count;
}

TEST_F(DiskTables, a_prefix_of_blue_noise_is_wider_apart_than_one_of_poisson) {
  EXPECT_GT(least_distance(table("kBlueNoiseDisk"), 16), 1.5f * least_distance(table("kPoissonDisk"), 16));
}

/// pcg3d as published (Jarzynski and Olano 2020, listing 17), 24 bits of its first two values.
std::array<double, 2> white_noise(uint32_t x, uint32_t y, uint32_t z) {
  const auto step = [](uint32_t value) { return value * 1664525u + 1013904223u; };
  const auto mix = [&] {
    x += y * z;
    y += z * x;
    z += x * y;
  };
  x = step(x), y = step(y), z = step(z);
  mix();
  x ^= x >> 16, y ^= y >> 16, z ^= z >> 16;
  mix();
  return {std::ldexp(x >> 8, -24), std::ldexp(y >> 8, -24)};
}

TEST_F(DiskTables, white_noise_is_the_published_hash) {
  std::vector<glm::vec4> inputs;
  for (int i = 0; i < 200; ++i) inputs.emplace_back(17 * i, 1079 - i, i % 7, 0);
  const auto outputs = run_glsl("white_noise.glsl", "vec4(white_noise(uvec3(x.xyz)), 0.0, 0.0)", inputs);
  for (size_t i = 0; i < inputs.size(); ++i) {
    const auto expected = white_noise(static_cast<uint32_t>(inputs[i].x), static_cast<uint32_t>(inputs[i].y),
                                      static_cast<uint32_t>(inputs[i].z));
    ASSERT_EQ(outputs[i].x, expected[0]) << i;
    ASSERT_EQ(outputs[i].y, expected[1]) << i;
  }
}

}  // namespace
}  // namespace umbrameter
