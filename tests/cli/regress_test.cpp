// SPDX-License-Identifier: Apache-2.0
// Without these, a regression gate could pass a leak, fail without a change, or forget why a baseline changed.

#include "tests/cli/cli_fixture.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace umbrameter {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Regress : public CliTest {
 protected:
  void SetUp() override { require_gl(); }

  // A suite of one scene of its own; `run` is what its pcss gets, `more` stands before the runs.
  void write_suite(const std::string& run = "search_taps = 16", const std::string& more = {},
                   const std::string& after = {}) const {
    write("suite.toml",
          "schema = 1\ntitle = \"t\"\nscenes = [\"scene.toml\"]\nwidth_px = 128\nheight_px = 72\n"
          "samples_per_pixel = 64\nmost_samples_per_pixel = 128\n" +
              more + "[[run]]\nlabel = \"soft\"\ntechnique = \"pcss\"\nvalues = { " + run + " }\n" + after);
  }
  ProcessResult regress(const std::string& part, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"regress", part, "suite.toml", "--baseline", "base"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return umbrameter(arguments);
  }
  void record() const {
    write_scene("scene.toml");
    write_suite();
    const ProcessResult result = regress("record");
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  std::string baseline() const {
    std::ifstream file(folder() / "base" / "suite.toml");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  // The baseline with `from`, which stands in it, replaced.
  void edit_baseline(const std::string& from, const std::string& to) const {
    std::string text = baseline();
    const size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write("base/suite.toml", text.replace(at, from.size(), to));
  }
};

TEST_F(Regress, PassesWithoutAChangeForOtherSeedsAndThreads) {
  record();
  for (const char* seed : {"1", "2", "3", "4"}) {
    const ProcessResult result = regress("check", {"--seed", seed, "--threads", seed, "--json"});
    EXPECT_EQ(result.exit_code, 0) << seed << result.err << result.out;
    EXPECT_EQ(Json::parse(result.out)["fail"], 0);
  }
}

TEST_F(Regress, AWorseTechniqueFailsEverywhereItIsAsked) {
  record();
  write_suite("filter_taps = 1");  // the shadows of a hard map
  const Json other = Json::parse(regress("check", {"--json"}).out)["cases"][0];
  EXPECT_EQ(other["outcome"], "fail");
  ASSERT_EQ(other["notes"].size(), 1u);
  EXPECT_EQ(other["notes"][0], "the run is another: filter_taps was 16 and is 1 (accept it with --update)");
  const ProcessResult result =
      regress("check", {"--junit", "j.xml", "--annotate", "github", "--report", "r.md"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("::error title=scene.toml%2C soft%3A "));
  EXPECT_THAT(result.out, HasSubstr("64 added"));  // a failure must hold with all samples and three seeds
  EXPECT_THAT(result.out, HasSubstr("3 seeds"));
  EXPECT_THAT(result.err, HasSubstr("1 of 1 cases fail"));
  std::ifstream junit(folder() / "j.xml"), report(folder() / "r.md");
  std::ostringstream xml, table;
  xml << junit.rdbuf();
  table << report.rdbuf();
  EXPECT_THAT(xml.str(), HasSubstr("failures=\"1\""));
  EXPECT_THAT(table.str(), HasSubstr("| scene.toml | soft | fail: "));
}

TEST_F(Regress, AnotherSceneIsSaidToBeOne) {
  record();
  write_scene("scene.toml", "[[mesh]]\nshape = \"plate\"\nsize = [1, 1]\ntranslate = [2, 1, 0]\n");
  const ProcessResult result = regress("check");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("the scene is another"));
}

TEST_F(Regress, MissingAndStaleEntriesAreSaid) {
  record();
  edit_baseline("label = \"soft\"", "label = \"gone\"");
  const ProcessResult result = regress("check");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("scene.toml, soft: fail: missing"));
  EXPECT_THAT(result.out, HasSubstr("scene.toml, gone: fail: stale"));
  const ProcessResult none = umbrameter({"regress", "check", "suite.toml", "--baseline", "nowhere"});
  expect_bad_input(none, "regress record");
}

TEST_F(Regress, AnUpdateNeedsAReasonAndKeepsIt) {
  record();
  edit_baseline("label = \"soft\"", "label = \"gone\"");
  expect_bad_input(regress("check", {"--update"}), "--update needs --reason");
  const ProcessResult result = regress("check", {"--update", "--reason", "renamed \"gone\""});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(baseline(), HasSubstr("text = \"renamed \\\"gone\\\"\""));
  EXPECT_THAT(baseline(), HasSubstr("changed = [\"scene.toml, soft\", \"scene.toml, gone\"]"));
  EXPECT_THAT(baseline(), Not(HasSubstr("label = \"gone\"")));
  EXPECT_EQ(regress("check").exit_code, 0);
  const std::string kept = baseline();
  EXPECT_EQ(regress("check", {"--update", "--reason", "nothing"}).exit_code, 0);
  EXPECT_EQ(baseline(), kept);  // what is the same stays, byte for byte
}

TEST_F(Regress, ARecordIsNotOverwrittenByChance) {
  record();
  expect_bad_input(regress("record"), "is there already");
}

TEST_F(Regress, ABrokenTechniqueFailsWithItsMessage) {
  record();
  const std::filesystem::path home = source_dir() / "realtime" / "techniques";
  std::filesystem::copy(home / "pcss", folder() / "pcss.copy");
  std::ofstream(folder() / "pcss.copy" / "pcss.frag", std::ios::app) << "\nno GLSL\n";
  write("suite.toml",
        "schema = 1\ntitle = \"t\"\nscenes = [\"scene.toml\"]\nwidth_px = 128\nheight_px = 72\n"
        "samples_per_pixel = 64\n[[run]]\nlabel = \"soft\"\ntechnique = \"./pcss.copy\"\n");
  const ProcessResult result = regress("check");
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.out, HasSubstr("soft: fail: failure: "));
  EXPECT_EQ(regress("check", {"--update", "--reason", "no"}).exit_code, 1);
  EXPECT_THAT(baseline(), Not(HasSubstr("\"no\"")));
}

TEST_F(Regress, ABadSuiteIsBadInput) {
  write_scene("scene.toml");
  write_suite("search_taps = 16", "", "[gates]\nrachet = true\n");
  expect_bad_input(regress("record"), "rachet");
}

TEST_F(Regress, EachCameraHasACaseOfItsOwn) {
  const auto cameras = [](const std::string& angle_deg) {
    return "[[camera]]\nname = \"own\"\n[[camera]]\nname = \"side\"\norbit_deg = " + angle_deg + "\n";
  };
  write_scene("scene.toml");
  write_suite("search_taps = 16", cameras("20"));
  ASSERT_EQ(regress("record").exit_code, 0);
  const ProcessResult same = regress("check", {"--json"});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  const Json before = Json::parse(same.out);
  ASSERT_EQ(before["cases"].size(), 2u);
  EXPECT_EQ(before["cases"][0]["scene"], "scene.toml, own");
  EXPECT_EQ(before["cases"][1]["scene"], "scene.toml, side");
  write_suite("search_taps = 16", cameras("25"));
  const ProcessResult moved = regress("check", {"--json"});
  EXPECT_EQ(moved.exit_code, 1) << moved.err;
  for (const Json& one : Json::parse(moved.out)["cases"])
    EXPECT_EQ(one["outcome"] == "fail", one["scene"] == "scene.toml, side") << one;
}

TEST_F(Regress, TakesOneQuality) {
  write_scene("scene.toml");
  write("suite.toml",
        "schema = 1\ntitle = \"t\"\nscenes = [\"scene.toml\"]\nquality = [\"quick\", \"full\"]\n"
        "[[run]]\ntechnique = \"hard\"\n");
  expect_bad_input(regress("record"), "one quality, not 2");
}

}  // namespace
}  // namespace umbrameter
