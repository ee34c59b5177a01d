// SPDX-License-Identifier: Apache-2.0
// Without this, scene export, camera, light or quantity could differ from what a path tracer makes of the documentation.

#include "tests/cli/cli_fixture.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

class CyclesPair : public CliTest, public testing::WithParamInterface<const char*> {
 protected:
  ProcessResult run(const std::vector<std::string>& command) const {
    ProcessOptions options;
    options.working_folder = folder();
    return run_process(command, options);
  }
};

TEST_P(CyclesPair, HasTheTruthsIrradianceRatio) {
  if (run({"blender", "--version"}).exit_code != 0)
    GTEST_SKIP() << "NOT CHECKED against Cycles: Blender is not installed (Debian package blender)";
  const std::string scene = GetParam();
  const ProcessResult exported =
      umbrameter({"scene", "export", scene, "--width", "240", "--height", "136", "-o", "exported"});
  ASSERT_EQ(exported.exit_code, 0) << exported.err;
  const ProcessResult truth = umbrameter(
      {"reference", scene, "--width", "240", "--height", "136", "--spp", "512", "-o", "truth.exr"});
  ASSERT_EQ(truth.exit_code, 0) << truth.err;
  const ProcessResult rendered = run({"blender", "-b", "--factory-startup", "--python-exit-code", "9", "-P",
                                      (source_dir() / "tests/blender/cycles_pair.py").string(), "--",
                                      "exported", ".", "240", "136", "256"});
  ASSERT_EQ(rendered.exit_code, 0) << rendered.out << rendered.err;
  const ProcessResult scored =
      umbrameter({"score", "--shadowed", "lit.exr", "--unshadowed", "unlit.exr", "--reference", "truth.exr",
                  "--quantity", "irradiance", "--metrics", "error", "--json"});
  ASSERT_EQ(scored.exit_code, 0) << scored.err;
  const Json error = Json::parse(scored.out)["error"];
  EXPECT_LE(std::abs(error["rmse"]["value"].get<double>()), 0.004) << scored.err;
  EXPECT_LE(std::abs(error["bias"].get<double>()), 0.001);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CyclesPair, testing::Values("contact_hardening", "plate"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace umbrameter
