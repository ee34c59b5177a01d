// SPDX-License-Identifier: Apache-2.0
// Without these two verbs on one store could make the same truth or picture twice, or one that is asked again could make it anew.

#include "tests/cli/cli_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <random>

namespace umbrameter {
namespace {

constexpr int kOrders = 4;
constexpr int kPatience_s = 600;

using Command = std::vector<std::string>;

const Command kSize = {"--width", "64", "--height", "36", "--spp", "16"};

Command sized(Command command) {
  command.insert(command.end(), kSize.begin(), kSize.end());
  return command;
}

using Counts = std::map<std::string, int>;

/// Adds the lines of a log of what was drawn that start so, and how often each stands there.
void count_lines(const std::filesystem::path& file, const std::string& start, Counts& counts) {
  std::ifstream log(file);
  for (std::string line; std::getline(log, line);)
    if (line.starts_with(start)) ++counts[line];
}

/// They draw many pictures that nobody asks for again, and keep what they found out instead (docs/store.md).
bool is_search(const Command& verb) {
  return verb.front() == "tune" || verb.front() == "stress" || verb.front() == "selftest";
}

class AnyOrder : public CliTest {
 protected:
  void SetUp() override {
    require_gl();
    const std::string views =
        "schema = 1\ntitle = \"Two\"\nscenes = [\"plate\", \"box_contact\"]\nwidth_px = 64\nheight_px = 36\n"
        "samples_per_pixel = 16\n";
    const std::string runs =
        "[[run]]\ntechnique = \"hard\"\n[[run]]\ntechnique = \"pcf\"\n[[run]]\ntechnique = \"pcss\"\n";
    ASSERT_EQ(umbrameter(sized({"render", "plate", "--technique", "hard", "--out", "picture.exr"})).exit_code,
              0);
    write("study.toml", views + "frames = 6\n" + runs);
    write("suite.toml", views + runs);
  }

  void run(Command command, const std::string& store, const std::string& log) const {
    command.insert(command.end(), {"--json", "--out", store});
    ProcessOptions options;
    options.timeout_s = kPatience_s;
    options.environment = {{"UMBRAMETER_DRAW_LOG", log}};
    const ProcessResult result = umbrameter(command, options);
    EXPECT_LE(result.exit_code, 1) << command.front() << ": " << result.err;
  }

  static const std::vector<Command>& verbs() {
    static const std::vector<Command> kVerbs = {
        sized({"validate", "plate", "box_contact", "--technique", "hard", "--technique", "pcf", "--technique",
               "pcss", "--frames", "0", "--causes", "none"}),
        {"sweep", "study.toml"},
        {"bench", "study.toml"},
        {"regress", "record", "suite.toml", "--baseline", "base", "--reason", "again"},
        sized({"stress", "--axis", "map_size", "--technique", "hard"}),
        sized({"techniques", "traits", "hard"}),
        {"score", "picture.exr", "--scene", "plate", "--spp", "16"},
        {"selftest", "--scene", "plate", "--width", "64", "--height", "64"},
        sized({"tune", "plate", "--technique", "pcf_disk", "--evaluations", "4", "--cameras", "1",
               "--no-coarse", "--time-limit", "1000s"})};
    return kVerbs;
  }
};

TEST_F(AnyOrder, EachTruthAndEachPictureIsMadeOnce) {
  std::vector<Command> order = verbs();
  std::mt19937 random(5);
  for (int i = 0; i < kOrders; ++i) {
    const std::string store = "store" + std::to_string(i), log = "log" + std::to_string(i);
    std::string names;
    for (const Command& verb : order) {
      names += verb.front() + " ";
      run(verb, store, is_search(verb) ? log + "-searches" : log);
    }
    Counts counts;
    count_lines(folder() / log, "", counts);
    EXPECT_GT(counts.size(), 20u);
    count_lines(folder() / (log + "-searches"), "truth", counts);
    for (const auto& [line, count] : counts) EXPECT_EQ(count, 1) << line << "\nin " << names;
    std::ranges::shuffle(order, random);
  }
}

TEST_F(AnyOrder, AskedAgainNothingIsMade) {
  for (const Command& verb : verbs()) run(verb, "store", "first");
  for (const Command& verb : verbs()) run(verb, "store", "again");
  Counts again;
  count_lines(folder() / "again", "", again);
  for (const auto& [line, count] : again) ADD_FAILURE() << count << " times " << line;
}

}  // namespace
}  // namespace umbrameter
