// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/causes.h"

#include "lab/causes/blocker_extension.h"
#include "results/diagnosis_format.h"
#include "results/metadata.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

/// The class whose part grew most, as long as that is what validate would name of all that grew; else what is explained: a light
/// of another size is wrong in widths, and small ones are excused.
std::optional<FaultClass> grown_fault(const FaultNumbers& wrong, const FaultNumbers& sound) {
  const auto growth = [&](FaultClass fault) {
    return std::max(0.0, wrong.of(fault).mean_abs_error - sound.of(fault).mean_abs_error);
  };
  const double excused = growth(FaultClass::explained);
  FaultClass most = FaultClass::explained;
  double all = excused, largest = 0.0;
  for (size_t k = static_cast<size_t>(FaultClass::explained) + 1; k < kFaultClasses; ++k) {
    const auto fault = static_cast<FaultClass>(k);
    all += growth(fault);
    if (growth(fault) > largest) most = fault;
    largest = std::max(largest, growth(fault));
  }
  if (largest > 0.0 && largest >= kNamedShare * all) return most;
  return excused > 0.0 ? std::optional(FaultClass::explained) : std::nullopt;
}

/// A run as the faulty technique makes it, of the scene as it sees it.
struct WrongRun {
  TechniqueChoice choice;
  Scene scene;
  TechniqueRun run;  // its parameters are complete, in world units
};

WrongRun wrong_run(const CauseCase& fault, const Stage& stage) {
  WrongRun out{
      with(fault.sound, fault.wrong), fault.change ? fault.change(stage.scene()) : stage.scene(), {}};
  out.run = stage.settings().describe_run(out.choice);
  out.run.parameters = in_world(out.run.declared, out.run.parameters, out.scene.bounds_world.diagonal());
  if (!fault.patches.empty())
    out.choice = mutant(out.choice, file_name_of(fault.name), fault.patches, stage.settings());
  return out;
}

/// The shadows of the run on the surfaces of the sound one: under another light those would fail parity.
Image draw(WrongRun& wrong, const Replacement& replacement, const Light& light, const Image& blockers,
           const TechniqueChoice& sound, Stage& stage) {
  wrong.scene.lights[wrong.scene.active_light] = light;
  return stage.shadows_of({wrong.choice.technique, replacement.parameters}, wrong.scene, stage.picture(sound),
                          replacement.takes_blocker_truth ? &blockers : nullptr);
}

}  // namespace

bool CauseOutcome::is_right() const {
  return cause && std::ranges::find(right, *cause) != right.end();
}

CauseOutcome try_cause(const CauseCase& fault, Stage& stage) {
  CauseOutcome out{fault.name, fault.scene, fault.right, {}, {}, {}, 0.0, {}};
  WrongRun wrong = wrong_run(fault, stage);
  const Light light = wrong.scene.light();
  const Replacement nothing{wrong.run.parameters, {light}, false, false, {}};
  const Image blockers = extended_blockers(stage.truth());
  const auto draw_wrong = [&](const Replacement& replacement, const Light& part) {
    return draw(wrong, replacement, part, blockers, fault.sound, stage);
  };
  const Image picture = draw_wrong(nothing, light);
  const Examined examined = examine(picture, stage.truth(), stage.eye_world());
  const Examined& sound = stage.examined(fault.sound);
  if (!examined.run.diagnosis || !sound.run.diagnosis) return out;
  out.fault = grown_fault(examined.run.diagnosis->faults, sound.run.diagnosis->faults);
  if (!out.fault) return out;
  const std::vector<FaultClass> faults = {*out.fault};
  const SubstitutedRun run{wrong.run.declared, wrong.run.parameters, light,
                           wrong.scene.bounds_world.diagonal(), 0};
  const FaultCauses causes =
      find_causes(run, {picture, stage.truth(), examined.fault_classes}, faults, draw_wrong);
  if (const SubstitutionOutcome* best = best_substitution(causes, 0)) {
    out.best = best->id;
    out.removed = best->removed[0];
  }
  if (const SubstitutionOutcome* cause = cause_of(causes, 0)) out.cause = find_substitution(cause->id)->part;
  out.tried = causes.outcomes;
  return out;
}

std::string text_of(const CauseOutcome& outcome) {
  const std::string head = fmt::format("{} of {}: ", outcome.name, outcome.scene);
  if (!outcome.fault) return head + "no fault grew";
  const Substitution* best = find_substitution(outcome.best);
  return head + fmt::format("{}, {} removes {:.0f} %", format_fault(*outcome.fault),
                            best == nullptr ? "nothing" : best->label, 100.0 * outcome.removed);
}

}  // namespace umbrameter
