// SPDX-License-Identifier: Apache-2.0
// Without these a verb could be in no group of --help, the manual page or a shell's completions could lack one, or a
// slip of the pen be met with a list.

#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using testing::Not;

class Help : public CliTest {
 protected:
  std::string out(const std::vector<std::string>& arguments) const {
    const ProcessResult result = umbrameter(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  }
};

const std::vector<std::string> kVerbs{"validate",  "score",      "bench",   "tune",   "plan",
                                      "sweep",     "merge",      "export",  "report", "regress",
                                      "stress",    "selftest",   "engines", "scene",  "render",
                                      "reference", "techniques", "metrics", "doctor", "help"};

TEST_F(Help, VerbsStandInGroupsAndNoneOutsideOfThem) {
  const std::string text = out({"--help"});
  for (const char* group :
       {"Measure:", "Studies of many runs:", "Guard against regressions:", "Look at one thing:"})
    EXPECT_THAT(text, HasSubstr(group));
  EXPECT_THAT(text, Not(HasSubstr("Subcommands:")));
  for (const std::string& verb : kVerbs) EXPECT_THAT(text, HasSubstr("\n  " + verb + " ")) << verb;
}

TEST_F(Help, HelpOfAVerbIsWhatTheVerbItselfSays) {
  EXPECT_EQ(out({"help", "validate"}), out({"validate", "--help"}));
  EXPECT_EQ(out({"help", "scene", "check"}), out({"scene", "check", "--help"}));
  EXPECT_EQ(out({"help"}), out({"--help"}));
  expect_bad_input(umbrameter({"help", "validat"}),
                   "no verb 'validat' to explain (did you mean 'validate'?)");
  expect_bad_input(umbrameter({"help", "scene", "chek"}), "did you mean 'check'?");
}

/// The lines of a verb's help that begin with "  umbrameter ".
std::vector<std::string> examples_in(const std::string& help) {
  std::vector<std::string> lines;
  std::istringstream text(help);
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("  umbrameter ")) lines.push_back(line.substr(2));
  return lines;
}

TEST_F(Help, EveryVerbHasExamplesWhoseOptionsItHas) {
  std::vector<std::vector<std::string>> paths;
  for (const std::string& verb : kVerbs) paths.push_back({verb});
  for (const char* part : {"list", "check", "plan", "import", "show", "export"})
    paths.push_back({"scene", part});
  for (const char* part : {"record", "check", "prove"}) paths.push_back({"regress", part});
  const std::string global = out({"--help"});
  for (std::vector<std::string> words : paths) {
    words.insert(words.begin(), "help");
    const std::string help = out(words);
    const std::vector<std::string> examples = examples_in(help);
    EXPECT_FALSE(examples.empty()) << words.back();
    for (const std::string& example : examples) {
      EXPECT_THAT(example, testing::StartsWith("umbrameter " + words[1]));
      std::istringstream text(example);
      for (std::string word; text >> word;) {
        if (!word.starts_with("--")) continue;
        EXPECT_THAT(help + global, HasSubstr(word)) << example;
      }
    }
  }
}

TEST_F(Help, WhatAVerbIgnoresIsSaid) {
  const ProcessResult ignored = umbrameter({"scene", "list", "--json", "--out", "x", "--threads", "2"});
  EXPECT_EQ(ignored.exit_code, 0);
  EXPECT_THAT(ignored.err, HasSubstr("--out is ignored: 'scene list' makes nothing of it"));
  EXPECT_THAT(ignored.err, HasSubstr("--threads is ignored"));
  EXPECT_FALSE(nlohmann::json::parse(ignored.out).empty());
  EXPECT_THAT(umbrameter({"scene", "list"}).err, Not(HasSubstr("ignored")));
}

TEST_F(Help, TheManualPageHasEveryVerbAndItsOptions) {
  const std::string page = out({"help", "--man"});
  EXPECT_THAT(page, testing::StartsWith(".TH UMBRAMETER 1"));
  for (const std::string& verb : kVerbs) EXPECT_THAT(page, HasSubstr("\n.SS " + verb + "\n")) << verb;
  EXPECT_THAT(page, HasSubstr("\\fB\\-\\-exact\\-check"));
  EXPECT_THAT(page, HasSubstr(".SS scene check\n"));
  EXPECT_THAT(page, HasSubstr("\numbrameter scene check plate my\\-scene.toml\n"));
  EXPECT_THAT(page, HasSubstr("UMBRAMETER_HOME"));
}

TEST_F(Help, BashCompletesVerbsOptionsScenesAndTechniques) {
  write("complete.bash", out({"help", "--completions", "bash"}));
  const auto completed = [&](const std::string& words, int at) {
    const std::string path = std::filesystem::path(program_path()).parent_path().string();
    const std::string script = "PATH=" + path + ":$PATH; source complete.bash; COMP_WORDS=(" + words +
                               "); COMP_CWORD=" + std::to_string(at) +
                               "; _umbrameter; printf '%s\\n' \"${COMPREPLY[@]}\"";
    const ProcessResult result = run_process({"bash", "-c", script}, {.working_folder = folder()});
    EXPECT_EQ(result.err, "");
    std::set<std::string> words_found;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) words_found.insert(line);
    return words_found;
  };
  EXPECT_EQ(completed("umbrameter val", 1), (std::set<std::string>{"validate"}));
  EXPECT_EQ(completed("umbrameter scene ch", 2), (std::set<std::string>{"check"}));
  EXPECT_EQ(completed("umbrameter validate --techn", 2), (std::set<std::string>{"--technique"}));
  EXPECT_EQ(completed("umbrameter validate --ass", 2), (std::set<std::string>{"--assets"}));
  EXPECT_EQ(completed("umbrameter validate pla", 2), (std::set<std::string>{"plate"}));
  EXPECT_EQ(completed("umbrameter validate plate --technique pcss_v", 4),
            (std::set<std::string>{"pcss_vsm"}));
  EXPECT_THAT(out({"help", "--completions", "zsh"}), testing::StartsWith("#compdef umbrameter"));
  EXPECT_THAT(out({"help", "--completions", "fish"}), HasSubstr("-a validate"));
  expect_bad_input(umbrameter({"help", "--completions", "fsh"}), "no completions for the shell 'fsh'");
}

TEST_F(Help, DoctorEndsWithAVerdictAndWhatWouldBringTheMissingParts) {
  require_gl();
  const std::string text = out({"doctor"});
  EXPECT_THAT(text, HasSubstr("\nverdict        both renderers work; without these parts:\n"));
  EXPECT_THAT(text, HasSubstr("scenes lack their models\n    to have it: "));  // the fixture gives no assets
  const auto json = nlohmann::json::parse(out({"doctor", "--json"}));
  ASSERT_GE(json["missing"].size(), 1u);
  EXPECT_THAT(json["missing"][0]["loss"].get<std::string>(), HasSubstr("lack their models"));
  EXPECT_THAT(json["missing"][0]["remedy"].get<std::string>(), HasSubstr("UMBRAMETER_ASSETS"));
}

TEST_F(Help, AMistypedFileIsMetWithTheNearestOne) {
  write("small.toml", "schema = 1\n");
  expect_bad_input(umbrameter({"plan", "smal.toml", "--out", "x"}), "did you mean 'small.toml'?");
  expect_bad_input(umbrameter({"score", "no/v.exr", "--scene", "plate"}), "there is no folder 'no'");
}

}  // namespace
}  // namespace umbrameter
