// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/causes.h"

#include "study/diagnosis_format.h"
#include "study/metadata.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

/// The class whose part grew most; the explained, too: a light of another size is wrong in widths, and widths are excused.
std::optional<FaultClass> grown_fault(const FaultNumbers& wrong, const FaultNumbers& sound) {
  std::optional<FaultClass> grown;
  double most = 0.0;
  for (size_t k = static_cast<size_t>(FaultClass::explained); k < kFaultClasses; ++k) {
    const auto fault = static_cast<FaultClass>(k);
    const double growth = wrong.of(fault).mean_abs_error - sound.of(fault).mean_abs_error;
    if (growth > most) grown = fault;
    most = std::max(most, growth);
  }
  return grown;
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

Image draw(WrongRun& wrong, const Replacement& replacement, const Light& light, Stage& stage) {
  wrong.scene.lights[wrong.scene.active_light] = light;
  return stage.picture_of({wrong.choice.technique, replacement.parameters}, wrong.scene,
                          replacement.takes_blocker_truth ? &stage.truth() : nullptr);
}

}  // namespace

bool CauseOutcome::is_right() const {
  return cause && std::ranges::find(right, *cause) != right.end();
}

CauseOutcome try_cause(const CauseCase& fault, Stage& stage) {
  CauseOutcome out{fault.name, fault.scene, fault.right, {}, {}, 0.0, {}};
  WrongRun wrong = wrong_run(fault, stage);
  const Light light = wrong.scene.light();
  const Replacement nothing{wrong.run.parameters, {light}, false, {}};
  const Image picture = draw(wrong, nothing, light, stage);
  const Examined examined = examine(picture, stage.truth(), stage.eye_world());
  const Examined& sound = stage.examined(fault.sound);
  if (!examined.run.diagnosis || !sound.run.diagnosis) return out;
  out.fault = grown_fault(examined.run.diagnosis->faults, sound.run.diagnosis->faults);
  if (!out.fault) return out;
  const std::vector<FaultClass> faults = {*out.fault};
  const SubstitutedRun run{wrong.run.declared, wrong.run.parameters, light,
                           wrong.scene.bounds_world.diagonal(), 0};
  const FaultCauses causes = find_causes(run, {picture, stage.truth(), examined.fault_classes}, faults,
                                         [&](const Replacement& replacement, const Light& part) {
                                           return draw(wrong, replacement, part, stage);
                                         });
  if (const SubstitutionOutcome* best = best_substitution(causes, 0)) {
    out.best = best->id;
    out.removed = best->removed[0];
  }
  if (const SubstitutionOutcome* cause = cause_of(causes, 0)) out.cause = find_substitution(cause->id)->part;
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
