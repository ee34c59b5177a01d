// SPDX-License-Identifier: Apache-2.0
// Without these a sweep could show a number of another scene, repeat work, or lose the runs after one that fails.

#include "tests/support/lab/fakes.h"
#include "tests/support/temporary_folder.h"

#include "core/files.h"
#include "lab/keys.h"
#include "lab/merge.h"
#include "lab/stored_results.h"
#include "lab/stored_runs.h"
#include "lab/verdicts.h"
#include "report/report.h"
#include "results/json/export.h"
#include "study/grid/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

StudyScene study_scene(const std::string& name) {
  return {name, fake_scene(name).scene};
}

class SweepTest : public testing::Test {
 protected:
  SweepTest() {
    scenes_[1].scene.hash = "another";
    for (const char* id : {"exact", "off", "broken"}) plan_.runs.push_back({fake_technique(id), 1});
    plan_.runs.push_back({fake_technique("sun-only", {LightType::sun}), 1});
    for (BenchRun& run : plan_.runs) run.technique.hash = run.technique.id;  // folders that differ
    plan_.picture = {kFakeWidth_px, kFakeHeight_px, 64, {}, 1};
    plan_.makers = {"fake tracer", "fake device", "feed"};
    create_folder(scratch());
  }
  std::filesystem::path folder(const std::string& name = "store") const { return temporary_.path() / name; }
  std::filesystem::path scratch() const { return temporary_.path() / "scratch"; }

  std::vector<PlanStep> plan(const std::string& name = "store") const {
    Store store(folder(name), Database::Mode::write);
    return plan_sweep(plan_, scenes_, &store);
  }
  SweepOutcome sweep(const std::string& name = "store") {
    Store store(folder(name), Database::Mode::write);
    const auto steps = plan_sweep(plan_, scenes_, &store);
    return run_sweep(plan_, scenes_, steps, {reference_, realtime_}, store, scratch(), progress_);
  }
  StoredRuns stored(const std::string& name = "store", bool all = false) const {
    Store store(folder(name), Database::Mode::read);
    return stored_runs(store, all);
  }

  TemporaryFolder temporary_;
  std::vector<StudyScene> scenes_{study_scene("plate"), study_scene("wall")};
  SweepPlan plan_;
  FakeRenderer reference_ = fake_reference();
  FakeRenderer realtime_ = fake_realtime();
  SilentProgress progress_;
};

std::vector<std::string> actions(const std::vector<PlanStep>& steps) {
  std::vector<std::string> texts;
  for (const PlanStep& step : steps) texts.emplace_back(to_text(step.action));
  return texts;
}

TEST_F(SweepTest, RendersOnceAndRecordsFailures) {
  const SweepOutcome first = sweep();
  EXPECT_EQ(first.rendered, 6u);
  EXPECT_EQ(first.skipped, 2u);
  EXPECT_EQ(first.references_rendered, 2u);
  ASSERT_EQ(first.failures.size(), 2u);
  EXPECT_THAT(first.failures[0].message,
              HasSubstr("plate, broken: broken/resolve.frag:7:3: does not compile"));
  EXPECT_EQ(reference_.requests.size(), 2u);
  EXPECT_EQ(realtime_.requests.size(), 6u);
  const StoredRuns runs = stored();
  ASSERT_EQ(runs.runs.size(), 6u);
  EXPECT_EQ(status_of(runs.runs[0]), "failed");
  EXPECT_NEAR(runs.runs[1].result.error->rmse->value, 0.0, 1e-6);
  EXPECT_NEAR(runs.runs[2].result.error->rmse->value, 0.1 * std::sqrt(19.0 / 39.0), 1e-3);

  const SweepOutcome second = sweep();
  EXPECT_EQ(second.rendered, 0u);
  EXPECT_EQ(second.reused, 6u);
  EXPECT_EQ(second.failures.size(), 2u);
  EXPECT_EQ(reference_.requests.size(), 2u);
  EXPECT_EQ(realtime_.requests.size(), 6u);
}

TEST_F(SweepTest, AStoreIsShownAsResultsWithEachRunAndItsVerdict) {
  Store empty(folder("empty"), Database::Mode::write);
  EXPECT_FALSE(stored_results(empty).has_value());
  sweep();
  Store store(folder(), Database::Mode::read);
  const auto results = stored_results(store);
  ASSERT_TRUE(results.has_value());
  ASSERT_EQ(results->scenes.size(), 2u);
  EXPECT_EQ(results->scenes[0].name, "plate");
  ASSERT_EQ(results->scenes[0].techniques.size(), 3u);
  EXPECT_TRUE(results->scenes[0].techniques[0].failure.has_value());
  const TechniqueResult& off = results->scenes[0].techniques[2];
  EXPECT_EQ(off.label, "off");
  EXPECT_EQ(off.error->rmse->value, stored().runs[2].result.error->rmse->value);
  EXPECT_EQ(off.judgement.verdict->baseline, "exact");
  ASSERT_TRUE(results->scenes[0].reference.has_value());
  for (const std::string& file : {off.image_file, results->scenes[0].reference->image_file})
    EXPECT_TRUE(std::filesystem::exists(folder() / file)) << file;
  write_report(folder(), folder() / "report.html");
  EXPECT_THAT(read_file(folder() / "report.html"), HasSubstr("id=\"s0-r2\""));  // with its pixels
}

TEST_F(SweepTest, PlanSaysWhatAndWhy) {
  plan_.runs.push_back(plan_.runs[0]);
  plan_.runs.back().technique.label = "again";
  const auto fresh = plan();
  EXPECT_THAT(actions({fresh.begin(), fresh.begin() + 6}),
              ElementsAre("render", "render", "render", "render", "skip", "skip"));
  EXPECT_THAT(fresh[4].reason, HasSubstr("does not support rect lights"));
  EXPECT_EQ(fresh[5].reason, "the same as 'exact'");
  EXPECT_GT(fresh[0].estimated_s, 0.0);
  EXPECT_EQ(fresh[0].like, 0u);
  EXPECT_GT(fresh[4].saved_s, 0.0);
  sweep();
  const auto later = plan();
  EXPECT_THAT(actions({later.begin(), later.begin() + 6}),
              ElementsAre("skip", "reuse", "reuse", "reuse", "skip", "skip"));
  EXPECT_EQ(later[0].reason, "no run needs it");
  EXPECT_EQ(later[1].like, 2u);
  plan_.reuse = false;
  EXPECT_EQ(actions(plan())[1], "render");
}

TEST_F(SweepTest, AnAlteredImageIsMadeAgainAndItsTruthReused) {
  sweep();
  std::string image;
  for (const RunRecord& run : stored().runs) {
    if (run.result.technique == "off" && run.head.scene == "plate") image = run.result.image_file;
  }
  std::ofstream(folder() / image, std::ios::app) << "x";
  // Both scenes' images of "off" are the same file.
  const SweepOutcome outcome = sweep();
  EXPECT_EQ(outcome.rendered, 2u);
  EXPECT_EQ(outcome.references_rendered, 0u);
  EXPECT_EQ(reference_.requests.size(), 2u);
}

TEST_F(SweepTest, FailuresOfTheMachineAreTriedAgain) {
  bool is_short_of_memory = true;
  FakeRenderer moody([&](const RenderRequest&) {
    if (is_short_of_memory) throw std::bad_alloc();
    return frame_of(technique_image(0.0f));
  });
  plan_.runs.resize(1);
  scenes_.resize(1);
  const auto run = [&] {
    Store store(folder(), Database::Mode::write);
    const auto steps = plan_sweep(plan_, scenes_, &store);
    return run_sweep(plan_, scenes_, steps, {reference_, moody}, store, scratch(), progress_);
  };
  EXPECT_EQ(run().failures.size(), 1u);
  EXPECT_THAT(plan()[1].reason, HasSubstr("failed before: not enough memory"));
  is_short_of_memory = false;
  EXPECT_TRUE(run().failures.empty());
  EXPECT_EQ(status_of(stored().runs.at(0)), "ok");
}

TEST_F(SweepTest, AFailedTruthLeavesItsRunsUndone) {
  FakeRenderer blind([](const RenderRequest&) -> Frame { fail_input("no light"); });
  Store store(folder(), Database::Mode::write);
  const auto steps = plan_sweep(plan_, scenes_, &store);
  const SweepOutcome outcome =
      run_sweep(plan_, scenes_, steps, {blind, realtime_}, store, scratch(), progress_);
  EXPECT_EQ(outcome.not_done, 6u);
  EXPECT_EQ(outcome.rendered, 0u);
  ASSERT_EQ(outcome.failures.size(), 2u);
  EXPECT_EQ(outcome.failures[0].message, "plate: no light");
  EXPECT_EQ(blind.requests.size(), 2u);
}

TEST_F(SweepTest, AStoreThatTakesNothingEndsTheSweep) {
  { const Store store(folder(), Database::Mode::write); }
  write_file_atomically(folder() / "objects", "in the way");
  EXPECT_THROW(sweep(), Error);
  EXPECT_TRUE(stored().runs.empty());
}

TEST_F(SweepTest, PartsMergedAreTheWhole) {
  sweep("whole");
  for (const size_t part : {0u, 1u, 2u}) {
    plan_.shard = {part, 3};
    sweep("part" + std::to_string(part));
  }
  {
    Store merged(folder("merged"), Database::Mode::write);
    for (const char* name : {"part0", "part1", "part2"}) {
      Store part(folder(name), Database::Mode::read);
      merge_store(part, merged);
    }
  }
  const auto numbers = [&](const std::string& name) {
    std::vector<std::string> texts;
    StoredRuns runs = stored(name);
    for (RunRecord& run : runs.runs) {
      run.head.started = "";
      run.head.duration_s = 0.0;
      texts.push_back(to_json_text(run));
    }
    return texts;
  };
  EXPECT_EQ(numbers("merged").size(), 6u);
  EXPECT_EQ(numbers("merged"), numbers("whole"));
  plan_.shard = {};
  EXPECT_EQ(sweep("merged").rendered, 0u);
}

TEST_F(SweepTest, ACameraIsAPictureOfItsOwn) {
  scenes_.resize(1);
  scenes_.push_back(scenes_[0]);
  scenes_[1].camera = "left";
  scenes_[1].scene.hash = "from the left";
  plan_.runs.resize(2);
  EXPECT_EQ(sweep().rendered, 4u);
  const StoredRuns runs = stored();
  ASSERT_EQ(runs.runs.size(), 4u);
  EXPECT_EQ(runs.older, 0u);
  EXPECT_EQ(runs.runs[0].head.camera, "");
  EXPECT_EQ(runs.runs[2].head.camera, "left");
  EXPECT_EQ(runs.runs[2].head.scene, "plate");
  EXPECT_THAT(to_csv(runs), HasSubstr("\nplate,left,from the left,"));
  EXPECT_EQ(full_name(scenes_[1]), "plate, left");
}

TEST_F(SweepTest, VerdictsComeFromStoredImages) {
  std::swap(plan_.runs[0], plan_.runs[1]);  // "off" is first
  plan_.runs.push_back(plan_.runs[0]);
  plan_.runs.back().technique.label = "as far off";
  plan_.runs.back().technique.parameters["taps"] = int64_t{17};
  scenes_.resize(1);
  realtime_ = FakeRenderer([](const RenderRequest& request) {  // wrong everywhere, so that no place disagrees
    Image image = technique_image(0.0f);
    if (request.technique == "broken") fail_input("does not compile");
    if (request.technique == "off") std::ranges::fill(image.plane("visibility"), 0.6f);
    Frame frame = frame_of(std::move(image));
    frame.parameters = request.parameters;
    return frame;
  });
  const SweepOutcome outcome = sweep();
  EXPECT_EQ(outcome.verdicts.at(Comparison::better), 1u);
  EXPECT_EQ(outcome.verdicts.at(Comparison::same), 1u);
  const auto verdicts = [&](const std::string& baseline) {
    StoredRuns runs = stored();
    Store store(folder(), Database::Mode::read);
    judge_runs(store, runs.runs, baseline);
    std::map<std::string, std::string> found;
    for (const RunRecord& run : runs.runs) {
      const auto& verdict = run.result.judgement.verdict;
      found[run.result.label] =
          verdict ? std::string(name_of(verdict->outcome)) + " " + verdict->baseline : "";
    }
    return found;
  };
  using Verdicts = std::map<std::string, std::string>;
  EXPECT_EQ(verdicts(""),
            (Verdicts{{"off", ""}, {"exact", "better off"}, {"broken", ""}, {"as far off", "same off"}}));
  EXPECT_EQ(verdicts("exact"),
            (Verdicts{{"off", "worse exact"}, {"exact", ""}, {"broken", ""}, {"as far off", "worse exact"}}));
  EXPECT_EQ(verdicts("nobody")["exact"], "");
}

TEST_F(SweepTest, TimesAreTakenBesideTheFirstRunAndJoinAStoredResult) {
  scenes_.resize(1);
  realtime_.time_frame = [](const RenderRequest& request, int) {
    return std::vector<double>{request.technique == "off" ? 3.0 : 1.0, 1.0};
  };
  sweep("untimed");
  sweep();
  plan_.timing = TimingPlan{.wanted_frames = 7, .budget_s = 1.0};
  const auto steps = plan();
  EXPECT_EQ(steps[1].reason, "stored without times");
  EXPECT_EQ(steps[3].action, StepAction::reuse);  // broken for good
  EXPECT_EQ(sweep().rendered, 2u);
  EXPECT_EQ(sweep().rendered, 0u);
  const auto of = [](const StoredRuns& runs, const std::string& label) {
    return *std::ranges::find(runs.runs, label, [](const RunRecord& run) { return run.result.label; });
  };
  const RunRecord first = of(stored(), "exact"), off = of(stored(), "off");
  EXPECT_EQ(total_time(first.result.pass_times)->median_ms, 2.0);
  EXPECT_TRUE(first.baseline.empty() && first.baseline_times.empty());
  EXPECT_EQ(total_time(off.result.pass_times)->median_ms, 4.0);
  EXPECT_EQ(total_time(off.result.pass_times)->frames, 7);
  EXPECT_EQ(total_time(off.baseline_times)->median_ms, 2.0);
  EXPECT_EQ(off.result.timer, "fake clock");
  EXPECT_THAT(to_csv(stored()), HasSubstr(",4,4194304,0,7,2,fake clock,"));

  RunRecord without = off;
  without.result.pass_times.clear();
  without.baseline_times.clear();
  without.result.timer.clear();
  without.head = of(stored("untimed"), "off").head;
  EXPECT_EQ(to_json_text(without), to_json_text(of(stored("untimed"), "off")));

  Store untimed(folder("untimed"), Database::Mode::write), timed(folder(), Database::Mode::write);
  EXPECT_EQ(merge_store(timed, untimed).added, 2u);
  EXPECT_EQ(merge_store(untimed, timed).added, 0u);
}

TEST_F(SweepTest, ShardsAreWholeAndDisjoint) {
  std::vector<std::string> all, parts;
  const auto add = [&](std::vector<std::string>& keys) {
    for (const PlanStep& step : plan()) {
      if (step.run) keys.push_back(step.key);
    }
  };
  add(all);
  for (size_t part = 0; part < 5; ++part) {
    plan_.shard = {part, 5};
    add(parts);
  }
  EXPECT_EQ(parts, all);
  EXPECT_EQ(parse_shard("2/4").index, 1u);
  for (const char* wrong : {"0/4", "5/4", "2", "a/b", "1/2x", "-1/2", ""})
    EXPECT_THROW(parse_shard(wrong), Error) << wrong;
}

TEST_F(SweepTest, ResultsOfOtherCodeAreOlder) {
  sweep();
  plan_.makers.realtime = "another driver";
  EXPECT_EQ(sweep().rendered, 6u);
  EXPECT_EQ(reference_.requests.size(), 2u);
  EXPECT_EQ(stored().runs.size(), 6u);
  EXPECT_EQ(stored().older, 6u);
  EXPECT_EQ(stored("store", true).runs.size(), 12u);
}

TEST_F(SweepTest, CsvHasAColumnForEachParameter) {
  plan_.runs[1].technique.parameters["bias_texels"] = 1.5;
  sweep();
  const std::string csv = to_csv(stored());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 7);
  EXPECT_THAT(csv.substr(0, csv.find('\n')),
              HasSubstr(",parameter.bias_texels,parameter.fit,parameter.radius_texels,parameter.taps"));
  EXPECT_THAT(csv, HasSubstr(",1.5,visible,2.5,16\n"));
  EXPECT_THAT(csv, HasSubstr(",,visible,2.5,16\n"));
}

TEST_F(SweepTest, KeysHoldWhatChangesTheNumberAndNothingElse) {
  const PictureQuality quality = plan_.picture;
  const Makers makers = plan_.makers;
  const TechniqueRun run = fake_technique("exact");
  const auto key = [&](const Scene& scene, const PictureQuality& with, const TechniqueRun& technique,
                       uint64_t seed, const Makers& made_by, bool diagnosis = true) {
    MetricChoice metrics;
    metrics.diagnosis = diagnosis;
    return run_key(reference_key(scene, with, made_by), technique, seed, metrics, made_by);
  };
  const Scene scene = scenes_[0].scene;
  std::vector<std::string> keys{
      key(scene, quality, run, 1, makers), key(scenes_[1].scene, quality, run, 1, makers),
      key(scene, quality, run, 2, makers), key(scene, quality, run, 1, makers, false)};
  Scene other_light = scene;
  other_light.lights.push_back(scene.light());
  other_light.active_light = 1;
  keys.push_back(key(other_light, quality, run, 1, makers));
  for (const auto change :
       {&PictureQuality::width_px, &PictureQuality::height_px, &PictureQuality::samples_per_pixel}) {
    PictureQuality changed = quality;
    changed.*change += 1;
    keys.push_back(key(scene, changed, run, 1, makers));
  }
  PictureQuality changed = quality;
  changed.target_se = 0.01;
  keys.push_back(key(scene, changed, run, 1, makers));
  changed = quality;
  changed.seed = 2;
  keys.push_back(key(scene, changed, run, 1, makers));
  for (const auto change : {&Makers::reference, &Makers::realtime, &Makers::shaders}) {
    Makers others = makers;
    others.*change += "!";
    keys.push_back(key(scene, quality, run, 1, others));
  }
  TechniqueRun edited = run;
  edited.hash = "beef";
  keys.push_back(key(scene, quality, edited, 1, makers));
  for (const ParameterValue& value :
       {ParameterValue(int64_t{17}), ParameterValue(16.0), ParameterValue(std::string("16"))}) {
    edited = run;
    edited.parameters["taps"] = value;
    keys.push_back(key(scene, quality, edited, 1, makers));
  }
  std::ranges::sort(keys);
  EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end());

  TechniqueRun renamed = run;
  renamed.label = "another label";
  renamed.technique = "/elsewhere/exact";
  Scene retitled = scene;
  retitled.name = retitled.title = "another title";
  EXPECT_EQ(key(retitled, quality, renamed, 1, makers), key(scene, quality, run, 1, makers));
}

}  // namespace
}  // namespace umbrameter
