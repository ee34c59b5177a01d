// SPDX-License-Identifier: Apache-2.0
#pragma once
// Does a run pass, and if not, which fault is it? One rule with one set of limits for every fault, scene and
// technique (docs/selftest.md). Not here: the numbers it rests on (lab/score.h) and where runs come from.

#include "core/guard.h"
#include "metrics/better.h"
#include "metrics/diagnosis.h"
#include "metrics/error/visibility_error.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// What a run can be found guilty of. The first five void the rest: nothing else can be told then.
enum class GateClass : uint8_t {
  failure,  // no picture
  metric,   // the metrics miss known answers
  truth,    // the reference contradicts itself
  parity,   // the renderers see other surfaces
  light,    // the same surfaces under another light
  acne,     // this and the next seven: shares of the error by fault class
  terminator,
  extra_shadow,
  resolution,
  peter_panning,
  bleed,
  geometric_leak,
  lost_shadow,
  softness,           // penumbrae of the wrong width, or wrong in a way no width describes
  penumbra_too_wide,  // the same, where most of what is wrong is softness beyond the true one
  hardening,          // of the wrong width where they should widen or narrow
  offset,             // edges in the wrong place
  noise,
  banding,
  error,     // far from the truth, and none of the above
  measured,  // none of the above, but a measure that has a limit of its own: GateLimits::further
};
inline constexpr size_t kGateClasses = 21;

/// The enumerator's own word.
std::string_view name_of(GateClass kind);

/// The class that a fault's part of the error counts to: its own, or softness. `fault` is one (acne or later).
GateClass gate_class_of(FaultClass fault);

/// A run as the gate sees it.
struct GateRun {
  std::optional<Failure> failure;
  std::vector<std::string> metric_problems;  // metrics/metric_probe.h
  std::vector<std::string> truth_problems;   // metrics/error/truth_check.h
  bool parity_passes = true;
  bool is_other_light = false;  // where parity fails: the surfaces agree, the light on them does not
  std::optional<VisibilityError> error;
  std::optional<Diagnosis> diagnosis;
  std::map<std::string, double> measured;  // by key: rows of results/catalogue.h that no class stands for
};

/// A measured value may exceed the baseline's by `excess` and by `share` of it. Without a baseline by `excess`.
struct GateLimit {
  double excess = 0.0;
  double share = 0.0;
};

/// Of a measure that no class stands for: how far it is from right may exceed the baseline's.
struct FurtherLimit {
  Better better = Better::lower;  // not `higher`: shares of it say nothing
  GateLimit limit;
};

struct GateLimits {
  GateLimit fault = {2e-4, 0.5};       // a class's part of the mean absolute error
  GateLimit resolution = {2e-4, 1.0};  // the same; where texels fall against edges is chance
  GateLimit softness = {0.2, 0.25};    // root mean square of width, in octaves
  GateLimit hardening = {0.3, 0.25};   // distance of the slope from 1
  GateLimit offset = {0.15, 0.25};     // root mean square of the edges' offsets, in widths of their penumbrae
  GateLimit noise = {0.02, 0.5};       // standard deviation of visibility beyond the truth's
  GateLimit banding = {0.3, 0.25};     // 1 - levels / pixels
  GateLimit error = {0.03, 0.25};      // RMSE, where it is worse for certain
  std::map<std::string, FurtherLimit> further = {};  // of GateRun::measured, by key

  /// Of a fault's part of the error.
  const GateLimit& of(FaultClass part) const { return part == FaultClass::resolution ? resolution : fault; }
};

/// One thing that was measured; absent values do not apply.
struct GateMeasure {
  GateClass kind = GateClass::error;
  std::optional<double> value, baseline;
  double allowed = 0.0;  // largest value that passes
  std::string key = {};  // of kind `measured`
  bool exceeds() const { return value && *value > allowed; }
  /// How far above the baseline, in what is allowed; above 1 where `exceeds`.
  double severity() const;
};

struct GateVerdict {
  std::vector<GateMeasure> measures;  // softness has two, a share of the error and a width; empty when void
  std::optional<GateClass> kind;      // the main fault; absent: passes
  std::string key = {};               // of kind `measured`: which
  bool passes() const { return !kind.has_value(); }
};

/// The class's word; the key of what kind `measured` is about.
std::string_view name_of(const GateMeasure& measure);
/// The same of the main fault; empty when it passes.
std::string_view name_of(const GateVerdict& verdict);

/// The largest severity of what was measured; 0 for nothing.
double worst_severity(const GateVerdict& verdict);

/// `baseline` null: against the limits alone. Main is the first class that voids; else, of faults and penumbrae, the one
/// with the largest excess of the mean absolute error; a penumbra's is told further by what is most out of its limit. Where no
/// class is found, of the further measures the one that is most out of its limit.
/// `worse` says that the run is worse than the baseline for certain (metrics/error/verdict.h).
GateVerdict judge_gate(const GateRun& run, const GateRun* baseline, bool worse,
                       const GateLimits& limits = {});

}  // namespace umbrameter
