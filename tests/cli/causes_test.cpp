// SPDX-License-Identifier: Apache-2.0
// Without these tests the causes that 'validate' names could be anything: here each fault is put in by one parameter, and
// that one must mend it.
#include "tests/cli/cli_fixture.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace umbrameter {
namespace {

using nlohmann::json;
using testing::AllOf;
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
    return all.at("scenes").at(0).at("techniques").at(0).value("fault_causes", json());
  }

  static json fault_of(const json& causes, const std::string& fault) {
    for (const json& one : causes.at("faults")) {
      if (one.at("fault") == fault) return one;
    }
    ADD_FAILURE() << "no " << fault << " in " << causes.dump(1);
    return {{"cause", ""}, {"sentence", ""}};
  }
};

TEST_F(Causes, ABiasTooLargeIsMendedByLess) {
  require_gl();
  const json causes = by_substitution("colonnade", "pcss:bias_texels=32,receiver_plane=none");
  const json fault = fault_of(causes, "peter_panning");
  const std::string cause = fault.at("cause").get<std::string>();
  EXPECT_THAT(cause, testing::AnyOf("bias_zero", "bias_tenth")) << causes.dump(1);
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
  const std::string cause = causes.at("faults").at(0).at("cause").get<std::string>();
  EXPECT_THAT(cause, testing::AnyOf("map_fourfold", "map_sixteenfold")) << causes.dump(1);
}

TEST_F(Causes, AFilterTooWideIsMendedByANarrowerOne) {
  require_gl();
  const json causes = by_substitution("box_contact", "pcf_disk:radius_texels=64,map_size=1024");
  const std::string cause = fault_of(causes, "penumbra_too_wide").at("cause").get<std::string>();
  EXPECT_THAT(cause, testing::AnyOf("filter_quarter", "filter_half")) << causes.dump(1);
}

TEST_F(Causes, ASearchThatMissesBlockersIsMendedByTheTruths) {
  require_gl();
  const json causes = by_substitution("half_plane", "pcss:search_taps=1");
  const json fault = causes.at("faults").at(0);
  EXPECT_EQ(fault.at("cause"), "blocker_truth") << causes.dump(1);
  EXPECT_THAT(fault.at("sentence").get<std::string>(), HasSubstr("the truth's blocker distance removes"));
}

TEST_F(Causes, BlockersThatOneMapDoesNotShowAreNoMatterOfBias) {
  require_gl();
  const std::string church = (source_dir() / "tests/scenes/church.toml").string();
  const json causes = by_substitution(church, "pcss");
  const json fault = fault_of(causes, "peter_panning");
  EXPECT_GT(fault.at("mean_abs_error"), 0.01);
  EXPECT_EQ(fault.at("cause"), "blocker_truth") << causes.dump(1);
  EXPECT_THAT(fault.at("sentence").get<std::string>(),
              AllOf(HasSubstr("no bias mends it; the truth's blocker distance removes"),
                    HasSubstr("the search does not find these blockers in one map from the light's centre")));
}

TEST_F(Causes, WhatNothingMendsIsSaidSo) {
  require_gl();
  // Shadows that are never darker than this: no bias, map, filter or blocker can make them so.
  const json causes = by_substitution("colonnade", "esm:darkest=0.7");
  const json fault = causes.at("faults").at(0);
  EXPECT_TRUE(fault.at("cause").is_null()) << causes.dump(1);
  EXPECT_THAT(fault.at("sentence").get<std::string>(), HasSubstr("nothing that was tried mends it"));
}

TEST_F(Causes, ComeWithTheTableAndFromTheStore) {
  require_gl();
  const std::vector<std::string> command = {
      "validate", "colonnade", "--technique", "pcss:bias_texels=32,receiver_plane=none",
      "--causes", "worst",     "--width",     "160",
      "--height", "90",        "--spp",       "64",
      "--frames", "0"};
  const ProcessResult first = umbrameter(command);
  EXPECT_THAT(first.out, HasSubstr("a tenth of the bias removes"));
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
