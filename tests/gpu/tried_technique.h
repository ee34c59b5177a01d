// SPDX-License-Identifier: Apache-2.0
#pragma once
// A technique that a test writes for itself, drawn in a small square picture of one scene.

#include "realtime/realtime.h"
#include "scenes/scene.h"
#include "tests/support/technique_folder.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace umbrameter {

class TriedTechnique : public testing::Test {
 protected:
  TriedTechnique(Scene scene, int side_px) : scene_(std::move(scene)), side_px_(side_px) {}

  /// Skips the test without GL.
  void SetUp() override {
    try {
      renderer_ =
          make_realtime_renderer({folder_.techniques_folder(), TechniqueFolder::shaders_folder(), ""});
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::environment) throw;
      GTEST_SKIP() << error.what();
    }
  }

  void shader(const std::string& name, const std::string& text) { folder_.write(name, text); }

  RenderRequest request(const ParameterValues& parameters = {}) const {
    RenderRequest request;
    request.width_px = side_px_;
    request.height_px = side_px_;
    request.technique = "tried";
    request.parameters = parameters;
    return request;
  }

  virtual Frame render(const ParameterValues& parameters = {}) {
    SilentProgress progress;
    return renderer_->render(scene_, request(parameters), progress);
  }

  PreparedRun prepare(const ParameterValues& parameters = {}) {
    SilentProgress progress;
    return renderer_->prepare(scene_, request(parameters), progress);
  }

  std::vector<float> visibility(const ParameterValues& parameters = {}) {
    const Frame frame = render(parameters);
    const auto plane = frame.image.plane("visibility");
    return {plane.begin(), plane.end()};
  }

  /// Of bad input; "no error" without one.
  std::string error_of(const ParameterValues& parameters = {}) {
    try {
      render(parameters);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << error.what();
      return error.what();
    }
    return "no error";
  }

  TechniqueFolder folder_;
  Scene scene_;
  std::unique_ptr<Renderer> renderer_;

 private:
  int side_px_;
};

}  // namespace umbrameter
