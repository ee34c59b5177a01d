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
  Objective objective = Objective::rmse;
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

/// The objective on one view.
struct ViewScore {
  std::string view;
  bool is_held_out = false;
  std::optional<ObjectiveValue> objective;  // absent: nothing to measure, or the run failed
  double ratio = 0.0;                       // to the default's; infinite without one
};

/// One way to set the technique, measured everywhere.
struct Candidate {
  std::string name;        // "tuned", "default", a preset
  bool same_cost = true;   // false: a preset with its own taps and map size
  ParameterValues values;  // complete
  std::vector<ViewScore> scores;
  /// Mean over views of objective / default's; infinite when one is missing.
  double ratio = 0.0;
  std::optional<double> held_out_ratio;  // absent without held-out views
  /// How much larger its ratio is than that of the tuned values, with a 95 % interval over the cameras (Student; of one
  /// camera: Judge::gain_on). Absent for the tuned values themselves, and where a picture fails.
  std::optional<Interval> gain, held_out_gain;
};

/// How much the objective rises, as a share of its least, one step to either side; of a choice, at the best other one.
struct Sensitivity {
  std::string parameter;
  std::optional<double> rise_below, rise_above;  // absent at the end of the range, and where the run fails
  double relative_spread = 0.0;                  // over the coarse levels of the search
};

struct GridCheck {
  size_t evaluations = 0;
  double best_ratio = 0.0;
  ParameterValues best;
};

struct TuneResult {
  std::vector<std::string> scenes;
  std::vector<std::string> tuned;
  Candidate best;
  std::vector<Candidate> others;    // default, presets
  std::vector<SafeWindow> windows;  // beside the values as given; where others were found, beside those too
  double texel_world = 0.0;  // median width of a texel on the receivers of the first view; 0 when not known
  std::vector<Sensitivity> sensitivities;
  std::vector<Trial> coarse_trials, full_trials;   // objective: mean of ratios to the default's
  size_t coarse_evaluations = 0, evaluations = 0;  // different values rendered until the best were found
  bool is_converged = false;
  std::optional<GridCheck> grid;
  std::vector<std::string> notes;  // what was left out, and why
  std::string device;
  double wall_time_s = 0.0;
};

/// Error{input} when a scene cannot be measured at the defaults, or two names are the same. Windows, sensitivities
/// and presets at their own cost are left out, with a note, when the time is up.
TuneResult run_tune(std::span<SceneJob> scenes, const TunePlan& plan, Renderer& realtime, Progress& progress);

}  // namespace umbrameter
