// SPDX-License-Identifier: Apache-2.0
#include "results/catalogue.h"

#include "results/format.h"
#include "results/measured_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

using Value = std::optional<double>;
using Run = TechniqueResult;

constexpr std::array<std::string_view, 3> kNeedsNames = {"picture", "sequence", "timing"};
constexpr std::array<std::string_view, 8> kFormNames = {"error",   "signed_error", "share",        "number",
                                                        "octaves", "decibels",     "milliseconds", "bytes"};

Value value_of(const std::optional<Interval>& interval) {
  return interval ? Value(interval->value) : std::nullopt;
}

Value median_of(const std::optional<Spread>& spread) {
  return spread ? Value(spread->median) : std::nullopt;
}

/// The member of a part that a run may lack.
template <class Part, class Member>
auto in(const std::optional<Part>& part, Member Part::*member) {
  return part ? Value((*part).*member) : std::nullopt;
}

Value wrong_share(const Run& run) {
  const auto& numbers = run.judgement.significance;
  if (!numbers || numbers->tested == 0) return std::nullopt;
  return static_cast<double>(numbers->too_dark + numbers->too_bright) / static_cast<double>(numbers->tested);
}

Value frame_time(const Run& run) {
  const auto time = total_time(run.pass_times);
  return time ? Value(time->median_ms) : std::nullopt;
}

std::vector<Metric> error_rows() {
  const std::string group = "error", unit = "visibility";
  const GateLimits limits;
  return {
      {.key = "rmse",
       .label = "RMSE",
       .group = group,
       .unit = unit,
       .doc = "root mean square of V - R, the truth's noise taken out",
       .heading = "RMSE [95 %]",
       .of = [](const Run& run) { return run.error ? value_of(run.error->rmse) : std::nullopt; },
       .interval_of = [](const Run& run) { return run.error ? run.error->rmse : std::nullopt; },
       .gate = RowGate{GateClass::error, limits.error}},
      {"lit_rmse", "lit RMSE", group, "of the light's root mean square",
       "the same of visibility times unshadowed irradiance", Better::lower, MetricForm::error, "lit",
       [](const Run& run) { return run.lit_rmse; }},
      {"bias", "mean error", group, unit, "mean of V - R; above 0 it is too bright", Better::nearest_zero,
       MetricForm::signed_error, "mean",
       [](const Run& run) { return in(run.error, &VisibilityError::bias); }},
      {"over_shadowing", "over-shadowing", group, unit, "mean of what is too dark", Better::lower,
       MetricForm::error, "over",
       [](const Run& run) { return in(run.error, &VisibilityError::over_shadowing); }},
      {"under_shadowing", "under-shadowing", group, unit, "mean of what is too bright", Better::lower,
       MetricForm::error, "under",
       [](const Run& run) { return in(run.error, &VisibilityError::under_shadowing); }},
      {"penumbra.rmse", "RMSE in penumbrae", group, unit, "RMSE where the truth is neither lit nor dark",
       Better::lower, MetricForm::error, "penumbra",
       [](const Run& run) { return run.error ? region_rmse(run.error->penumbra) : std::nullopt; }},
      {"lit.rmse", "RMSE where it is lit", group, unit, "RMSE where the truth sees the whole light",
       Better::lower, MetricForm::error, "",
       [](const Run& run) { return run.error ? region_rmse(run.error->lit) : std::nullopt; }},
      {"umbra.rmse", "RMSE in umbrae", group, unit, "RMSE where the truth sees no light", Better::lower,
       MetricForm::error, "",
       [](const Run& run) { return run.error ? region_rmse(run.error->umbra) : std::nullopt; }},
      {"mae", "mean |error|", group, unit, "mean of |V - R|, the truth's noise included", Better::lower,
       MetricForm::error, "", [](const Run& run) { return in(run.error, &VisibilityError::mae); }},
      {"max_error", "largest |error|", group, unit, "largest |V - R| of a pixel", Better::lower,
       MetricForm::error, "", [](const Run& run) { return in(run.error, &VisibilityError::max_error); }},
      {"wrong_share", "wrong pixels", "significance", "share of the tested",
       "pixels whose error stands out from the truth's noise", Better::lower, MetricForm::share, "",
       wrong_share},
  };
}

std::vector<Metric> penumbra_rows() {
  const std::string group = "penumbrae";
  const GateLimits limits;
  const auto spread = [](std::optional<Spread> PenumbraNumbers::*member) {
    return [member](const Run& run) {
      return run.diagnosis ? median_of(run.diagnosis->penumbra.*member) : std::nullopt;
    };
  };
  const auto cause = [](std::optional<double> ErrorCauses::*member) {
    return [member](const Run& run) { return run.diagnosis ? run.diagnosis->causes.*member : std::nullopt; };
  };
  return {
      {.key = "width_octaves",
       .label = "width / true width",
       .group = group,
       .unit = "octaves",
       .doc = "median of log2 of the width over the true one",
       .better = Better::nearest_zero,
       .form = MetricForm::octaves,
       .of = spread(&PenumbraNumbers::width_octaves),
       .gate = RowGate{GateClass::softness, limits.softness}},
      {.key = "offset_widths",
       .label = "edge's shift",
       .group = group,
       .unit = "true widths",
       .doc = "median shift of the half-lit edge; above 0 it is too far out",
       .better = Better::nearest_zero,
       .form = MetricForm::number,
       .of = spread(&PenumbraNumbers::offset_widths),
       .gate = RowGate{GateClass::offset, limits.offset},
       .term = ObjectiveTerm{"edges", 0.1}},
      {"offset_world", "edge's shift in the world", group, "world units", "the same as a length",
       Better::nearest_zero, MetricForm::number, "", spread(&PenumbraNumbers::offset_world)},
      {.key = "contact_hardening_slope",
       .label = "contact hardening",
       .group = group,
       .doc = "slope of widths over true widths, in octaves; 1 is right",
       .better = Better::nearest_one,
       .form = MetricForm::number,
       .of =
           [](const Run& run) {
             return run.diagnosis ? run.diagnosis->contact_hardening.slope : std::nullopt;
           },
       .gate = RowGate{GateClass::hardening, limits.hardening}},
      {.key = "noise",
       .label = "noise",
       .group = group,
       .unit = "visibility",
       .doc = "standard deviation about the 3 x 3 mean in penumbrae",
       .of = cause(&ErrorCauses::noise),
       .gate = RowGate{GateClass::noise, limits.noise}},
      {.key = "banding",
       .label = "banding",
       .group = group,
       .doc = "1 less levels over pixels across a penumbra",
       .of = cause(&ErrorCauses::banding),
       .gate = RowGate{GateClass::banding, limits.banding}},
  };
}

/// Of the objective `faults`: acne, and what a bias too large lets through.
std::optional<ObjectiveTerm> term_of(FaultClass fault) {
  constexpr double kOne = 0.001;  // of the mean |error|
  switch (fault) {
    case FaultClass::acne:
      return ObjectiveTerm{"acne", kOne};
    case FaultClass::peter_panning:
    case FaultClass::bleed:
    case FaultClass::geometric_leak:
    case FaultClass::lost_shadow:
      return ObjectiveTerm{"leaks", kOne};
    default:
      return std::nullopt;
  }
}

Metric fault_row(FaultClass fault) {
  return {.key = fmt::format("fault.{}", name_of(fault)),
          .label = format_fault(fault),
          .group = "faults",
          .unit = "visibility",
          .doc = "the class's part of the mean |error|",
          .of =
              [fault](const Run& run) {
                return run.diagnosis ? Value(run.diagnosis->faults.of(fault).mean_abs_error) : std::nullopt;
              },
          .gate = RowGate{gate_class_of(fault), GateLimits{}.of(fault)},
          .term = term_of(fault)};
}

/// The classes' parts of the mean |error|, and the largest of them.
std::vector<Metric> fault_rows() {
  const std::string group = "faults", unit = "visibility";
  std::vector<Metric> rows{{"worst_fault_error", "worst fault", group, unit,
                            "the largest class's part of the mean |error|", Better::lower, MetricForm::error,
                            "", [](const Run& run) -> Value {
                              if (!run.diagnosis) return std::nullopt;
                              const auto worst = worst_fault(run.diagnosis->faults);
                              return worst ? run.diagnosis->faults.of(*worst).mean_abs_error : 0.0;
                            }}};
  for (size_t k = static_cast<size_t>(FaultClass::acne); k < kFaultClasses; ++k)
    rows.push_back(fault_row(static_cast<FaultClass>(k)));
  return rows;
}

std::vector<Metric> similarity_rows() {
  const std::string group = "similarity";
  const auto part = [](std::optional<double> Similarity::*member) {
    return [member](const Run& run) { return run.similarity ? (*run.similarity).*member : std::nullopt; };
  };
  return {
      {"flip_mean", "FLIP", group, "", "mean LDR-FLIP of the lit picture", Better::lower, MetricForm::error,
       "", part(&Similarity::flip_mean)},
      {"hdr_flip_mean", "HDR-FLIP", group, "", "mean HDR-FLIP of the lit picture", Better::lower,
       MetricForm::error, "", part(&Similarity::hdr_flip_mean)},
      {"ssim", "SSIM", group, "", "structural similarity of the lit picture; 1 for equal ones",
       Better::nearest_one, MetricForm::error, "", part(&Similarity::ssim)},
      {"psnr_db", "PSNR", group, "dB", "peak signal to noise of the lit picture", Better::higher,
       MetricForm::decibels, "",
       [](const Run& run) -> Value {
         if (!run.similarity || !run.similarity->psnr_db || !std::isfinite(*run.similarity->psnr_db))
           return std::nullopt;
         return run.similarity->psnr_db;
       }},
  };
}

std::vector<Metric> temporal_rows() {
  const std::string group = "over time", unit = "visibility";
  std::vector<Metric> rows = {
      {"flicker", "flicker beyond the truth's", group, unit, "of followed points under a moving camera",
       Better::lower, MetricForm::error, "",
       [](const Run& run) { return run.temporal ? run.temporal->camera.excess : std::nullopt; }},
      {"popping", "popping", group, unit, "root mean square under a moving light", Better::lower,
       MetricForm::error, "",
       [](const Run& run) { return run.temporal ? run.temporal->light.rms : std::nullopt; }},
      {"seed_noise", "noise over seeds", group, unit, "standard deviation over the technique's seeds",
       Better::lower, MetricForm::error, "",
       [](const Run& run) { return run.temporal ? run.temporal->seed_noise : std::nullopt; }},
  };
  for (Metric& row : rows) row.needs = MetricNeeds::sequence;
  return rows;
}

std::vector<Metric> cost_rows() {
  const std::string group = "cost";
  std::vector<Metric> rows = {
      {"time_ms", "time of a frame", group, "ms", "median of all passes of a frame", Better::lower,
       MetricForm::milliseconds, "", [](const Run& run) { return frame_time(run); }},
      {"memory_bytes", "textures", group, "bytes", "memory of the technique's own textures", Better::lower,
       MetricForm::bytes, "",
       [](const Run& run) {
         return run.memory_bytes > 0 ? Value(static_cast<double>(run.memory_bytes)) : std::nullopt;
       }},
  };
  for (Metric& row : rows) row.needs = MetricNeeds::timing;
  return rows;
}

std::string text_of(MetricForm form, double value) {
  switch (form) {
    case MetricForm::error:
      return format_error(value);
    case MetricForm::signed_error:
      return format_signed_error(value);
    case MetricForm::share:
      return format_share(value);
    case MetricForm::number:
      return fmt::format("{:+.3g}", value);
    case MetricForm::octaves:
      return fmt::format("{:.3g} x", std::exp2(value));
    case MetricForm::decibels:
      return fmt::format("{:.1f} dB", value);
    case MetricForm::milliseconds:
      return fmt::format("{:.3g} ms", value);
    case MetricForm::bytes:
      return format_bytes(static_cast<uint64_t>(value));
  }
  return {};
}

}  // namespace

std::string_view name_of(MetricNeeds needs) {
  return kNeedsNames[static_cast<size_t>(needs)];
}

std::string_view name_of(MetricForm form) {
  return kFormNames[static_cast<size_t>(form)];
}

TechniqueResult result_of(const Measures& measures) {
  TechniqueResult result;
  static_cast<Measures&>(result) = measures;
  return result;
}

const std::vector<Metric>& metric_catalogue() {
  static const std::vector<Metric> rows = [] {
    std::vector<Metric> all;
    for (auto part : {error_rows(), measured_rows(), penumbra_rows(), fault_rows(), similarity_rows(),
                      temporal_rows(), cost_rows()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return rows;
}

const Metric* find_metric(std::string_view key) {
  const auto found = std::ranges::find(metric_catalogue(), key, &Metric::key);
  return found == metric_catalogue().end() ? nullptr : &*found;
}

std::optional<double> badness(const Metric& metric, const TechniqueResult& result) {
  const auto value = metric.of(result);
  return value ? Value(badness(metric.better, *value)) : std::nullopt;
}

bool is_gate_measure(const Metric& metric) {
  if (metric.better == Better::higher || metric.needs == MetricNeeds::timing) return false;
  return metric.gate ? metric.gate->kind == GateClass::measured : bool(metric.measure);
}

std::map<std::string, double> gate_measures(const Measures& measures) {
  const TechniqueResult run = result_of(measures);
  std::map<std::string, double> values;
  for (const Metric& metric : metric_catalogue()) {
    if (!is_gate_measure(metric)) continue;
    if (const auto value = metric.of(run)) values[metric.key] = *value;
  }
  return values;
}

GateLimits gate_limits() {
  GateLimits limits;
  for (const Metric& metric : metric_catalogue()) {
    if (metric.gate && is_gate_measure(metric))
      limits.further[metric.key] = {metric.better, metric.gate->limit};
  }
  return limits;
}

std::map<std::string, double> measure_rows(const MetricInputs& inputs) {
  std::map<std::string, double> values;
  for (const Metric& metric : metric_catalogue()) {
    if (!metric.measure) continue;
    if (const auto value = metric.measure(inputs)) values[metric.key] = *value;
  }
  return values;
}

std::string format_metric(const Metric& metric, const TechniqueResult& result) {
  if (metric.interval_of) {
    if (const auto interval = metric.interval_of(result)) return format_interval(interval);
  }
  const auto value = metric.of(result);
  return value ? text_of(metric.form, *value) : kNotApplicable;
}

TermLines metric_lines(const TechniqueResult& result, std::string_view group) {
  TermLines lines;
  for (const Metric& metric : metric_catalogue()) {
    if (metric.group != group || metric.key.ends_with(".rmse") || !metric.of(result)) continue;
    lines.emplace_back(metric.label + (metric.interval_of ? " [95 %]" : ""), format_metric(metric, result));
  }
  return lines;
}

}  // namespace umbrameter
