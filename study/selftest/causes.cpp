// SPDX-License-Identifier: Apache-2.0
#include "study/selftest/causes.h"

#include "lab/causes/blocker_extension.h"
#include "results/diagnosis_format.h"
#include "results/metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

std::vector<FaultClass> put_in(std::vector<FaultClass> classes, FaultClass fault, const Image& wrong,
                               const Image& sound, const Image& truth) {
  const FaultClass other = fault == FaultClass::explained ? FaultClass::penumbra : FaultClass::explained;
  const auto v = wrong.plane("visibility"), s = sound.plane("visibility"), r = truth.plane("visibility");
  for (size_t i = 0; i < classes.size(); ++i) {
    if (classes[i] == fault && !(std::abs(v[i] - r[i]) > 2.0f * std::abs(s[i] - r[i]))) classes[i] = other;
  }
  return classes;
}

CauseOutcome try_cause(const CauseCase& fault, Stage& stage) {
  CauseOutcome out;
  out.name = fault.name;
  out.scene = fault.scene;
  out.right = fault.right;
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
  const Image& sound_picture = stage.picture(fault.sound);
  const std::vector<FaultClass> classes =
      put_in(examined.fault_classes, *out.fault, picture, sound_picture, stage.truth());
  const FaultCauses causes = find_causes(run, {picture, stage.truth(), classes}, faults, draw_wrong);
  if (causes.faults.empty()) return out;
  SubstitutionOutcome undone;
  measure_substitution(sound_picture, picture, stage.truth(), classes, causes.faults, undone);
  out.undone = undone.removed.front();
  if (const SubstitutionOutcome* best = best_substitution(causes, 0)) {
    out.best = best->id;
    out.removed = best->removed[0];
  }
  if (const SubstitutionOutcome* cause = cause_of(causes, 0)) out.cause = find_substitution(cause->id)->part;
  out.tried = causes.outcomes;
  return out;
}

}  // namespace umbrameter
