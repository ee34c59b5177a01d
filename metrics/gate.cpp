// SPDX-License-Identifier: Apache-2.0
#include "metrics/gate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

constexpr std::array<std::string_view, kGateClasses> kClassNames = {
    "failure",   "metric",         "truth",        "parity",     "light",
    "acne",      "terminator",     "extra_shadow", "resolution", "peter_panning",
    "bleed",     "geometric_leak", "lost_shadow",  "softness",   "penumbra_too_wide",
    "hardening", "offset",         "noise",        "banding",    "error",
    "measured"};

constexpr double kCoarser = 1.1;  // of the baseline's texels; less is how a map is laid over a scene

constexpr double kMostly = 0.8;  // as of a component that is one kind's (metrics/faults/faults.h)

struct FaultPair {
  FaultClass fault;
  GateClass kind;
};
constexpr std::array kFaults = {FaultPair{FaultClass::acne, GateClass::acne},
                                FaultPair{FaultClass::terminator, GateClass::terminator},
                                FaultPair{FaultClass::extra_shadow, GateClass::extra_shadow},
                                FaultPair{FaultClass::resolution, GateClass::resolution},
                                FaultPair{FaultClass::peter_panning, GateClass::peter_panning},
                                FaultPair{FaultClass::bleed, GateClass::bleed},
                                FaultPair{FaultClass::geometric_leak, GateClass::geometric_leak},
                                FaultPair{FaultClass::lost_shadow, GateClass::lost_shadow}};

std::optional<GateClass> void_reason(const GateRun& run) {
  if (run.failure) return GateClass::failure;
  if (!run.metric_problems.empty()) return GateClass::metric;
  if (!run.truth_problems.empty()) return GateClass::truth;
  if (!run.parity_passes) return run.is_other_light ? GateClass::light : GateClass::parity;
  return std::nullopt;
}

std::optional<double> rms(const std::optional<Spread>& spread) {
  return spread ? std::optional(spread->rmse) : std::nullopt;
}

std::optional<double> width(const GateRun& run) {
  return run.diagnosis ? rms(run.diagnosis->penumbra.width_octaves) : std::nullopt;
}

// Twice the standard error of the difference of two spreads: what other profiles of the same shadows may differ by.
double doubt(const GateRun& run, const GateRun* baseline, std::optional<Spread> PenumbraNumbers::*spread) {
  const auto variance_of = [spread](const GateRun& r) {
    const auto& value = r.diagnosis ? r.diagnosis->penumbra.*spread : std::nullopt;
    return value ? value->rmse_se * value->rmse_se : 0.0;
  };
  return 2.0 * std::sqrt(variance_of(run) + (baseline != nullptr ? variance_of(*baseline) : 0.0));
}

std::optional<double> offset(const GateRun& run) {
  return run.diagnosis ? rms(run.diagnosis->penumbra.offset_widths) : std::nullopt;
}

std::optional<double> hardening(const GateRun& run) {
  if (!run.diagnosis || !run.diagnosis->contact_hardening.slope) return std::nullopt;
  return std::abs(*run.diagnosis->contact_hardening.slope - 1.0);
}

// Of both slopes' intervals.
double hardening_doubt(const GateRun& run, const GateRun* baseline) {
  const auto margin_of = [](const GateRun& r) {
    return r.diagnosis ? r.diagnosis->contact_hardening.slope_margin.value_or(0.0) : 0.0;
  };
  return std::hypot(margin_of(run), baseline != nullptr ? margin_of(*baseline) : 0.0);
}

// Fine shadows differ from the 3 x 3 mean without noise; what the truth has is none. A difference of squares would
// make much of a fluctuation where the truth itself has a lot.
std::optional<double> noise(const GateRun& run) {
  if (!run.diagnosis || !run.diagnosis->causes.noise || !run.diagnosis->causes.reference_noise)
    return std::nullopt;
  return std::max(0.0, *run.diagnosis->causes.noise - *run.diagnosis->causes.reference_noise);
}

std::optional<double> banding(const GateRun& run) {
  return run.diagnosis ? run.diagnosis->causes.banding : std::nullopt;
}

std::optional<double> rmse(const GateRun& run) {
  return run.error && run.error->rmse ? std::optional(run.error->rmse->value) : std::nullopt;
}

// Of a picture whose penumbrae are all as far from their widths as they may be: a ramp stretched by k about its middle is wrong by
// (k - 1)^2 / 12 k of a full step squared, on average over the true ramp.
double rmse_of_widths(const GateRun& run, const GateLimits& limits) {
  const double stretch = std::exp2(limits.softness.excess), more = stretch - 1.0;
  return run.error ? std::sqrt(run.error->penumbra.share * more * more / (12.0 * stretch)) : 0.0;
}

std::optional<double> fault_share(const GateRun& run, FaultClass fault) {
  return run.diagnosis ? std::optional(run.diagnosis->faults.of(fault).mean_abs_error) : std::nullopt;
}

std::optional<double> penumbra_share(const GateRun& run) {
  if (!run.diagnosis) return std::nullopt;
  return *fault_share(run, FaultClass::penumbra) + *fault_share(run, FaultClass::overlap) +
         *fault_share(run, FaultClass::penumbra_too_wide);
}

double shrunk(const GateRun& run, const GateRun& baseline, FaultClass fault) {
  if (!run.diagnosis || !baseline.diagnosis) return 0.0;
  return std::max(0.0, *fault_share(baseline, fault) - *fault_share(run, fault));
}

// What a finer map no longer excuses: error that was there before, as long as the total has not grown.
double moved_from_resolution(const GateRun& run, const GateRun& baseline) {
  if (!run.diagnosis || !baseline.diagnosis) return 0.0;
  const auto total = [](const GateRun& r) {
    double sum = 0.0;
    for (size_t k = static_cast<size_t>(FaultClass::acne); k < kFaultClasses; ++k)
      sum += r.diagnosis->faults.by_class[k].mean_abs_error;
    return sum;
  };
  return total(run) > total(baseline) ? 0.0 : shrunk(run, baseline, FaultClass::resolution);
}

GateMeasure measure(GateClass kind, const std::optional<double>& value, const std::optional<double>& baseline,
                    const GateLimit& limit) {
  return {kind, value, baseline, (1.0 + limit.share) * baseline.value_or(0.0) + limit.excess};
}

double excess(const GateMeasure& m) {
  return m.value.value_or(0.0) - m.baseline.value_or(0.0);
}

// By how much the map's texels are larger than the baseline's; absent where either is unknown.
std::optional<double> texel_ratio(const GateRun& run, const GateRun* baseline) {
  const auto footprint = [](const GateRun& r) {
    return r.diagnosis ? r.diagnosis->causes.median_footprint_px : std::nullopt;
  };
  if (baseline == nullptr || !footprint(run) || !footprint(*baseline)) return std::nullopt;
  return *footprint(run) / *footprint(*baseline);
}

// Edges that no coarser a map draws worse are no fault of its resolution; a coarser one's texels make acne and detach shadows, too.
std::optional<bool> is_coarser(const GateRun& run, const GateRun* baseline) {
  const auto ratio = texel_ratio(run, baseline);
  return ratio ? std::optional(*ratio > kCoarser) : std::nullopt;
}

// An edge of the map lies up to half a texel beside the true one: what errs at edges, named or not, grows with the texel. As far
// as a map is no coarser one, but laid otherwise over the scene.
double from_texels(const GateRun& run, const GateRun* baseline) {
  const auto ratio = texel_ratio(run, baseline);
  if (!ratio) return 0.0;
  const double errs = *penumbra_share(*baseline) + *fault_share(*baseline, FaultClass::explained) +
                      *fault_share(*baseline, FaultClass::resolution);
  return (std::clamp(*ratio, 1.0, kCoarser) - 1.0) * errs;
}

// How far a further measure is from right.
std::optional<double> distance(const GateRun& run, const std::string& key, Better better) {
  const auto found = run.measured.find(key);
  return found == run.measured.end() ? std::nullopt : std::optional(badness(better, found->second));
}

template <class Key>
const GateMeasure* largest(const std::vector<GateMeasure>& measures, size_t begin, size_t end,
                           const Key& key) {
  const GateMeasure* best = nullptr;
  for (size_t k = begin; k < end; ++k) {
    const GateMeasure& m = measures[k];
    if (m.exceeds() && (best == nullptr || key(m) > key(*best))) best = &m;
  }
  return best;
}

const GateMeasure& of(const std::vector<GateMeasure>& measures, GateClass kind) {
  return *std::find_if(measures.begin(), measures.end(),
                       [&](const GateMeasure& m) { return m.kind == kind; });
}

// By how many octaves the narrowest penumbrae differ from the truth's: those measured, or the end of the hardening line, which
// penumbrae without an umbra have a say in.
std::optional<double> narrowest_octaves(const GateRun& run) {
  if (!run.diagnosis || !run.diagnosis->penumbra.width_octaves) return std::nullopt;
  const double measured = run.diagnosis->penumbra.width_octaves->p5;
  const ContactHardening& line = run.diagnosis->contact_hardening;
  if (!line.slope || !line.intercept_octaves) return measured;
  return std::min(measured, *line.intercept_octaves - 0.5 * line.octaves * std::abs(*line.slope - 1.0));
}

// Whether some penumbrae are, or may be, narrower than the truth's and the baseline's by more than widths may err.
bool any_too_narrow(const GateRun& run, const GateRun* baseline, const GateLimits& limits) {
  const auto narrowest = narrowest_octaves(run);
  if (!narrowest) return true;
  const double before = baseline != nullptr ? std::min(0.0, narrowest_octaves(*baseline).value_or(0.0)) : 0.0;
  return *narrowest < before - limits.softness.excess;
}

// Whether more than `part` of what the penumbrae have too much of is softness beyond the true one.
bool is_too_wide(const GateRun& run, const GateRun* baseline, double part) {
  if (!run.diagnosis) return false;
  const auto more = [&](const auto& share) {
    return share(run) - (baseline != nullptr && baseline->diagnosis ? share(*baseline) : 0.0);
  };
  const double all = more([](const GateRun& r) { return *penumbra_share(r); });
  const double wide = more([](const GateRun& r) { return *fault_share(r, FaultClass::penumbra_too_wide); });
  return wide > part * all && wide > 0.0;
}

// A wrong slope makes widths wrong, and grain is made of few levels: the cause goes first. A filter too wide everywhere
// widens narrow penumbrae most, and its slope is no fault of its own.
std::optional<GateClass> kind_of_penumbra(const std::vector<GateMeasure>& measures, size_t shapes,
                                          bool is_blur) {
  if (of(measures, GateClass::hardening).exceeds())
    return is_blur ? GateClass::penumbra_too_wide : GateClass::hardening;
  const bool is_grain = of(measures, GateClass::noise).exceeds();
  const GateMeasure* worst = largest(measures, shapes, measures.size(), [&](const GateMeasure& m) {
    return is_grain && m.kind == GateClass::banding ? 0.0 : m.severity();
  });
  return worst != nullptr ? std::optional(worst->kind) : std::nullopt;
}

// What the two runs say of a fault beside its measures.
struct Hints {
  bool is_blur = false;  // nothing is too narrow, and four fifths are too wide
  std::optional<bool> is_coarser;
};

std::optional<GateClass> main_fault(const std::vector<GateMeasure>& measures, const GateMeasure& error,
                                    const Hints& hints) {
  const size_t shares = kFaults.size() + 1;  // the last one: of penumbrae
  const GateMeasure* fault = largest(measures, 0, shares, excess);
  const GateMeasure& penumbrae = measures[shares - 1];
  if (fault != nullptr && fault->kind == GateClass::resolution && hints.is_coarser == false &&
      penumbrae.exceeds())
    fault = &penumbrae;
  const bool is_of_texels = hints.is_coarser == true && of(measures, GateClass::resolution).exceeds();
  if (fault != nullptr && is_of_texels &&
      (fault->kind == GateClass::acne || fault->kind == GateClass::peter_panning))
    return GateClass::resolution;
  // A filter of the wrong size loses thin shadows, too.
  const bool is_hardening = of(measures, GateClass::hardening).exceeds();
  const bool is_lost = fault != nullptr && fault->kind == GateClass::lost_shadow && is_hardening &&
                       of(measures, GateClass::softness).exceeds();
  if (fault != nullptr && fault->kind != GateClass::softness && !is_lost) return fault->kind;
  if (const auto kind = kind_of_penumbra(measures, shares, hints.is_blur)) return kind;
  if (fault != nullptr) return fault->kind;
  return error.exceeds() ? std::optional(GateClass::error) : std::nullopt;
}

// What no class stands for speaks where no class does.
void name_further(GateVerdict& verdict, size_t begin) {
  const GateMeasure* worst = largest(verdict.measures, begin, verdict.measures.size(),
                                     [](const GateMeasure& m) { return m.severity(); });
  if (verdict.kind || worst == nullptr) return;
  verdict.kind = worst->kind;
  verdict.key = worst->key;
}

}  // namespace

std::string_view name_of(GateClass kind) {
  return kClassNames[static_cast<size_t>(kind)];
}

GateClass gate_class_of(FaultClass fault) {
  const auto found = std::ranges::find(kFaults, fault, &FaultPair::fault);
  return found == kFaults.end() ? GateClass::softness : found->kind;
}

std::string_view name_of(const GateMeasure& measure) {
  return measure.kind == GateClass::measured ? measure.key : name_of(measure.kind);
}

std::string_view name_of(const GateVerdict& verdict) {
  if (!verdict.kind) return {};
  return *verdict.kind == GateClass::measured ? verdict.key : name_of(*verdict.kind);
}

double GateMeasure::severity() const {
  const double room = allowed - baseline.value_or(0.0);
  return excess(*this) / room;
}

double worst_severity(const GateVerdict& verdict) {
  double worst = 0.0;
  for (const GateMeasure& m : verdict.measures) worst = std::max(worst, m.value ? m.severity() : 0.0);
  return worst;
}

GateVerdict judge_gate(const GateRun& run, const GateRun* baseline, bool worse, const GateLimits& limits) {
  GateVerdict verdict;
  verdict.kind = void_reason(run);
  if (verdict.kind) return verdict;
  // What only one of the two lets measure cannot be compared.
  const auto add = [&](GateClass kind, const auto& value_of, const GateLimit& limit, double more = 0.0) {
    std::optional<double> value = value_of(run);
    const std::optional<double> before = baseline != nullptr ? value_of(*baseline) : std::nullopt;
    if (baseline != nullptr && !before) value.reset();
    verdict.measures.push_back(measure(kind, value, before, limit));
    verdict.measures.back().allowed += more;
  };
  const double moved = baseline != nullptr ? moved_from_resolution(run, *baseline) : 0.0;
  const double of_texels = from_texels(run, baseline);
  for (const auto& [fault, kind] : kFaults) {
    const bool is_resolution = kind == GateClass::resolution;
    add(
        kind, [fault = fault](const GateRun& r) { return fault_share(r, fault); }, limits.of(fault),
        is_resolution ? of_texels : moved);
  }
  // The envelope's edge takes a shape whole or leaves it: what was explained before is no new error of penumbrae.
  const double named =
      baseline != nullptr ? std::max(moved, shrunk(run, *baseline, FaultClass::explained)) : 0.0;
  add(GateClass::softness, penumbra_share, limits.fault, named + of_texels);
  add(GateClass::softness, width, limits.softness, doubt(run, baseline, &PenumbraNumbers::width_octaves));
  add(GateClass::hardening, hardening, limits.hardening, hardening_doubt(run, baseline));
  add(GateClass::offset, offset, limits.offset, doubt(run, baseline, &PenumbraNumbers::offset_widths));
  add(GateClass::noise, noise, limits.noise);
  add(GateClass::banding, banding, limits.banding);
  std::vector<GateMeasure> causes = verdict.measures;
  const GateLimit error = {std::hypot(limits.error.excess, rmse_of_widths(run, limits)), limits.error.share};
  add(GateClass::error, rmse, error);
  if (baseline != nullptr && !worse) verdict.measures.back().value.reset();
  const bool is_blur = is_too_wide(run, baseline, kMostly) && !any_too_narrow(run, baseline, limits);
  const Hints hints = {is_blur, is_coarser(run, baseline)};
  verdict.kind = main_fault(causes, verdict.measures.back(), hints);
  if (verdict.kind == GateClass::softness && is_too_wide(run, baseline, 0.5))
    verdict.kind = GateClass::penumbra_too_wide;
  const size_t classes = verdict.measures.size();
  for (const auto& [key, further] : limits.further) {
    add(
        GateClass::measured,
        [&key = key, better = further.better](const GateRun& r) { return distance(r, key, better); },
        further.limit);
    verdict.measures.back().key = key;
  }
  name_further(verdict, classes);
  return verdict;
}

}  // namespace umbrameter
