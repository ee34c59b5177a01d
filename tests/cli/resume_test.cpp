// SPDX-License-Identifier: Apache-2.0
// Without these a verb that was killed could lose what it had finished, measure it again, or end with other numbers; and a
// verb that is asked again could do its work again.

#include "core/error.h"
#include "store/database.h"
#include "tests/cli/cli_fixture.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <map>
#include <ostream>
#include <random>
#include <thread>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Rows = std::map<std::string, int64_t>;  // by key; a row that is put again gets another number

constexpr int kKills = 10;  // of each verb
constexpr int kPatience_s = 1500;

/// The entries of a store; empty while there is none.
Rows rows_of(const fs::path& store) {
  Rows rows;
  try {
    Database database(store / "store.sqlite", Database::Mode::read);
    // Of devices and pages a process may write what it finds anew.
    Statement query =
        database.prepare("SELECT key, rowid FROM entries WHERE kind NOT IN ('device', 'page', 'scene')");
    while (query.step()) rows[query.text(0)] = query.integer(1);
  } catch (const Error&) {
    rows.clear();  // in the making
  }
  return rows;
}

struct Verb {
  std::string name;
  std::vector<std::string> arguments;  // but --out
};

/// CTest's name of the case.
void PrintTo(const Verb& verb, std::ostream* out) {
  *out << verb.name;
}

class Resume : public CliTest, public testing::WithParamInterface<Verb> {
 protected:
  void SetUp() override {
    require_gl();
    write(
        "study.toml",
        "schema = 1\ntitle = \"Two\"\nscenes = [\"plate\", \"box_contact\"]\nwidth_px = 64\nheight_px = 36\n"
        "samples_per_pixel = 16\nframes = 6\n[[run]]\ntechnique = \"hard\"\n[[run]]\ntechnique = \"pcf\"\n"
        "[[run]]\ntechnique = \"pcss\"\n");
    write(
        "suite.toml",
        "schema = 1\ntitle = \"Two\"\nscenes = [\"plate\", \"box_contact\"]\nwidth_px = 64\nheight_px = 36\n"
        "samples_per_pixel = 16\n[[run]]\ntechnique = \"hard\"\n[[run]]\ntechnique = \"pcf\"\n"
        "[[run]]\ntechnique = \"pcss\"\n");
  }

  std::vector<std::string> command(const std::string& store) const {
    std::vector<std::string> all = GetParam().arguments;
    all.insert(all.end(), {"--json", "--out", store});
    return all;
  }

  /// What the verb says in the end, without what differs from one time to the next.
  Json answer(const std::string& store) const {
    ProcessOptions options;
    options.timeout_s = kPatience_s;
    const ProcessResult result = umbrameter(command(store), options);
    EXPECT_LE(result.exit_code, 1) << result.err;
    Json json = Json::parse(result.out, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << result.out << result.err;
    drop_times(json);
    return json;
  }

  /// Starts the verb and kills it when its store has more entries than `entries`. False when it was done before.
  bool kill_after(const std::string& store, size_t entries) const {
    const std::vector<std::string> arguments = command(store);
    const std::string program = program_path();
    std::vector<char*> argv = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      if (chdir(folder().c_str()) != 0) _exit(125);
      for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(open("/dev/null", O_WRONLY), stream);
      execv(program.c_str(), argv.data());
      _exit(127);
    }
    const auto start = std::chrono::steady_clock::now();
    int status = 0;
    while (rows_of(folder() / store).size() <= entries) {
      if (waitpid(child, &status, WNOHANG) == child) return false;
      if (std::chrono::steady_clock::now() - start > std::chrono::seconds(kPatience_s)) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return WIFSIGNALED(status);
  }

 private:
  static void drop_times(Json& json) {
    static const std::vector<std::string> kTimes = {
        "wall_time_s", "pass_times",          "time_ms",      "measured_at", "work",     "saved_s",
        "is_on_front", "recommended",         "dominated_by", "skipped",     "device",   "elapsed_s",
        "duration_s",  "references_rendered", "rendered",     "reused",      "verdicts", "warnings"};
    if (json.is_object()) {
      for (const std::string& key : kTimes) json.erase(key);
    }
    if (json.is_structured()) {
      for (Json& part : json) drop_times(part);
    }
  }
};

TEST_P(Resume, AskedAgainItMeasuresNothing) {
  const Json first = answer("store");
  const Rows rows = rows_of(folder() / "store");
  EXPECT_GT(rows.size(), 2u);
  EXPECT_EQ(answer("store"), first);
  EXPECT_EQ(rows_of(folder() / "store"), rows);
}

TEST_P(Resume, KilledAtAnyMomentItGoesOnFromThere) {
  const Json whole = answer("whole");
  const size_t all = rows_of(folder() / "whole").size();
  std::mt19937 random(7);
  int kills = 0;
  for (int i = 0; i < kKills; ++i) {
    const std::string store = "killed" + std::to_string(i);
    const size_t entries = std::uniform_int_distribution<size_t>(0, all - 1)(random);
    if (!kill_after(store, entries)) continue;
    ++kills;
    const Rows before = rows_of(folder() / store);
    EXPECT_EQ(answer(store), whole) << "killed after " << entries << " entries";
    const Rows after = rows_of(folder() / store);
    EXPECT_EQ(after.size(), all);
    for (const auto& [key, row] : before) {
      const auto found = after.find(key);
      ASSERT_NE(found, after.end()) << "lost";
      EXPECT_EQ(found->second, row) << "measured again, killed after " << entries << " entries";
    }
  }
  EXPECT_GE(kills, kKills / 2) << "it was done before it was killed";
}

const std::vector<std::string> kSize = {"--width", "64", "--height", "36", "--spp", "16"};

std::vector<std::string> with_size(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), kSize.begin(), kSize.end());
  return arguments;
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, Resume,
    testing::Values(
        Verb{"validate", with_size({"validate", "plate", "box_contact", "--technique", "hard", "--technique",
                                    "pcf", "--technique", "pcss", "--frames", "1", "--causes", "none"})},
        Verb{"sweep", {"sweep", "study.toml"}}, Verb{"bench", {"bench", "study.toml"}},
        Verb{"regress", {"regress", "record", "suite.toml", "--baseline", "base", "--reason", "again"}},
        Verb{"stress",
             with_size({"stress", "--axis", "map_size", "--technique", "hard", "--technique", "pcf"})},
        Verb{"traits", with_size({"techniques", "traits", "hard", "pcss"})},
        Verb{"selftest",
             {"selftest", "--scene", "plate", "--benign", "--hardening", "--width", "64", "--height", "64"}},
        Verb{"tune", with_size({"tune", "plate", "--technique", "pcf_disk", "--evaluations", "6", "--cameras",
                                "1", "--no-coarse", "--time-limit", "1000s"})}),
    [](const testing::TestParamInfo<Verb>& verb) { return verb.param.name; });

}  // namespace
}  // namespace umbrameter
