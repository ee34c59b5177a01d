// SPDX-License-Identifier: Apache-2.0
// Without this a study could spend its time on a parameter that changes nothing, or be told so of one that does.

#include "tests/cli/cli_fixture.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using Json = nlohmann::json;

class Screen : public CliTest {
 protected:
  void SetUp() override { require_gl(); }
};

TEST_F(Screen, NamesParametersThatChangeNoPixel) {
  write("study.toml", R"(schema = 1
title = "Nothing to cast a shadow, and a plate"
scenes = ["empty_plane", "plate"]
width_px = 32
height_px = 18
samples_per_pixel = 8
[[run]]
technique = "pcf"
[run.values]
map_size = [64, 1024]
filter_width_texels = [1.0, 9.0]
)");
  const ProcessResult result = umbrameter({"plan", "study.toml", "--screen", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json idle = Json::parse(result.out)["idle_parameters"];
  ASSERT_EQ(idle.size(), 2u) << idle;  // neither matters where everything is lit, both matter under the plate
  for (const Json& one : idle) {
    EXPECT_EQ(one["scene"], "empty_plane");
    EXPECT_EQ(one["runs"], 2);
    EXPECT_GT(one["saved_s"], 0.0);
  }
}

}  // namespace
}  // namespace umbrameter
