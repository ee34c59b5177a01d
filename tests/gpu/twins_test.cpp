// SPDX-License-Identifier: Apache-2.0
// A shader and its C++ twin that disagree would make every measured difference meaningless.

#include "core/sampling/patterns.h"
#include "core/spaces.h"
#include "tests/gpu/gl_test.h"
#include "tests/gpu/twin_runner.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace umbrameter {
namespace {

using test::run_glsl;
using Twins = test::GlTest;
using Inputs = std::vector<glm::vec4>;

/// Index x of count y for a few counts, with z as a third argument.
Inputs point_sets() {
  Inputs inputs;
  for (const int count : {1, 2, 7, 16, 256}) {
    for (int i = 0; i < count; ++i) inputs.emplace_back(i, count, 0.1 * i - 3.0, 0.0);
  }
  return inputs;
}

/// x, y over [low, high]^2, both ends included.
Inputs grid(float low, float high, int steps) {
  Inputs inputs;
  for (int y = 0; y <= steps; ++y) {
    for (int x = 0; x <= steps; ++x) {
      const float scale = (high - low) / static_cast<float>(steps);
      inputs.emplace_back(low + scale * static_cast<float>(x), low + scale * static_cast<float>(y), 0.0f,
                          0.0f);
    }
  }
  return inputs;
}

void expect_twins(const std::string& include, const std::string& expression, const Inputs& inputs,
                  const std::function<glm::vec2(const glm::vec4&)>& twin, double tolerance) {
  const std::vector<glm::vec4> outputs = run_glsl(include, expression, inputs);
  for (size_t i = 0; i < inputs.size(); ++i) {
    const glm::vec2 expected = twin(inputs[i]);
    const std::string where = fmt::format("input ({}, {}, {})", inputs[i].x, inputs[i].y, inputs[i].z);
    ASSERT_NEAR(outputs[i].x, expected.x, tolerance) << where;
    ASSERT_NEAR(outputs[i].y, expected.y, tolerance) << where;
  }
}

uint32_t index_of(const glm::vec4& x) {
  return static_cast<uint32_t>(x.x);
}
uint32_t count_of(const glm::vec4& x) {
  return static_cast<uint32_t>(x.y);
}

TEST_F(Twins, vogel_disk) {
  // Angles reach 256 * 2.4 = 614 rad, where a float is 6e-5 apart.
  expect_twins(
      "sampling.glsl", "vec4(vogel_disk(int(x.x), int(x.y), x.z), 0.0, 0.0)", point_sets(),
      [](const auto& x) { return vogel_disk(index_of(x), count_of(x), x.z); }, 2e-4);
}

TEST_F(Twins, hammersley) {
  expect_twins(
      "sampling.glsl", "vec4(hammersley(int(x.x), int(x.y)), 0.0, 0.0)", point_sets(),
      [](const auto& x) { return hammersley(index_of(x), count_of(x)); }, 1e-7);
}

TEST_F(Twins, concentric_disk) {
  // sin and cos are good to 2^-11 absolute in GLSL's specification; drivers give about 1e-6.
  expect_twins(
      "sampling.glsl", "vec4(concentric_disk(x.xy), 0.0, 0.0)", grid(0.0f, 1.0f, 64),
      [](const auto& x) {
        return concentric_disk({x.x, x.y});
      },
      1e-5);
}

TEST_F(Twins, interleaved_gradient_noise) {
  // fract(52.98 fract(t)): one rounding of t (t < 20 on a 256 px screen: 1e-6) grows by 52.98. Values next to
  // a wrap may land on its other side, so differences count around the circle.
  const Inputs inputs = grid(0.5f, 256.5f, 128);
  const auto outputs = run_glsl("sampling.glsl", "vec4(interleaved_gradient_noise(x.xy))", inputs);
  for (size_t i = 0; i < outputs.size(); ++i) {
    const double expected = interleaved_gradient_noise({inputs[i].x, inputs[i].y});
    const double difference = std::abs(outputs[i].x - expected);
    ASSERT_LT(std::min(difference, 1.0 - difference), 2e-4) << inputs[i].x << " " << inputs[i].y;
  }
}

TEST_F(Twins, distance_of_stored_depth) {
  constexpr double kNear = 0.25, kFar = 40.0;
  const std::string perspective = fmt::format(
      "vec4(perspective_distance(x.x, {0}, {1}), "
      "orthographic_distance(x.x, {0}, {1}.0), 0.0, 0.0)",
      kNear, kFar);
  expect_twins(
      "spaces.glsl", perspective, grid(0.0f, 1.0f, 64),
      [](const auto& x) {
        return glm::vec2(perspective_distance(x.x, kNear, kFar), orthographic_distance(x.x, kNear, kFar));
      },
      40.0 * 4e-7);  // a few roundings at the far end
}

TEST_F(Twins, pixel_position_has_row_0_on_top) {
  // GL's fragment (0.5, 0.5) is the bottom left pixel: column 0, row 99 of 100.
  expect_twins(
      "spaces.glsl", "vec4(pixel_position(x.xy, 100.0), 0.0, 0.0)", {{0.5f, 0.5f, 0, 0}, {7.5f, 99.5f, 0, 0}},
      [](const auto& x) { return glm::vec2(x.x, 100.0f - x.y); }, 0.0);
}

TEST_F(Twins, pixel_position_is_the_pixel_of_clip_space) {
  // The fragment centre at window (x, y) of a 64 x 100 screen has NDC (2 x / 64 - 1, 2 y / 100 - 1).
  expect_twins(
      "spaces.glsl", "vec4(pixel_position(x.xy, 100.0), 0.0, 0.0)", grid(0.5f, 63.5f, 63),
      [](const auto& x) {
        const glm::dvec4 clip(2.0 * x.x / 64 - 1.0, 2.0 * x.y / 100 - 1.0, 0.5, 1.0);
        return glm::vec2(pixel_of_clip(clip, 64, 100));
      },
      2e-5);
}

const std::string kTwinView =
    "LightViewData(mat4(1.0), mat4(1.0), vec4(-1.0, -0.5, 3.0, 1.5), vec4(0.5, 9.0, 0.0, 512.0), vec4(0.0))";

TEST_F(Twins, texel_position_spans_the_lateral_bounds) {
  // Bounds 4 wide and 2 high over 512 texels.
  expect_twins(
      "spaces.glsl", "vec4(texel_position(" + kTwinView + ", x.xy), 0.0, 0.0)", grid(-1.0f, 3.0f, 32),
      [](const auto& x) { return glm::vec2((x.x + 1.0) / 4.0 * 512.0, (x.y + 0.5) / 2.0 * 512.0); }, 1e-3);
}

TEST_F(Twins, lateral_of_texel_undoes_texel_position) {
  expect_twins(
      "spaces.glsl",
      "vec4(lateral_of_texel(" + kTwinView + ", texel_position(" + kTwinView + ", x.xy)), 0.0, 0.0)",
      grid(-1.0f, 3.0f, 32), [](const auto& x) { return glm::vec2(x.x, x.y); }, 1e-6);
}

/// Length of [low, high] in [index, index + 1].
double overlap(double index, double low, double high) {
  return std::max(0.0, std::min(high, index + 1.0) - std::max(low, index));
}

TEST_F(Twins, box_weight_is_the_overlap_of_box_and_texel) {
  // x = texel, y = centre of a box 2.6 wide.
  expect_twins(
      "box_filter.glsl", "vec4(box_weight(int(floor(x.x)), x.y - 1.3, x.y + 1.3))", grid(-4.0f, 4.0f, 80),
      [](const auto& x) { return glm::vec2(overlap(std::floor(x.x), x.y - 1.3, x.y + 1.3)); }, 1e-6);
}

TEST_F(Twins, box_weights_from_first_to_last_texel_add_up_to_the_width) {
  // The loop of the pcf technique in one dimension, for widths y in [0, 33] and centres x.
  Inputs inputs;
  for (int i = 1; i <= 132; ++i) inputs.emplace_back(0.37 * i - 20.0, 0.25 * i, 0.0, 0.0);
  const std::string sum =
      "vec4(floor(x.x - 0.5 * x.y), last_texel(x.x - 0.5 * x.y, x.x + 0.5 * x.y), 0.0, 0.0)";
  const auto ends = run_glsl("box_filter.glsl", sum, inputs);
  for (size_t i = 0; i < ends.size(); ++i) {
    double total = 0.0;
    for (int texel = static_cast<int>(ends[i].x); texel <= static_cast<int>(ends[i].y); ++texel) {
      total += overlap(texel, inputs[i].x - 0.5 * inputs[i].y, inputs[i].x + 0.5 * inputs[i].y);
    }
    ASSERT_NEAR(total, inputs[i].y, 1e-4);
  }
}

TEST_F(Twins, a_box_of_no_width_is_one_whole_texel) {
  expect_twins(
      "box_filter.glsl", "vec4(box_weight(5, 5.25, 5.25), float(last_texel(5.25, 5.25)), 0.0, 0.0)",
      {glm::vec4(0.0f)}, [](const auto&) { return glm::vec2(1.0f, 5.0f); }, 0.0);
}

}  // namespace
}  // namespace umbrameter
