// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a self-test has tried, in a store (lab/answers.h): one that was killed goes on from there.

#include "lab/answers.h"
#include "results/selftest/trial_json.h"
#include "study/stage.h"

#include <string>

namespace umbrameter {

/// Of the trial `name` of a `kind` ("fault") on the stage.
std::string trial_key(const Stage& stage, const std::string& kind, const std::string& name);

/// What `make` says, or said before.
template <class Make>
auto ask(Stage& stage, const std::string& kind, const std::string& name, const Make& make)
    -> decltype(make()) {
  Answers* const answers = stage.settings().answers;
  if (answers == nullptr || !answers->keeps()) return make();
  const std::string key = trial_key(stage, kind, name);
  decltype(make()) outcome{};
  if (answers->find(key, [&](const nlohmann::json& json) { read_trial(json, outcome); })) return outcome;
  outcome = make();
  answers->keep(key, trial_json(outcome));
  return outcome;
}

}  // namespace umbrameter
