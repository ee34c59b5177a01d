// SPDX-License-Identifier: Apache-2.0
#pragma once
// A tuner on fakes: one bias that is best at kBestBias, and taps that cost.

#include "study/tune/tune.h"

#include "core/error.h"
#include "tests/support/lab/fakes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbrameter {

inline constexpr double kBestBias = 0.7;

inline Parameter bias_parameter() {
  Parameter parameter;
  parameter.name = "bias_texels";
  parameter.default_value = 4.0;
  parameter.max = 32.0;
  parameter.unit = "texels";
  parameter.group = "bias";
  return parameter;
}

inline Parameter taps_parameter() {
  Parameter parameter;
  parameter.name = "taps";
  parameter.type = ParameterType::integer;
  parameter.default_value = int64_t{16};
  parameter.min = 1;
  parameter.max = 64;
  parameter.unit = "taps";
  return parameter;
}

inline double bias_of(const ParameterValues& values) {
  return std::get<double>(values.at("bias_texels"));
}

/// Error of a bias: 0.02 at best, more to both sides, and half of it with 64 taps. Fails from 20 texels on.
inline Frame render_with_bias(const RenderRequest& request) {
  if (request.technique.empty()) return frame_of(floor_image());
  const double bias = bias_of(request.parameters);
  if (bias > 20.0) fail_input("the map is empty");
  const double taps = static_cast<double>(std::get<int64_t>(request.parameters.at("taps")));
  const double error =
      (0.02 + 0.05 * std::abs(std::cbrt(bias) - std::cbrt(kBestBias))) * (taps > 32.0 ? 0.5 : 1.0);
  Frame frame = frame_of(technique_image(static_cast<float>(error)));
  frame.image.add_plane("texel_world", 0.25f);
  frame.parameters = request.parameters;
  return frame;
}

class Tune : public testing::Test {
 protected:
  Tune() {
    plan.technique = fake_technique("fake");
    plan.parameters = {bias_parameter(), taps_parameter()};
    plan.technique.parameters = default_values(plan.parameters);
    plan.presets = {{"engine", {{"bias_texels", 1.5}, {"taps", int64_t{64}}}},
                    {"medium", {{"bias_texels", 4.0}}}};
    plan.evaluations = 40;
    plan.seed = 7;
    plan.full = {kFakeWidth_px, kFakeHeight_px, &reference};
    scenes[0].scene.camera.up_world = {0, 0, 1};
  }

  TuneResult run() { return run_tune(scenes, plan, realtime, progress); }

  TunePlan plan;
  std::vector<SceneJob> scenes = {fake_scene("plate")};
  FakeRenderer reference = fake_reference();
  FakeRenderer realtime{render_with_bias};
  SilentProgress progress;
};

}  // namespace umbrameter
