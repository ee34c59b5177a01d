// SPDX-License-Identifier: Apache-2.0
// Without these tests the causes that 'validate' names could be anything: here each fault is put in by one parameter, and
// that one must mend it.
#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbrameter {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Causes : public CliTest {
 protected:
  /// Faults with their causes of one run of `technique` on `scene`.
  json by_substitution(const std::string& scene, const std::string& technique) {
    const ProcessResult result =
        umbrameter({"validate", scene, "--technique", technique, "--causes", "worst", "--width", "160",
                    "--height", "90", "--spp", "64", "--frames", "0", "--metrics", "diagnosis", "--json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const json all = json::parse(result.out);
    return all.at("scenes").at(0).at("techniques").at(0).at("causes").value("by_substitution", json());
  }

  static json fault_of(const json& causes, const std::string& fault) {
    for (const json& one : causes.at("faults")) {
      if (one.at("fault") == fault) return one;
    }
    ADD_FAILURE() << "no " << fault << " in " << causes.dump(1);
    return {{"cause", ""}, {"sentence", ""}};
  }
};

TEST_F(Causes, ABiasTooLargeIsMendedByNone) {
  require_gl();
  const json causes = by_substitution("colonnade", "pcss:bias_texels=32,receiver_plane=none");
  const json fault = fault_of(causes, "peter_panning");
  EXPECT_EQ(fault.at("cause"), "bias_zero") << causes.dump(1);
  EXPECT_THAT(fault.at("sentence").get<std::string>(), HasSubstr("the bias is too large"));
}

TEST_F(Causes, ABiasTooSmallIsMendedByMore) {
  require_gl();
  const json causes = by_substitution(
      "colonnade", "hard:bias_texels=0,normal_offset_texels=0,receiver_plane=none,map_size=256");
  EXPECT_EQ(fault_of(causes, "acne").at("cause"), "bias_tenfold") << causes.dump(1);
}

TEST_F(Causes, ASmallMapIsMendedByALargerOne) {
  require_gl();
  const json causes = by_substitution("fence", "pcss:map_size=64");
  EXPECT_EQ(causes.at("faults").at(0).at("cause"), "map_fourfold") << causes.dump(1);
}

TEST_F(Causes, AFilterTooWideIsMendedByANarrowerOne) {
  require_gl();
  const json causes = by_substitution("box_contact", "pcf_disk:radius_texels=64,map_size=1024");
  const std::string cause = fault_of(causes, "penumbra_too_wide").at("cause").get<std::string>();
  EXPECT_THAT(cause, testing::AnyOf("filter_quarter", "filter_half")) << causes.dump(1);
}

/// A plate near the light hides the box from its centre, and only from there: the search takes the plate for what shadows
/// the floor beside the box.
constexpr const char* kHiddenBox = R"(title = "Hidden box"
[camera]
eye = [1.2, 1.0, 1.6]
at = [0.3, 0, 0]
[[light]]
type = "rect"
center = [0, 4, 0]
direction = [0, -1, 0]
size = [2, 2]
[[mesh]]
shape = "plane"
size = [6, 6]
[[mesh]]
shape = "plate"
size = [0.5, 0.5]
translate = [0, 3.5, 0]
[[mesh]]
shape = "box"
size = [0.5, 0.8, 0.5]
translate = [0, 0.4, 0]
)";

TEST_F(Causes, BlockersThatTheMapDoesNotSeeComeFromTheTruth) {
  require_gl();
  write("hidden_box.toml", kHiddenBox);
  const json causes = by_substitution("hidden_box.toml", "pcss");
  const json worst = causes.at("faults").at(0);
  EXPECT_THAT(worst.at("cause").dump(), testing::AnyOf("\"blocker_truth\"", "\"light_points\""))
      << causes.dump(1);
  const size_t index = 0;
  for (const json& outcome : causes.at("tried")) {
    if (outcome.at("id") == "blocker_truth") {
      EXPECT_GT(outcome.at("removed").at(index).get<double>(), 0.5) << causes.dump(1);
    }
  }
}

TEST_F(Causes, WhatNothingMendsIsSaidSo) {
  require_gl();
  // A plane projected onto itself casts shadows onto no other: nothing of its parameters can.
  const json causes = by_substitution("stacked_plates", "vsm:bleed_reduction=0");
  bool is_said = false;
  for (const json& fault : causes.at("faults"))
    is_said = is_said || (fault.at("cause").is_null() &&
                          fault.at("sentence").get<std::string>().find("nothing that was tried mends it") !=
                              std::string::npos);
  EXPECT_TRUE(is_said) << causes.dump(1);
}

TEST_F(Causes, ComeWithTheTableAndFromTheStore) {
  require_gl();
  const std::vector<std::string> command = {
      "validate", "colonnade", "--technique", "pcss:bias_texels=32,receiver_plane=none",
      "--causes", "worst",     "--width",     "160",
      "--height", "90",        "--spp",       "64",
      "--frames", "0"};
  const ProcessResult first = umbrameter(command);
  EXPECT_THAT(first.out, HasSubstr("bias 0 removes"));
  const ProcessResult again = umbrameter(command);
  EXPECT_EQ(again.out, first.out);
  EXPECT_THAT(again.err, HasSubstr("0 runs and 0 truths rendered"));
  std::vector<std::string> detailed = command;
  detailed.emplace_back("--details");
  EXPECT_THAT(umbrameter(detailed).out, HasSubstr("ten times the bias"));
}

TEST_F(Causes, AnUnknownChoiceIsRefused) {
  expect_bad_input(umbrameter({"validate", "plate", "--causes", "wrost"}), "'worst'");
}

}  // namespace
}  // namespace umbrameter
