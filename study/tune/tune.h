// SPDX-License-Identifier: Apache-2.0
#pragma once
// Auto-tune: the parameters of one technique that make an objective least on one scene or on several, what they are worth
// beside the defaults and presets, on cameras they were not made for, and how far they may be moved.

#include "study/tune/safe_window.h"
#include "study/tune/search/minimise.h"
#include "study/tune/views.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

struct NamedValues {
  std::string name;
  ParameterValues values;  // only those it sets
};

struct TunePlan {
  TechniqueRun technique;             // its parameters are the base: what is not tuned stays as it is there
  bool is_engine = false;             // a foreign renderer: settings are told in its own words
  std::vector<Parameter> parameters;  // all of the technique's
  std::vector<NamedValues> presets;
  std::vector<std::string> tuned;  // names; empty: choose_search_space
  IsActive is_active;              // of the manifest's conditions, on any of the scenes; none: all act
  Objective objective = {};
  uint64_t seed = 1;
  size_t evaluations = 0;  // most, of the search
  double time_limit_s = 60.0;
  int cameras = 5;                 // a scene: its own, and four beside it; or 1
  int grid_steps = 0;              // of numbers; 0: no dense grid to check the search with
  std::optional<Fidelity> coarse;  // where the search begins; absent: at full size
  Fidelity full;
  std::vector<std::string> notes;  // go into the result's
  EvaluationStore kept = {};       // of what is measured of pictures
};

/// Error{input} when a scene cannot be measured at the defaults, or two names are the same. Windows, sensitivities
/// and presets at their own cost are left out, with a note, when the time is up.
TuneResult run_tune(std::span<SceneJob> scenes, const TunePlan& plan, Renderer& realtime, Progress& progress);

}  // namespace umbrameter
