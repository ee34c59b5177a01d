// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a tuning found. Not here: the files (results/tune/tune_json.h, tune_files.h) and the search (study/tune/).

#include "core/parameters.h"
#include "metrics/statistics/interval.h"
#include "results/tune/objective.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

enum class WindowKind : uint8_t {
  bias,  // of group "bias": a length in texels or world units, or an engine's in its own; faults: shares of acne and of peter-panning
  light_size  // of group "light"; faults: octaves by which the median penumbra is too narrow and too wide
};

/// Most of a fault within a window: a share of the scored pixels, or octaves (a quarter: 19 % of the width).
double tolerance_of(WindowKind kind);

struct WindowPoint {
  double value = 0.0;
  double objective = 0.0;
  double too_low = 0.0, too_high = 0.0;  // faults of a value that is too low, and of one that is too high
};

struct SafeWindow {
  std::string parameter;
  std::string unit;
  WindowKind kind = WindowKind::bias;
  bool falls = false;               // a bias that moves shadows away as it falls
  bool is_at_tuned = false;         // else: beside the values as given
  std::vector<WindowPoint> points;  // by value
  std::optional<double> from;       // least value from which on none of them is too low; absent: all are
  std::optional<double> to;         // largest value up to which none is too high; absent: all are
  bool is_complete = true;          // false: the time was up, and there is no window

  bool has_window() const { return from && to && *from <= *to; }
};

/// A length in the one unit and in the other; absent when it is no length or the texel is not known.
std::optional<double> in_texels(const std::string& unit, double length, double texel_world);
std::optional<double> in_world_units(const std::string& unit, double length, double texel_world);

/// What a search tried.
struct TuneTrial {
  ParameterValues values;
  std::vector<double> point;  // of the unit cube
  double objective = std::numeric_limits<double>::infinity();
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
  /// camera: from its pixels). Absent for the tuned values themselves, and where a picture fails.
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

/// What was asked, as far as files say it.
struct TuneHead {
  std::string technique, hash;
  bool is_engine = false;             // a foreign renderer: settings are told in its own words
  std::vector<Parameter> parameters;  // all of the technique's
  Objective objective = {};
  int width_px = 0, height_px = 0;
  uint64_t seed = 0;
};

struct TuneResult {
  TuneHead head;
  std::vector<std::string> scenes;
  std::vector<std::string> tuned;
  Candidate best;
  std::vector<Candidate> others;    // default, presets
  std::vector<SafeWindow> windows;  // beside the values as given; where others were found, beside those too
  double texel_world = 0.0;  // median width of a texel on the receivers of the first view; 0 when not known
  std::vector<Sensitivity> sensitivities;
  std::vector<TuneTrial> coarse_trials, full_trials;  // objective: mean of ratios to the default's
  size_t coarse_evaluations = 0, evaluations = 0;     // different values rendered until the best were found
  bool is_converged = false;
  std::optional<GridCheck> grid;
  std::vector<std::string> notes;  // what was left out, and why
  std::string device;
  double wall_time_s = 0.0;
};

}  // namespace umbrameter
