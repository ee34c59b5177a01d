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

struct CauseOutcome {
  std::string name, scene;
  std::vector<RunPart> right;
  std::optional<FaultClass>
      fault;  // the class whose error grew most against the sound picture; absent: none did
  std::vector<SubstitutionOutcome> tried;  // with one number each: of `fault`
  std::string best;                        // substitution that removes most of it; empty without any
  double removed = 0.0;                    // by that
  double undone = 0.0;           // by the sound run itself: no substitution of the right part can do more
  std::optional<RunPart> cause;  // what it replaced, where it mends the fault
  bool is_right() const;
};

/// `classes` [height][width] of the wrong run, with `fault` only where more than half of its error was put in: what the sound run
/// has wrong as well is its own, and other things mend it.
std::vector<FaultClass> put_in(std::vector<FaultClass> classes, FaultClass fault, const Image& wrong,
                               const Image& sound, const Image& truth);

CauseOutcome try_cause(const CauseCase& fault, Stage& stage);

/// "bias x 0 of colonnade: acne, ten times the bias removes 97 %".
std::string text_of(const CauseOutcome& outcome);

}  // namespace umbrameter
