// SPDX-License-Identifier: Apache-2.0
#include "study/regress/run.h"

#include "lab/renamed_progress.h"
#include "results/regress/parameter_changes.h"
#include "study/regress/scene_work.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

constexpr size_t kPicturesPerFailure = 3;  // pictures of a technique that a failure must hold for

CaseVerdict judge(const Measured& measured, const RunWork& run, const BaselineRun& before,
                  const RegressGates& gates, bool is_same_device) {
  if (measured.voided) return *measured.voided;
  CaseVerdict verdict = judge_case(*measured.numbers, before.numbers, gates);
  const bool has_times = gates.time_ratio && is_same_device && run.described.time && before.time;
  if (verdict.outcome == CaseOutcome::fail || !has_times) return verdict;
  if (const auto late = judge_time(*run.described.time, *before.time, *gates.time_ratio)) return *late;
  return verdict;
}

std::optional<CaseVerdict> cannot_compare(const SceneJob& job, const BaselineScene* scene,
                                          const RunWork& run) {
  const std::string& label = run.described.label;
  if (scene == nullptr)
    return not_compared("missing",
                        fmt::format("the baseline has no scene '{}' (take it in with --update)", job.name));
  if (scene->hash != job.scene.hash)
    return not_compared("scene",
                        fmt::format("the scene is another: its hash was {} and is {}, so numbers of before "
                                    "say nothing (accept it with --update)",
                                    scene->hash, job.scene.hash));
  if (scene->find(label) != nullptr) return std::nullopt;
  return not_compared(
      "missing", fmt::format("the baseline has no '{}' of this scene (take it in with --update)", label));
}

bool is_settled(const CaseVerdict& verdict, const RegressGates& gates) {
  if (verdict.outcome == CaseOutcome::better && gates.ratchet)
    return false;  // to be sure before it is taken over
  return verdict.outcome == CaseOutcome::pass;
}

void add_notes(const BaselineRun& before, RegressCase& out) {
  const BaselineRun& now = *out.now;
  if (before.parameters != now.parameters)
    out.notes.push_back(fmt::format("the run is another: {} (accept it with --update)",
                                    parameter_changes(before.parameters, now.parameters)));
  if (before.hash != now.hash) out.notes.push_back("the technique's manifest or shaders have changed");
  if (before.device != now.device)
    out.notes.push_back(
        fmt::format("the device was '{}' and is '{}'; times are not compared", before.device, now.device));
}

RegressCase check_run(const SceneWork& work, RunWork& run, const BaselineScene* scene, Truth& truth) {
  RegressCase out;
  out.scene = work.job.name;
  out.label = run.described.label;
  if (scene != nullptr && scene->find(out.label) != nullptr) out.before = *scene->find(out.label);
  const auto hopeless = cannot_compare(work.job, scene, run);
  const double seed_sd = out.before ? out.before->numbers.seed_sd : 0.0;
  int wanted = work.plan.picture.samples_per_pixel;
  Measured measured;
  while (true) {
    truth.grow_to(wanted);
    measured = measure(work, run, truth, seed_sd);
    if (hopeless && !measured.voided) {
      out.verdict = *hopeless;
      break;
    }
    const bool is_same_device = out.before && out.before->device == run.described.device;
    out.verdict =
        out.before ? judge(measured, run, *out.before, work.plan.gates, is_same_device) : *measured.voided;
    const bool is_out_of_budget =
        truth.samples() >= work.plan.most_samples_per_pixel && run.seeds >= kPicturesPerFailure;
    if (is_settled(out.verdict, work.plan.gates) || measured.voided || is_out_of_budget) break;
    run.seeds = std::min(run.seeds + 1, kPicturesPerFailure);
    wanted = std::min(2 * truth.samples(), work.plan.most_samples_per_pixel);
  }
  out.samples_per_pixel = truth.samples();
  out.added_samples_per_pixel = truth.samples() - work.plan.picture.samples_per_pixel;
  out.pictures = static_cast<int>(run.seeds);
  if (!measured.numbers) return out;
  out.now = run.described;
  out.now->numbers = *measured.numbers;
  if (out.before) add_notes(*out.before, out);
  return out;
}

void check_truth(const BaselineScene* before, const RegressScene& scene, const RegressGates& gates,
                 RegressResults& results) {
  if (before == nullptr || before->hash != scene.hash) return;
  const auto difference = truth_difference(scene.truth, before->truth, gates.sigmas);
  if (!difference) return;
  RegressCase out;
  out.scene = scene.name;
  out.label = kTruthLabel;
  out.verdict = not_compared("truth", "the truth is another although the scene is the same: " + *difference);
  results.cases.push_back(out);
}

std::vector<RegressCase> stale_cases(const RegressResults& results, const Baseline& baseline) {
  std::vector<RegressCase> stale;
  for (const BaselineScene& scene : baseline.scenes) {
    for (const BaselineRun& run : scene.runs) {
      const bool is_there = std::ranges::any_of(results.cases, [&](const RegressCase& one) {
        return one.scene == scene.name && one.label == run.label;
      });
      if (is_there) continue;
      RegressCase out;
      out.scene = scene.name;
      out.label = run.label;
      out.before = run;
      out.verdict = not_compared(
          "stale", "the baseline has it and the suite no longer renders it (drop it with --update)");
      stale.push_back(out);
    }
  }
  return stale;
}

RegressResults described(const RegressPlan& plan) {
  return {plan.suite, plan.picture.width_px, plan.picture.height_px, plan.picture.seed, {}, {}, {}};
}

void check_scene(const SceneWork& work, const Baseline& baseline, Truth& truth, RegressResults& results) {
  const BaselineScene* before = baseline.find(work.job.name);
  std::vector<RunWork> runs = choose_runs(work, results.skipped);
  truth.grow_to(work.plan.picture.samples_per_pixel);
  const RegressScene scene = {work.job.name, work.job.scene.hash, truth.numbers()};
  results.scenes.push_back(scene);
  check_truth(before, scene, work.plan.gates, results);
  for (RunWork& run : runs) results.cases.push_back(check_run(work, run, before, truth));
}

RegressCase measure_run(const SceneWork& work, RunWork& run, Truth& truth) {
  RegressCase out;
  out.scene = work.job.name;
  out.label = run.described.label;
  run.seeds = kPicturesPerFailure;
  Measured measured = measure(work, run, truth, {});
  out.samples_per_pixel = truth.samples();
  out.pictures = static_cast<int>(run.seeds);
  if (measured.voided) {
    out.verdict = *measured.voided;
    return out;
  }
  out.now = run.described;
  out.now->numbers = *measured.numbers;
  return out;
}

std::string prefix_of(const SceneJob& job, size_t index, size_t count) {
  return fmt::format("{} ({} of {}), ", job.name, index + 1, count);
}

/// `work_on(work, truth)` for every scene.
template <class WorkOn>
void for_each_scene(std::span<const SceneJob> scenes, const RegressPlan& plan,
                    const RegressRenderers& renderers, Progress& progress, const WorkOn& work_on) {
  for (size_t k = 0; k < scenes.size(); ++k) {
    const std::string prefix = prefix_of(scenes[k], k, scenes.size());
    RenamedProgress renamed(progress, [&](std::string_view task) { return prefix + std::string(task); });
    const SceneWork work = {scenes[k], plan, renderers, renamed};
    Truth truth(work);
    work_on(work, truth);
  }
}

}  // namespace

RegressResults check_suite(std::span<const SceneJob> scenes, const RegressPlan& plan,
                           const Baseline& baseline, const RegressRenderers& renderers, Progress& progress) {
  if (baseline.width_px != plan.picture.width_px || baseline.height_px != plan.picture.height_px) {
    fail_input(fmt::format("the baseline is of {} x {} px and the suite of {} x {}", baseline.width_px,
                           baseline.height_px, plan.picture.width_px, plan.picture.height_px),
               {}, "record it again with 'regress record --reason TEXT'");
  }
  RegressResults results = described(plan);
  for_each_scene(scenes, plan, renderers, progress,
                 [&](const SceneWork& work, Truth& truth) { check_scene(work, baseline, truth, results); });
  for (RegressCase& stale : stale_cases(results, baseline)) results.cases.push_back(std::move(stale));
  return results;
}

RegressResults measure_suite(std::span<const SceneJob> scenes, const RegressPlan& plan,
                             const RegressRenderers& renderers, Progress& progress) {
  RegressResults results = described(plan);
  for_each_scene(scenes, plan, renderers, progress, [&](const SceneWork& work, Truth& truth) {
    std::vector<RunWork> runs = choose_runs(work, results.skipped);
    truth.grow_to(plan.most_samples_per_pixel);
    results.scenes.push_back({work.job.name, work.job.scene.hash, truth.numbers()});
    for (RunWork& run : runs) results.cases.push_back(measure_run(work, run, truth));
  });
  return results;
}

}  // namespace umbrameter
