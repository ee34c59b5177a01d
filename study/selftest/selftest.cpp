// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/selftest.h"

#include "metrics/judgement.h"
#include "results/catalogue.h"
#include "results/metadata.h"
#include "results/pictures/pictures.h"
#include "study/selftest/kept_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

struct Judged {
  GateVerdict verdict;
  Examined examined;
};

bool is_worse(const Trial& trial, const Examined& candidate, const Image& truth, Stage& stage) {
  const Examined& baseline = stage.examined(*trial.baseline);
  if (candidate.mask.empty() || baseline.mask.empty()) return false;
  const auto verdict = judge_against({trial.picture, candidate.mask},
                                     {stage.picture(*trial.baseline), baseline.mask}, "baseline", truth);
  return verdict && verdict->outcome == Comparison::worse;
}

Judged judge(const Trial& trial, Stage& stage) {
  Judged out;
  if (trial.failure) {
    out.examined.run.failure = trial.failure;
    out.verdict = judge_gate(out.examined.run, nullptr, false, gate_limits());
    return out;
  }
  const Image& truth = trial.truth ? *trial.truth : stage.truth();
  out.examined = examine(trial.picture, truth, stage.eye_world(), trial.metric);
  if (!trial.baseline) {
    out.verdict = judge_gate(out.examined.run, nullptr, false, gate_limits());
    return out;
  }
  out.verdict = judge_gate(out.examined.run, &stage.examined(*trial.baseline).run,
                           is_worse(trial, out.examined, truth, stage), gate_limits());
  return out;
}

// The picture and its faults, as <name>.png and <name>-faults.png.
void keep_pictures(const std::string& name, const Trial& trial, const Judged& judged, const Stage& stage) {
  const std::filesystem::path& folder = stage.settings().pictures_folder;
  if (folder.empty() || trial.failure) return;
  const std::string stem = file_name_of(stage.name() + ", " + name + ", " + text_of(stage.round()));
  write_picture(folder / (stem + ".png"), visibility_picture(trial.picture));
  if (judged.examined.fault_classes.empty()) return;
  write_picture(folder / (stem + "-faults.png"),
                fault_picture(judged.examined.fault_classes, trial.picture.width, trial.picture.height));
}

GateVerdict judge_and_keep(const std::string& name, const Trial& trial, Stage& stage) {
  Judged judged = judge(trial, stage);
  keep_pictures(name, trial, judged, stage);
  return std::move(judged.verdict);
}

std::optional<MaskOutcome> count_mask(const MaskCase& mask, Stage& stage) {
  const Trial trial = mask.make(stage);
  if (std::ranges::count(trial.injected, uint8_t{1}) == 0) return std::nullopt;
  const Judged judged = judge(trial, stage);
  keep_pictures(mask.name, trial, judged, stage);
  MaskOutcome out = {mask.name, stage.name(), stage.round(), mask.fault};
  for (size_t i = 0; i < trial.injected.size(); ++i) {
    const bool is_painted = trial.injected[i] != 0;
    const bool is_found =
        !judged.examined.fault_classes.empty() && judged.examined.fault_classes[i] == mask.fault;
    out.painted += is_painted ? 1 : 0;
    out.found += is_found ? 1 : 0;
    out.both += is_painted && is_found ? 1 : 0;
  }
  return out;
}

/// What is asked of every scene.
struct Suite {
  std::vector<FaultCase> faults;
  std::vector<BenignVariant> variants;
  std::vector<MaskCase> masks;
  std::vector<CauseCase> causes;
};

Suite suite_of(const SelftestSettings& settings) {
  Suite suite;
  if (settings.parts.benign) {
    suite.variants = benign_list();
    suite.masks = mask_list();
  }
  if (settings.parts.faults) suite.faults = fault_list();
  if (settings.parts.causes) suite.causes = cause_list();
  const auto is_other = [&](const auto& one) { return one.name.find(settings.only) == std::string::npos; };
  std::erase_if(suite.faults, is_other);
  std::erase_if(suite.variants, is_other);
  std::erase_if(suite.masks, is_other);
  std::erase_if(suite.causes, is_other);
  return suite;
}

/// Sizes and seeds that no limit and no rule was made with.
SelftestRound further_round(const SelftestRound& first, uint64_t k) {
  constexpr std::array<std::array<int, 2>, 4> kSizes_px = {{{400, 225}, {256, 144}, {368, 207}, {288, 162}}};
  constexpr uint64_t kApart = 100;
  const auto& [width_px, height_px] = kSizes_px[k % kSizes_px.size()];
  return {width_px, height_px, first.seed + kApart * (k + 1)};
}

void try_causes(std::span<const CauseCase> faults, Stage& stage, std::vector<CauseOutcome>& outcomes) {
  for (const CauseCase& fault : faults) {
    if (fault.scene != stage.name()) continue;
    outcomes.push_back(ask(stage, "cause", fault.name, [&] { return try_cause(fault, stage); }));
  }
}

void try_benign(std::span<const BenignVariant> variants, Stage& stage, SelftestResults& results) {
  for (const BenignVariant& variant : variants) {
    const Unresolved unresolved =
        variant.moves_texels ? ask(stage, "unresolved", "", [&] { return stage.unresolved(soft_shadows()); })
                             : Unresolved{};
    if (!is_resolved(unresolved)) {
      results.left_out.push_back({variant.name, stage.name(), stage.round(), unresolved});
      continue;
    }
    const auto judged = [&] { return judge_and_keep(variant.name, variant.make(stage), stage); };
    results.benign.push_back(
        {variant.name, stage.name(), stage.round(), ask(stage, "benign", variant.name, judged)});
  }
}

void try_masks(std::span<const MaskCase> masks, Stage& stage, SelftestResults& results) {
  for (const MaskCase& mask : masks) {
    const auto counted = [&] { return count_mask(mask, stage); };
    if (const auto outcome = ask(stage, "mask", mask.name, counted)) results.masks.push_back(*outcome);
  }
}

void try_faults(std::span<const FaultCase> faults, Stage& stage, SelftestResults& results) {
  for (const FaultCase& fault : faults) {
    if (fault.scene != stage.name()) continue;
    const auto judged = [&] { return judge_and_keep(fault.name, fault.make(stage), stage); };
    results.faults.push_back({fault.name, fault.scene, stage.round(), fault.origin, fault.right,
                              ask(stage, "fault", fault.name, judged)});
  }
}

HardeningOutcome try_hardening(Stage& stage) {
  const auto& diagnosis = stage.examined_exact().run.diagnosis;
  if (!diagnosis) return {stage.name(), 0, {}};
  const PenumbraNumbers& penumbra = diagnosis->penumbra;
  return {stage.name(), penumbra.accepted() + penumbra.rejected(), diagnosis->contact_hardening};
}

}  // namespace

SelftestResults run_selftest(std::span<const SceneJob> jobs, const SelftestSettings& settings,
                             PictureRenderers renderers, Progress& progress) {
  const Suite suite = suite_of(settings);
  SelftestResults results;
  results.scenes = jobs.size();
  progress.begin("selftest", jobs.size() * settings.rounds.size());
  SilentProgress silent;
  for (const SelftestRound& round : settings.rounds) {
    for (const SceneJob& job : jobs) {
      Stage stage(job, settings, round, renderers, silent);
      try_benign(suite.variants, stage, results);
      try_masks(suite.masks, stage, results);
      try_faults(suite.faults, stage, results);
      if (round == settings.rounds.front()) {
        try_causes(suite.causes, stage, results.causes);
        if (settings.parts.hardening)
          results.hardening.push_back(ask(stage, "hardening", "", [&] { return try_hardening(stage); }));
      }
      progress.advance(1);
    }
  }
  progress.end();
  for (uint64_t k = 0; results.benign.size() < settings.fewest_benign; ++k) {
    const size_t before = results.benign.size();
    progress.begin(fmt::format("benign trials from {}", before), jobs.size());
    for (const SceneJob& job : jobs) {
      Stage stage(job, settings, further_round(settings.rounds.front(), k), renderers, silent);
      try_benign(suite.variants, stage, results);
      progress.advance(1);
    }
    progress.end();
    if (results.benign.size() == before) break;
  }
  return results;
}

}  // namespace umbrameter
