// SPDX-License-Identifier: Apache-2.0
#pragma once
// Faults whose cause can be undone by a substitution (lab/causes/): what mends them must point at what was put in. Not
// here: whether the gate finds and names them (study/selftest/fault_list.h).

#include "lab/causes/find_causes.h"
#include "study/selftest/trial_makers.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct CauseCase {
  std::string name;
  std::string scene;           // of the library
  std::vector<RunPart> right;  // any of these is what was put in
  TechniqueChoice sound;       // without the fault
  ParameterValues wrong;       // over those of `sound`
  std::vector<Patch> patches;  // of its files
  SceneChange change;          // of the scene that it draws; may be empty
};

std::vector<CauseCase> cause_list();

/// `classes` [height][width] of the wrong run, with `fault` only where more than half of its error was put in: what the sound run
/// has wrong as well is its own, and other things mend it.
std::vector<FaultClass> put_in(std::vector<FaultClass> classes, FaultClass fault, const Image& wrong,
                               const Image& sound, const Image& truth);

CauseOutcome try_cause(const CauseCase& fault, Stage& stage);

}  // namespace umbrameter
