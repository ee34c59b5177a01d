// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep_text.h"

#include "cli/console.h"
#include "results/format.h"
#include "results/json/json_parts.h"
#include "results/json/schemas.h"
#include "results/judgement_format.h"
#include "scenes/altered/study_camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace umbrameter {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string duration_text(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.1f} s", seconds);
  if (seconds < 120.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

/// The totals of a plan.
struct Totals {
  std::map<StepAction, size_t> runs;
  size_t references = 0;  // rendered
  double estimated_s = 0.0, saved_s = 0.0;
  bool is_rough = false;  // an estimate rests on the rough model
};

Totals totals_of(std::span<const PlanStep> steps) {
  Totals totals;
  for (const PlanStep& step : steps) {
    const bool is_rendered = step.action == StepAction::render;
    if (step.run) ++totals.runs[step.action];
    if (!step.run && is_rendered) ++totals.references;
    totals.estimated_s += step.estimated_s;
    totals.saved_s += step.saved_s;
    totals.is_rough = totals.is_rough || (is_rendered && step.like == 0);
  }
  return totals;
}

std::string label_of(const SweepPlan& plan, const PlanStep& step) {
  if (!step.run) return "truth";
  const BenchRun& run = plan.runs[*step.run];
  return fmt::format("{} (seed {})", run.technique.label, run.seed);
}

/// Neighbours of one scene, action and reason.
struct StepGroup {
  const PlanStep& first;
  size_t count = 0;
  double seconds = 0.0;
};

std::vector<StepGroup> groups_of(std::span<const PlanStep> steps) {
  std::vector<StepGroup> groups;
  for (const PlanStep& step : steps) {
    const auto found = std::ranges::find_if(groups, [&](const StepGroup& group) {
      return group.first.scene == step.scene && group.first.run.has_value() == step.run.has_value() &&
             group.first.action == step.action && group.first.reason == step.reason;
    });
    StepGroup& group = found == groups.end() ? groups.emplace_back(StepGroup{step}) : *found;
    ++group.count;
    group.seconds += step.estimated_s + step.saved_s;
  }
  return groups;
}

size_t count_of(const SweepOutcome& outcome, Comparison verdict) {
  const auto found = outcome.verdicts.find(verdict);
  return found == outcome.verdicts.end() ? 0 : found->second;
}

/// "better (pcf)": against which run.
std::string verdict_text(const std::optional<RunVerdict>& verdict) {
  return verdict ? fmt::format("{} ({})", format_verdict(verdict), verdict->baseline) : "";
}

std::string run_count(size_t count, const char* what = "run") {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

std::string plan_text(const SweepPlan& plan, std::span<const StudyScene> scenes,
                      std::span<const PlanStep> steps) {
  std::vector<std::vector<std::string>> rows;
  for (const StepGroup& group : groups_of(steps)) {
    rows.push_back(
        {full_name(scenes[group.first.scene]),
         group.count == 1 ? label_of(plan, group.first) : run_count(group.count),
         std::string(to_text(group.first.action)), group.first.reason,
         (group.first.action == StepAction::render ? "" : "saves ") + duration_text(group.seconds)});
  }
  const Totals totals = totals_of(steps);
  const auto count = [&](StepAction action) {
    return totals.runs.contains(action) ? totals.runs.at(action) : 0;
  };
  return format_table({"scene", "what", "", "why", "time"}, rows) +
         fmt::format("\n{} and {} to render, about {}{}; {} reused, {} skipped, which saves about {}\n",
                     run_count(count(StepAction::render)), run_count(totals.references, "truth"),
                     duration_text(totals.estimated_s), totals.is_rough ? " (partly a rough guess)" : "",
                     count(StepAction::reuse), count(StepAction::skip), duration_text(totals.saved_s));
}

OrderedJson plan_json(const SweepPlan& plan, std::span<const StudyScene> scenes,
                      std::span<const PlanStep> steps) {
  OrderedJson list = OrderedJson::array();
  for (const PlanStep& step : steps) {
    OrderedJson json{{"action", to_text(step.action)},
                     {"scene", scenes[step.scene].name},
                     {"camera", scenes[step.scene].camera},
                     {"label", nullptr},
                     {"seed", nullptr},
                     {"reason", step.reason},
                     {"estimated_s", step.estimated_s},
                     {"saved_s", step.saved_s},
                     {"like", step.like},
                     {"key", step.key}};
    if (step.run) json["label"] = plan.runs[*step.run].technique.label;
    if (step.run) json["seed"] = plan.runs[*step.run].seed;
    list.push_back(json);
  }
  const Totals totals = totals_of(steps);
  OrderedJson json{{"schema", kSweepSchema}};
  for (const StepAction action : {StepAction::render, StepAction::reuse, StepAction::skip})
    json[std::string(to_text(action))] = totals.runs.contains(action) ? totals.runs.at(action) : 0;
  json["render_references"] = totals.references;
  json["estimated_s"] = totals.estimated_s;
  json["saved_s"] = totals.saved_s;
  json["steps"] = list;
  return json;
}

std::string idle_text(std::span<const IdleParameter> idle, std::span<const StudyScene> scenes) {
  if (idle.empty()) return "\nevery parameter that the study varies changes a small picture\n";
  std::vector<std::vector<std::string>> rows;
  for (const IdleParameter& one : idle)
    rows.push_back({full_name(scenes[one.scene]), one.technique, one.parameter, run_count(one.runs),
                    duration_text(one.saved_s)});
  return fmt::format("\nno pixel of {} x {} changes with\n", kScreenWidth_px, kScreenHeight_px) +
         format_table({"scene", "technique", "parameter", "varied by", "which cost"}, rows);
}

OrderedJson idle_json(std::span<const IdleParameter> idle, std::span<const StudyScene> scenes) {
  OrderedJson list = OrderedJson::array();
  for (const IdleParameter& one : idle)
    list.push_back({{"scene", scenes[one.scene].name},
                    {"camera", scenes[one.scene].camera},
                    {"technique", one.technique},
                    {"parameter", one.parameter},
                    {"runs", one.runs},
                    {"saved_s", one.saved_s}});
  return list;
}

std::string outcome_text(const SweepOutcome& outcome) {
  std::string text =
      fmt::format("{} and {} rendered, {} reused, {} skipped", run_count(outcome.rendered),
                  run_count(outcome.references_rendered, "truth"), outcome.reused, outcome.skipped);
  if (outcome.not_done > 0) text += fmt::format(", {} not done without a truth", outcome.not_done);
  if (!outcome.failures.empty()) text += fmt::format("; {} failed", outcome.failures.size());
  if (outcome.verdicts.empty()) return text + "\n";
  return text +
         fmt::format("\nagainst each scene's first run: {} better, {} worse, {} the same, {} undecided\n",
                     count_of(outcome, Comparison::better), count_of(outcome, Comparison::worse),
                     count_of(outcome, Comparison::same), count_of(outcome, Comparison::cannot_tell));
}

OrderedJson outcome_json(const SweepOutcome& outcome) {
  OrderedJson failures = OrderedJson::array(), verdicts = OrderedJson::object();
  for (const Comparison verdict :
       {Comparison::better, Comparison::worse, Comparison::same, Comparison::cannot_tell})
    verdicts[std::string(name_of(verdict))] = count_of(outcome, verdict);
  for (const Failure& failure : outcome.failures) failures.push_back(failure_json(failure));
  return {{"schema", kSweepSchema},
          {"rendered", outcome.rendered},
          {"reused", outcome.reused},
          {"skipped", outcome.skipped},
          {"references_rendered", outcome.references_rendered},
          {"not_done", outcome.not_done},
          {"verdicts", verdicts},
          {"failures", failures}};
}

std::string stored_text(const StoredRuns& runs) {
  std::vector<const RunRecord*> ranked;
  for (const RunRecord& run : runs.runs) ranked.push_back(&run);
  const auto rmse = [](const RunRecord& run) {
    const bool has_one = run.result.error && run.result.error->rmse;
    return has_one ? run.result.error->rmse->value : std::numeric_limits<double>::infinity();
  };
  std::ranges::stable_sort(ranked, [&](const RunRecord* a, const RunRecord* b) {
    const auto picture = [](const RunRecord& run) { return std::tie(run.head.scene, run.head.camera); };
    return picture(*a) != picture(*b) ? picture(*a) < picture(*b) : rmse(*a) < rmse(*b);
  });
  std::vector<std::vector<std::string>> rows;
  for (const RunRecord* run : ranked) {
    const auto& error = run->result.error;
    const RecordHead& head = run->head;
    const auto time = total_time(run->result.pass_times);
    rows.push_back({full_name(head.scene, head.camera), run->result.label, std::to_string(head.picture.seed),
                    fmt::format("{} x {}", head.picture.width_px, head.picture.height_px),
                    format_interval(error ? error->rmse : std::nullopt),
                    verdict_text(run->result.judgement.verdict), time ? format_time(*time) : "",
                    status_of(*run)});
  }
  return format_table({"scene", "run", "seed", "px", "RMSE [95 %]", "verdict (against)", "time", "status"},
                      rows);
}

}  // namespace umbrameter
