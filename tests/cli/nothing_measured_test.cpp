// SPDX-License-Identifier: Apache-2.0
// Without these, a gate could pass because there was nothing to look at.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

using testing::HasSubstr;

class NothingMeasured : public CliTest {
 protected:
  void SetUp() override {
    require_gl();
    if (IsSkipped()) return;
    write("sky.toml", scene("at = [0, 9, 0]", "center = [0, 4, 0]"));
    write("below.toml", scene("at = [0, 0, 0]", "center = [0, -4, 0]"));
  }

  static std::string scene(const std::string& at, const std::string& center) {
    return "title = \"Plate\"\n[camera]\neye = [0, 2, 4]\n" + at + "\n[[light]]\ntype = \"rect\"\n" + center +
           "\ndirection = [0, -1, 0]\nsize = [1, 1]\n[[mesh]]\nshape = \"plane\"\nsize = [4, 4]\n";
  }

  ProcessResult small(std::vector<std::string> arguments) const {
    for (const char* more : {"--width", "64", "--height", "48", "--spp", "16"}) arguments.emplace_back(more);
    return umbrameter(arguments);
  }

  static void expect_nothing(const ProcessResult& result) {
    EXPECT_EQ(result.exit_code, 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr("nothing was measured")) << result.out;
  }
};

TEST_F(NothingMeasured, ValidateSaysSoAndFails) {
  for (const std::string file : {"sky.toml", "below.toml"}) {
    expect_nothing(small({"validate", file, "--technique", "hard", "--limit", "0.5", "-o", "v"}));
    const ProcessResult all = small({"validate", file, "--technique", "hard", "--no-skip", "-o", "w"});
    EXPECT_EQ(all.exit_code, 1) << all.err;
    EXPECT_THAT(all.err, HasSubstr("the truth can score no pixel"));
  }
  // JSON is there all the same.
  const ProcessResult json = small({"validate", "sky.toml", "--technique", "hard", "--json", "-o", "v"});
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_TRUE(nlohmann::json::parse(json.out).contains("scenes"));
}

TEST_F(NothingMeasured, ASceneThatNoTechniqueSupportsFails) {
  write("sphere.toml", R"(title = "Sphere"
[camera]
eye = [0, 2, 4]
at = [0, 0, 0]
[[light]]
type = "sphere"
center = [0, 4, 0]
at = [0, 0, 0]
radius = 0.5
[[mesh]]
shape = "plane"
size = [4, 4]
)");
  const ProcessResult result = small({"validate", "sphere.toml", "--technique", "planar", "-o", "v"});
  EXPECT_THAT(result.err, HasSubstr("does not support sphere lights"));
  expect_nothing(result);
}

TEST_F(NothingMeasured, StudiesSaySoAndFail) {
  write("study.toml", R"(schema = 1
title = "Nothing"
scenes = ["sky.toml"]
quality = "quick"
width_px = 64
height_px = 48
[[run]]
label = "hard"
technique = "hard"
)");
  const ProcessResult bench = umbrameter({"bench", "study.toml", "--spp", "16", "--frames", "1"});
  EXPECT_EQ(bench.exit_code, 1) << bench.err;
  EXPECT_THAT(bench.err, HasSubstr("the truth can score no pixel"));
  for (const char* when : {"rendered", "stored"}) {
    const ProcessResult sweep = umbrameter({"sweep", "study.toml", "--spp", "16", "-o", "s"});
    EXPECT_EQ(sweep.exit_code, 1) << when << sweep.err;
    EXPECT_THAT(sweep.err, HasSubstr("the truth can score no pixel")) << when;
  }
}

TEST_F(NothingMeasured, AScoreSaysSoAndFails) {
  ASSERT_EQ(small({"reference", "sky.toml", "-o", "truth.exr"}).exit_code, 0);
  const ProcessResult result =
      umbrameter({"score", "truth.exr", "--reference", "truth.exr", "--limit", "0.5"});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("the truth can score no pixel"));
}

TEST_F(NothingMeasured, TheShareThatMustBeScoredCanBeSet) {
  write_scene("plate.toml");
  const ProcessResult strict =
      small({"validate", "plate.toml", "--technique", "hard", "--min-scored", "1", "-o", "v"});
  const ProcessResult loose =
      small({"validate", "plate.toml", "--technique", "hard", "--min-scored", "0", "-o", "v"});
  EXPECT_EQ(loose.exit_code, 0) << loose.err;
  EXPECT_NE(strict.exit_code, 2) << strict.err;
  EXPECT_EQ(small({"validate", "plate.toml", "--min-scored", "2"}).exit_code, 2);
}

}  // namespace
}  // namespace umbrameter
