// SPDX-License-Identifier: Apache-2.0
#include "study/grid/plan.h"

#include "lab/costs.h"
#include "lab/validated.h"
#include "results/json/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

namespace umbrameter {
namespace {

constexpr size_t kDateLength = 10;  // "2026-01-31"

struct Planner {
  const SweepPlan& plan;
  Store* store;
  Costs costs;
  std::map<std::string, std::string> planned;  // label by key, of this plan
};

void decide(PlanStep& step, StepAction action, const std::string& reason) {
  step.action = action;
  step.reason = reason;
  if (action != StepAction::render) std::swap(step.estimated_s, step.saved_s);
}

void decide_by_store(const Planner& planner, PlanStep& step) {
  if (!planner.plan.reuse) return decide(step, StepAction::render, "reuse is off");
  if (planner.store == nullptr) return decide(step, StepAction::render, "not stored");
  const StoredRun stored = find_run(*planner.store, step.key, planner.plan.timing);
  if (!stored.record) return decide(step, StepAction::render, stored.lack);
  const std::string date = stored.record->head.started.substr(0, kDateLength);
  decide(step, StepAction::reuse,
         fmt::format("{} on {}", stored.record->result.failure ? "failed for good" : "stored", date));
}

PlanStep plan_run(Planner& planner, const StudyScene& job, const std::string& reference, size_t index) {
  const BenchRun& run = planner.plan.runs[index];
  PlanStep step;
  step.run = index;
  step.key = run_key(reference, run.technique, run.seed, planner.plan.metrics, planner.plan.makers);
  const Estimate estimate =
      estimate_run(planner.costs, run.technique.id, planner.plan.picture, planner.plan.timing);
  step.estimated_s = estimate.seconds;
  step.like = estimate.like;
  const auto [twin, is_new] = planner.planned.emplace(step.key, run.technique.label);
  if (const auto reason = skip_reason(run.technique, job.scene)) {
    decide(step, StepAction::skip, *reason);
  } else if (!is_new) {
    decide(step, StepAction::skip, fmt::format("the same as '{}'", twin->second));
  } else {
    decide_by_store(planner, step);
  }
  return step;
}

PlanStep plan_reference(const Planner& planner, const std::string& key, const std::vector<PlanStep>& runs) {
  PlanStep step;
  step.key = key;
  const Estimate estimate = estimate_reference(planner.costs, planner.plan.picture);
  step.estimated_s = estimate.seconds;
  step.like = estimate.like;
  const bool is_needed =
      std::ranges::any_of(runs, [](const PlanStep& run) { return run.action == StepAction::render; });
  if (!is_needed) {
    decide(step, StepAction::skip, "no run needs it");
  } else if (!planner.plan.reuse) {
    decide(step, StepAction::render, "reuse is off");
  } else {
    const bool is_stored = planner.store != nullptr && planner.store->find(key).has_value();
    decide(step, is_stored ? StepAction::reuse : StepAction::render, is_stored ? "stored" : "not stored");
  }
  return step;
}

std::optional<size_t> whole_number(std::string_view text) {
  size_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

size_t baseline_of(const SweepPlan& plan, const Scene& scene, size_t run) {
  for (size_t i = 0; i < run; ++i) {
    const BenchRun& earlier = plan.runs[i];
    if (earlier.seed == plan.runs[run].seed && !skip_reason(earlier.technique, scene)) return i;
  }
  return run;
}

std::string_view to_text(StepAction action) {
  constexpr std::array<std::string_view, 3> kActions{"render", "reuse", "skip"};
  return kActions[static_cast<size_t>(action)];
}

Shard parse_shard(const std::string& text) {
  constexpr size_t kMaxShards = 1 << 20;
  const size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto number = whole_number(std::string_view(text).substr(0, slash));
    const auto count = whole_number(std::string_view(text).substr(slash + 1));
    if (number && count && *number >= 1 && *number <= *count && *count <= kMaxShards)
      return {*number - 1, *count};
  }
  fail_input(fmt::format("the shard '{}' is not i/n", text), {}, "the second of four parts is 2/4");
}

std::vector<PlanStep> plan_sweep(const SweepPlan& plan, std::span<const StudyScene> scenes, Store* store) {
  Planner planner{plan, store, costs_of(store), {}};
  const size_t pairs = scenes.size() * plan.runs.size();
  const size_t first = pairs * plan.shard.index / plan.shard.count;
  const size_t end = pairs * (plan.shard.index + 1) / plan.shard.count;
  std::vector<PlanStep> steps;
  for (size_t scene = 0; scene < scenes.size(); ++scene) {
    const std::string reference = reference_key(scenes[scene].scene, plan.picture, plan.makers);
    std::vector<PlanStep> runs;
    for (size_t run = 0; run < plan.runs.size(); ++run) {
      const size_t pair = scene * plan.runs.size() + run;
      if (pair >= first && pair < end) runs.push_back(plan_run(planner, scenes[scene], reference, run));
    }
    if (runs.empty()) continue;
    steps.push_back(plan_reference(planner, reference, runs));
    steps.back().scene = scene;
    for (PlanStep& step : runs) {
      step.scene = scene;
      steps.push_back(std::move(step));
    }
  }
  return steps;
}

}  // namespace umbrameter
