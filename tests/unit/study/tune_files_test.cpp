// SPDX-License-Identifier: Apache-2.0
// Without these, a tuner could write down other numbers than it measured.

#include "results/tune/tune_files.h"
#include "core/files.h"
#include "report/report.h"
#include "results/tune/tune_json.h"
#include "study/tune/lengths.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/study/tune_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

TEST_F(Tune, FilesHoldWhatWasMeasured) {
  const TuneResult result = run();
  const std::string bias = to_text(result.best.values.at("bias_texels"));
  EXPECT_THAT(preset_toml(result), HasSubstr("technique = \"fake\""));
  EXPECT_THAT(preset_toml(result), HasSubstr("bias_texels = " + bias + "\n"));
  EXPECT_THAT(engine_block(result), HasSubstr("bias_texels = " + bias + "  // "));
  EXPECT_THAT(engine_block(result), HasSubstr("world units at 0.25 a texel"));
  const Json json = Json::parse(to_json_text(result));
  EXPECT_EQ(json["best"]["parameters"]["bias_texels"],
            std::get<double>(result.best.values.at("bias_texels")));
  const Json& sweep = json["bias_sweep"][0];
  EXPECT_EQ(sweep["bias"].size(), sweep["objective"].size());
  EXPECT_EQ(sweep["bias"].size(), sweep["acne_share"].size());
}

TEST_F(Tune, TheEngineBlockNamesWhatEnginesLack) {
  Parameter plane;
  plane.name = "receiver_plane";
  plane.type = ParameterType::choice;
  plane.choices = {"none", "texel_center"};
  plane.default_value = std::string("none");
  plan.parameters.push_back(plane);
  TuneResult result;
  result.head.parameters = plan.parameters;
  result.tuned = {"bias_texels", "receiver_plane"};
  result.texel_world = 0.25;
  result.best.values = {{"bias_texels", 2.0}, {"receiver_plane", std::string("texel_center")}};
  const std::string lacking = "// No engine's light settings have these";
  EXPECT_THAT(engine_block(result),
              testing::AllOf(
                  HasSubstr("bias_texels = 2  // 0.5 world units at 0.25 a texel\n//   Unity URP Depth Bias"),
                  testing::ContainsRegex(lacking + ".*\nreceiver_plane = texel_center")));
  result.best.values["receiver_plane"] = std::string("none");
  EXPECT_THAT(engine_block(result), testing::Not(HasSubstr(lacking)));
}

// Neither in texels nor in world units.
TEST_F(Tune, ThePageTellsABiasInAnEnginesOwnUnit) {
  TuneResult result = run();
  ASSERT_FALSE(result.windows.empty());
  SafeWindow& window = result.windows.front();
  window.unit = "depth of the map";
  window.from = 0.125;
  window.to = 0.25;
  window.is_complete = true;
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "tune.json", to_json_text(result));
  write_report(folder.path(), folder.path() / "report.html");
  EXPECT_THAT(read_file(folder.path() / "report.html"),
              HasSubstr(R"("window":{"empty":false,"low":0.125,"high":0.25})"));
}

TEST_F(Tune, LengthsAreThoseOfTheSmallestScene) {
  Parameter length;
  length.name = "bias_world";
  length.default_value = std::string("0.01 diagonals");
  length.max = 0.5;
  length.unit = "world";
  length.group = "bias";
  length.is_relative_to_scene = true;
  plan.parameters.push_back(length);
  plan.technique.parameters = default_values(plan.parameters);
  plan.presets.push_back({"long", {{"bias_world", std::string("0.25 diagonals")}}});
  scenes.push_back(fake_scene("fence"));
  scenes[0].scene.bounds_world = {{0, 0, 0}, {0, 300, 400}};
  scenes[1].scene.bounds_world = {{0, 0, 0}, {0, 0, 20}};
  resolve_lengths(plan, scenes);
  EXPECT_EQ(plan.parameters.back().max, 10.0);
  EXPECT_EQ(plan.technique.parameters.at("bias_world"), ParameterValue(0.2));
  EXPECT_EQ(plan.presets.back().values.at("bias_world"), ParameterValue(5.0));
  EXPECT_THAT(plan.notes, testing::ElementsAre(HasSubstr("the smallest scene, 20 across")));
  plan.parameters.back() = length;
  plan.technique.parameters["bias_world"] = 11.0;
  EXPECT_THROW(resolve_lengths(plan, scenes), Error);
}

}  // namespace
}  // namespace umbrameter
