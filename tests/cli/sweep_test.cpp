// SPDX-License-Identifier: Apache-2.0
// Without these a sweep could lose its work when it is killed, or do it twice.

#include "tests/cli/cli_fixture.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <future>
#include <thread>

namespace umbrameter {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

constexpr size_t kRuns = 24;  // enough that a kill finds some done and some not

class SweepCommand : public CliTest {
 protected:
  void write_study(const std::string& more = "") const {
    write_scene("scene.toml");
    write(
        "study.toml",
        "schema = 1\ntitle = \"Tiny\"\nscenes = [\"scene.toml\", \"plate\"]\nwidth_px = 64\nheight_px = 36\n"
        "samples_per_pixel = 64\n[[run]]\ntechnique = \"pcf_bilinear\"\n[run.values]\nmap_size = 64\n"
        "grid_taps = { range = [3, 7, 2] }\n[run.sample]\ncount = 4\nslope_bias = [0.1, 2.0]\n" +
            more);
  }
  Json json(const std::vector<std::string>& arguments, int exit_code = 0) const {
    std::vector<std::string> all = arguments;
    all.push_back("--json");
    const ProcessResult result = umbrameter(all);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    return Json::parse(result.out, nullptr, false);
  }
  /// The runs of a store without what differs from one time to the next.
  Json numbers(const std::string& store) const {
    Json runs = json({"export", store})["runs"];
    for (Json& run : runs) {
      for (const char* time : {"started", "duration_s"}) run.erase(time);
      for (const char* time : {"wall_time_s", "pass_times"}) run["result"].erase(time);
      run["result"]["measurements"].erase("time_ms");
      run.erase("baseline_times");
    }
    return runs;
  }
  size_t objects(const std::string& store) const {
    std::error_code none;
    size_t count = 0;
    for (auto it = std::filesystem::recursive_directory_iterator(folder() / store / "objects", none);
         it != std::filesystem::recursive_directory_iterator(); it.increment(none))
      count += it->path().extension() == ".exr" ? 1 : 0;
    return count;
  }
  /// Kills the sweep with SIGKILL once it has stored a few images.
  void kill_sweep(const std::string& store, size_t images) const {
    const std::string program = program_path();
    const pid_t child = fork();
    if (child == 0) {
      if (chdir(folder().c_str()) != 0) _exit(125);
      for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(open("/dev/null", O_WRONLY), stream);
      execl(program.c_str(), program.c_str(), "sweep", "study.toml", "--out", store.c_str(), nullptr);
      _exit(127);
    }
    const auto start = std::chrono::steady_clock::now();
    while (objects(store) < images && std::chrono::steady_clock::now() - start < std::chrono::seconds(100))
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the sweep was done before it was killed";
  }
};

class GlSweepCommand : public SweepCommand {
 protected:
  void SetUp() override { require_gl(); }
};

TEST_F(GlSweepCommand, GoesOnAfterKillWithoutRepeatingWork) {
  write_study();
  size_t done = 0;
  for (const size_t images : {12u, 24u}) {
    kill_sweep("killed", images);
    const size_t stored = numbers("killed").size();
    EXPECT_GE(stored, done);
    done = stored;
  }
  ASSERT_GT(done, 0u);
  ASSERT_LT(done, kRuns);
  const Json plan = json({"plan", "study.toml", "--out", "killed"});
  EXPECT_EQ(plan["reuse"], done);
  EXPECT_EQ(plan["render"], kRuns - done);
  const Json outcome = json({"sweep", "study.toml", "--out", "killed"});
  EXPECT_EQ(outcome["reused"], done);
  EXPECT_EQ(outcome["rendered"], kRuns - done);
  json({"sweep", "study.toml", "--out", "whole"});
  EXPECT_TRUE(numbers("killed") == numbers("whole"));
  EXPECT_EQ(json({"sweep", "study.toml", "--out", "whole"})["rendered"], 0);
  EXPECT_EQ(json({"sweep", "study.toml", "--out", "whole", "--no-reuse", "--shard", "1/12"})["rendered"], 2);
}

TEST_F(GlSweepCommand, PartsMergedAreTheWhole) {
  write_study();
  // The scenes' line is cut within a scene, so that both parts render that scene's truth.
  EXPECT_EQ(json({"sweep", "study.toml", "--out", "a", "--shard", "1/3"})["rendered"], 8);
  EXPECT_EQ(json({"sweep", "study.toml", "--out", "b", "--shard", "2/3"})["rendered"], 8);
  EXPECT_EQ(json({"sweep", "study.toml", "--out", "b", "--shard", "3/3"})["rendered"], 8);
  const Json merged = json({"merge", "a", "b", "--out", "c"});
  EXPECT_EQ(merged["added"], 2 * kRuns + 4);  // each with its frame; per scene a truth and its parity
  EXPECT_EQ(merged["present"], 2);
  json({"sweep", "study.toml", "--out", "whole"});
  EXPECT_EQ(numbers("c").size(), kRuns);
  EXPECT_TRUE(numbers("c") == numbers("whole"));
  EXPECT_EQ(objects("c"), objects("whole"));
  EXPECT_EQ(json({"sweep", "study.toml", "--out", "c"})["rendered"], 0);
}

TEST_F(GlSweepCommand, CamerasTimesAndVerdictsSurviveTheSplit) {
  write_scene("scene.toml");
  write("study.toml",
        "schema = 1\ntitle = \"Tiny\"\nscenes = [\"scene.toml\"]\nwidth_px = 64\nheight_px = 36\nframes = 7\n"
        "samples_per_pixel = 64\n[[camera]]\nname = \"own\"\n[[camera]]\nname = \"side\"\norbit_deg = 15\n"
        "[[run]]\ntechnique = \"hard\"\n[run.values]\nmap_size = 64\n"
        "[[run]]\ntechnique = \"pcf\"\n[run.values]\nmap_size = 64\n");
  const Json whole = json({"sweep", "study.toml", "--out", "whole", "--time"});
  EXPECT_EQ(whole["rendered"], 4);
  const Json& verdicts = whole["verdicts"];
  EXPECT_EQ(verdicts["better"].get<int>() + verdicts["worse"].get<int>() + verdicts["same"].get<int>() +
                verdicts["cannot_tell"].get<int>(),
            2);
  // The second part begins with a run whose baseline is in the first.
  for (const char* part : {"1/4", "2/4", "3/4", "4/4"})
    json({"sweep", "study.toml", "--out", std::string("part") + part[0], "--time", "--shard", part});
  json({"merge", "part1", "part2", "part3", "part4", "--out", "merged"});
  EXPECT_TRUE(numbers("merged") == numbers("whole"));
  const Json run = json({"export", "merged"})["runs"][3];
  EXPECT_EQ(run["camera"], "side");
  EXPECT_EQ(run["result"]["verdict"]["baseline"], "hard");
  EXPECT_EQ(run["result"]["pass_times"].back()["frames"], 7);
  EXPECT_EQ(run["baseline_times"].back()["frames"], 7);
  EXPECT_EQ(json({"export", "merged", "--baseline", "pcf"})["runs"][3]["result"]["verdict"], nullptr);
  EXPECT_EQ(json({"plan", "study.toml", "--out", "merged", "--time"})["render"], 0);
}

TEST_F(GlSweepCommand, TwoAtOnceShareAStore) {
  write_study();
  const auto start = [&] {
    return std::async(std::launch::async, [&] {
      return umbrameter({"sweep", "study.toml", "--out", "both"});
    });
  };
  auto one = start();
  auto other = start();
  for (auto* running : {&one, &other}) {
    const ProcessResult result = running->get();
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err.find("warning"), std::string::npos) << result.err;
  }
  EXPECT_EQ(numbers("both").size(), kRuns);
  EXPECT_EQ(json({"sweep", "study.toml", "--out", "both"})["rendered"], 0);
}

TEST_F(GlSweepCommand, AFailedRunIsRecordedAndTheRestGoesOn) {
  std::filesystem::create_directory(folder() / "copies");
  const auto from = source_dir() / "realtime" / "techniques";
  std::filesystem::copy(from / "hard", folder() / "copies" / "hard");
  std::ofstream(folder() / "copies" / "hard" / "hard.frag", std::ios::app) << "this does not compile\n";
  write_study("[[run]]\nlabel = \"bad\"\ntechnique = \"copies/hard\"\n");
  const Json outcome = json({"sweep", "study.toml", "--out", "out"}, 2);
  EXPECT_EQ(outcome["failures"].size(), 2u);
  EXPECT_EQ(outcome["rendered"], kRuns + 2);
  const ProcessResult csv = umbrameter({"export", "out", "--csv"});
  EXPECT_EQ(std::ranges::count(csv.out, '\n'), static_cast<int>(1 + kRuns + 2));
  EXPECT_THAT(csv.out, HasSubstr(",failed,,,,"));
  EXPECT_THAT(umbrameter({"export", "out"}).out, HasSubstr("RMSE"));
  EXPECT_EQ(umbrameter({"export", "out", "--csv", "-o", "runs.csv"}).out, "");
  std::ifstream written(folder() / "runs.csv");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(written), {}), csv.out);
  // The failure is known: nothing is tried again, and the exit code still says so.
  EXPECT_EQ(json({"sweep", "study.toml", "--out", "out"}, 2)["rendered"], 0);
}

TEST_F(GlSweepCommand, PlanNamesReasonsAndTouchesNothing) {
  write_study(
      "[[run]]\nlabel = \"twin\"\ntechnique = \"hard\"\n[[run]]\nlabel = \"other\"\ntechnique = \"hard\"\n");
  const ProcessResult plan = umbrameter({"plan", "study.toml", "--out", "nowhere"});
  EXPECT_EQ(plan.exit_code, 0) << plan.err;
  for (const char* part : {"not stored", "the same as 'twin'", "2 truths to render", "a rough guess"})
    EXPECT_THAT(plan.out, HasSubstr(part));
  EXPECT_FALSE(std::filesystem::exists(folder() / "nowhere"));
}

TEST_F(GlSweepCommand, EachQualityIsSweptIntoOneStore) {
  write_scene("scene.toml");
  write("study.toml",
        "schema = 1\ntitle = \"Two sizes\"\nscenes = [\"scene.toml\"]\nquality = [\"quick\", \"standard\"]\n"
        "[[run]]\ntechnique = \"hard\"\n[run.values]\nmap_size = [64, 128]\n");
  const Json planned = json({"plan", "study.toml", "--out", "a"});
  ASSERT_EQ(planned["qualities"].size(), 2u);
  EXPECT_EQ(planned["qualities"][0]["quality"], "quick");
  EXPECT_EQ(planned["qualities"][1]["render"], 2);
  const Json swept = json({"sweep", "study.toml", "--out", "a"});
  EXPECT_EQ(swept["qualities"][1]["quality"], "standard");
  EXPECT_EQ(swept["qualities"][1]["references_rendered"], 1);
  std::vector<int> widths;
  const Json stored = json({"export", "a"});
  for (const Json& run : stored["runs"]) widths.push_back(run["width_px"]);
  EXPECT_THAT(widths, testing::UnorderedElementsAre(480, 480, 960, 960));
  const Json again = json({"sweep", "study.toml", "--out", "a"});
  for (const Json& quality : again["qualities"]) EXPECT_EQ(quality["reused"], 2);
  expect_bad_input(umbrameter({"sweep", "study.toml", "--out", "a", "--width", "64"}), "2 qualities");
  expect_bad_input(umbrameter({"bench", "study.toml", "--csv", "runs.csv"}), "one study of one quality");
  const Json bench = json({"bench", "study.toml", "--frames", "2"});
  ASSERT_EQ(bench["studies"].size(), 2u);
  EXPECT_EQ(bench["studies"][1]["width_px"], 960);
}

TEST_F(SweepCommand, SlipsAreFoundFirst) {
  write_study();
  expect_bad_input(umbrameter({"sweep", "study.toml"}), "--out DIR");
  expect_bad_input(umbrameter({"sweep", "study.toml", "--out", "a", "--shard", "3/2"}), "'3/2' is not i/n");
  expect_bad_input(umbrameter({"export", "nowhere"}), "has no store.sqlite");
  expect_bad_input(umbrameter({"merge", "nowhere", "--out", "c"}), "has no store.sqlite");
  EXPECT_FALSE(std::filesystem::exists(folder() / "c"));
}

}  // namespace
}  // namespace umbrameter
