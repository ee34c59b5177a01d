#include "study/regress/prove.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

/// Written and read again, as between a record and a check.
CaseNumbers through_text(const CaseNumbers& numbers) {
  BaselineScene scene = {"scene", "", {}, {}};
  put_run(scene, {"run", "", "", "", "", numbers, {}});
  const Baseline baseline = {"proof", 1, 1, {}, {scene}};
  return parse_baseline(to_toml_text(baseline), "baseline.toml").scenes.front().runs.front().numbers;
}

CaseVerdict judge_void(const GateRun& run) {
  const GateVerdict gate = judge_gate(run, nullptr, false);
  if (!gate.measures.empty() || !gate.kind) return {};
  return {CaseOutcome::fail, std::string(name_of(*gate.kind)), std::string(name_of(*gate.kind)), gate};
}

CaseVerdict judge_trial(const Trial& trial, Stage& stage, const RegressGates& gates) {
  GateRun run;
  run.failure = trial.failure;
  if (!run.failure)
    run = examine(trial.picture, trial.truth ? *trial.truth : stage.truth(), stage.eye_world(), trial.metric)
              .run;
  const CaseVerdict voided = judge_void(run);
  if (!voided.kind.empty()) return voided;
  const GateRun& before = trial.baseline ? stage.examined(*trial.baseline).run : stage.examined_exact().run;
  const auto now = case_numbers(run), then = case_numbers(before);
  UMBRAMETER_ASSERT(now && then, "a trial of '{}' has no numbers", stage.name());
  return judge_case(*now, through_text(*then), gates);
}

}  // namespace

bool ProvedFault::is_named() const {
  return std::ranges::any_of(right, [&](GateClass kind) { return name_of(kind) == verdict.kind; });
}

std::vector<ProvedFault> prove_faults(std::span<const SceneJob> jobs, const SelftestSettings& settings,
                                      SelftestRenderers renderers, const RegressGates& gates,
                                      Progress& progress) {
  std::vector<ProvedFault> proved;
  SilentProgress silent;
  progress.begin("faults", jobs.size());
  for (const SceneJob& job : jobs) {
    Stage stage(job, settings, renderers, silent);
    for (const FaultCase& fault : fault_list()) {
      if (fault.scene != job.name) continue;
      proved.push_back({fault.name, fault.scene, fault.right, judge_trial(fault.make(stage), stage, gates)});
    }
    progress.advance(1);
  }
  progress.end();
  return proved;
}

std::string proof_markdown(std::span<const ProvedFault> faults) {
  std::string text = "| fault | scene | verdict | |\n|---|---|---|---|\n";
  size_t found = 0, named = 0;
  for (const ProvedFault& fault : faults) {
    const char* mark = fault.is_named() ? "" : fault.is_found() ? "other class" : "missed";
    text += fmt::format("| {} | {} | {} | {} |\n", fault.name, fault.scene,
                        fault.verdict.kind.empty() ? "pass" : fault.verdict.kind, mark);
    found += fault.is_found() ? 1 : 0;
    named += fault.is_named() ? 1 : 0;
  }
  return text + fmt::format("\nfound {} of {} faults, {} by their class\n", found, faults.size(), named);
}

}  // namespace umbrameter
