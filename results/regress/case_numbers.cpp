// SPDX-License-Identifier: Apache-2.0
#include "results/regress/case_numbers.h"

#include "core/error.h"
#include "core/statistics.h"
#include "results/catalogue.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

constexpr size_t kFirstFault = static_cast<size_t>(FaultClass::acne);  // before it: what is no fault
constexpr const char* kWidth = "width_octaves";
constexpr const char* kOffset = "offset_widths";
constexpr const char* kSlope = "hardening_slope";
constexpr const char* kExcess = "hardening_intercept_octaves";
constexpr const char* kSpan = "hardening_octaves";
constexpr const char* kSlopeMargin = "hardening_slope_margin";
constexpr const char* kNoise = "noise";
constexpr const char* kTruthNoise = "reference_noise";
constexpr const char* kBanding = "banding";
constexpr const char* kFootprint = "footprint_px";

std::string fault_name(size_t k) {
  return std::string(name_of(static_cast<FaultClass>(k)));
}

using Measures = std::map<std::string, double>;

void set(Measures& measures, const char* name, const std::optional<double>& value) {
  if (value) measures[name] = *value;
}

std::string se_name(const char* name) {
  return std::string(name) + "_se";
}

std::string least_name(const char* name) {
  return std::string(name) + "_p5";
}

void set(Measures& measures, const char* name, const std::optional<Spread>& spread) {
  if (!spread) return;
  measures[name] = spread->rmse;
  measures[se_name(name)] = spread->rmse_se;
  measures[least_name(name)] = spread->p5;
}

std::optional<double> get(const Measures& measures, const std::string& name) {
  const auto found = measures.find(name);
  return found == measures.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Spread> get_spread(const Measures& measures, const char* name) {
  const auto value = get(measures, name);
  if (!value) return std::nullopt;
  Spread spread;
  spread.rmse = *value;
  spread.rmse_se = get(measures, se_name(name)).value_or(0.0);
  spread.p5 = get(measures, least_name(name)).value_or(0.0);
  return spread;
}

Measures measures_of(const Diagnosis& diagnosis) {
  Measures measures;
  for (size_t k = kFirstFault; k < kFaultClasses; ++k)
    measures[fault_name(k)] = diagnosis.faults.by_class[k].mean_abs_error;
  set(measures, kWidth, diagnosis.penumbra.width_octaves);
  set(measures, kOffset, diagnosis.penumbra.offset_widths);
  set(measures, kSlope, diagnosis.contact_hardening.slope);
  set(measures, kExcess, diagnosis.contact_hardening.intercept_octaves);
  set(measures, kSpan, std::optional(diagnosis.contact_hardening.octaves));
  set(measures, kSlopeMargin, diagnosis.contact_hardening.slope_margin);
  set(measures, kNoise, diagnosis.causes.noise);
  set(measures, kTruthNoise, diagnosis.causes.reference_noise);
  set(measures, kBanding, diagnosis.causes.banding);
  set(measures, kFootprint, diagnosis.causes.median_footprint_px);
  return measures;
}

Diagnosis diagnosis_of(const Measures& measures) {
  Diagnosis diagnosis;
  for (size_t k = kFirstFault; k < kFaultClasses; ++k)
    diagnosis.faults.by_class[k].mean_abs_error = get(measures, fault_name(k)).value_or(0.0);
  diagnosis.penumbra.width_octaves = get_spread(measures, kWidth);
  diagnosis.penumbra.offset_widths = get_spread(measures, kOffset);
  diagnosis.contact_hardening.slope = get(measures, kSlope);
  diagnosis.contact_hardening.intercept_octaves = get(measures, kExcess);
  diagnosis.contact_hardening.octaves = get(measures, kSpan).value_or(0.0);
  diagnosis.contact_hardening.slope_margin = get(measures, kSlopeMargin);
  diagnosis.causes.noise = get(measures, kNoise);
  diagnosis.causes.reference_noise = get(measures, kTruthNoise);
  diagnosis.causes.banding = get(measures, kBanding);
  diagnosis.causes.median_footprint_px = get(measures, kFootprint);
  return diagnosis;
}

}  // namespace

const std::vector<std::string>& measure_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = {"rmse"};
    for (size_t k = kFirstFault; k < kFaultClasses; ++k) all.push_back(fault_name(k));
    all.insert(all.end(),
               {kWidth, se_name(kWidth), least_name(kWidth), kOffset, se_name(kOffset), least_name(kOffset),
                kSlope, kExcess, kSpan, kSlopeMargin, kNoise, kTruthNoise, kBanding, kFootprint});
    for (const Metric& metric : metric_catalogue()) {
      if (is_gate_measure(metric)) all.push_back(metric.key);
    }
    return all;
  }();
  return names;
}

std::optional<CaseNumbers> case_numbers(const GateRun& run) {
  if (run.failure || !run.error || !run.error->mse) return std::nullopt;
  CaseNumbers numbers;
  numbers.scored_pixels = run.error->scored_pixels;
  numbers.mse = *run.error->mse;
  numbers.noise_sd = run.error->mse_noise_sd.value_or(0.0);
  if (run.diagnosis) numbers.measures = measures_of(*run.diagnosis);
  numbers.measures.insert(run.measured.begin(), run.measured.end());
  return numbers;
}

GateRun gate_run_of(const CaseNumbers& numbers) {
  GateRun run;
  run.error.emplace();
  run.error->scored_pixels = numbers.scored_pixels;
  run.error->mse = numbers.mse;
  run.error->rmse = rmse_of(numbers);
  if (numbers.measures.contains(fault_name(kFirstFault))) run.diagnosis = diagnosis_of(numbers.measures);
  for (const Metric& metric : metric_catalogue()) {
    if (!is_gate_measure(metric)) continue;
    if (const auto value = get(numbers.measures, metric.key)) run.measured[metric.key] = *value;
  }
  return run;
}

CaseNumbers mean_of(std::span<const CaseNumbers> pictures) {
  UMBRAMETER_ASSERT(!pictures.empty(), "the mean of nothing");
  const double count = static_cast<double>(pictures.size());
  CaseNumbers mean;
  mean.scored_pixels = pictures.front().scored_pixels;
  double seed_variance = 0.0;
  for (const CaseNumbers& one : pictures) {
    mean.mse.value += one.mse.value / count;
    mean.mse.low += one.mse.low / count;
    mean.mse.high += one.mse.high / count;
    mean.noise_sd += one.noise_sd / count;
    seed_variance += one.seed_sd * one.seed_sd / (count * count);
  }
  mean.seed_sd = std::sqrt(seed_variance);
  for (const auto& [name, first] : pictures.front().measures) {
    const auto has = [&name = name](const CaseNumbers& one) { return one.measures.contains(name); };
    if (!std::ranges::all_of(pictures, has)) continue;
    for (const CaseNumbers& one : pictures) mean.measures[name] += one.measures.at(name) / count;
  }
  return mean;
}

Interval rmse_of(const CaseNumbers& numbers) {
  return {signed_root(numbers.mse.value), signed_root(numbers.mse.low), signed_root(numbers.mse.high)};
}

}  // namespace umbrameter
