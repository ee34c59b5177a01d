// SPDX-License-Identifier: Apache-2.0
#include "results/tune/objective.h"

#include "core/error.h"
#include "core/names.h"
#include "metrics/error/lit_error.h"
#include "metrics/image/parity.h"
#include "metrics/penumbra/width_error.h"
#include "results/catalogue.h"

#include <algorithm>
#include <array>
#include <vector>

namespace umbrameter {
namespace {

constexpr int kLeastRounds = 100;  // a bootstrap refuses fewer

/// A picture beside its truth, with the pixels that both know.
struct Pair {
  const Image& test;
  const Image& reference;
  std::span<const uint8_t> mask;
};

std::optional<ObjectiveValue> measure_rmse(const Pair& pair, bool with_interval) {
  VisibilityErrorSettings settings;
  if (!with_interval) settings.bootstrap_rounds = kLeastRounds;
  const VisibilityError error = measure_visibility_error(pair.test, pair.reference, pair.mask, settings);
  if (!error.rmse) return std::nullopt;
  return ObjectiveValue{error.rmse->value, with_interval ? error.rmse : std::nullopt};
}

std::optional<ObjectiveValue> measure_widths(const Pair& pair, bool with_interval) {
  const auto profiles = measure_penumbra(pair.test, pair.reference, pair.mask).profiles;
  const auto value = measure_width_error(profiles);
  if (!value) return std::nullopt;
  return ObjectiveValue{*value, with_interval ? width_error_interval(profiles) : std::nullopt};
}

/// The number of a row that is measured from pictures.
void add_measured(const Metric& metric, const Pair& pair, std::span<const PenumbraProfile> profiles,
                  TechniqueResult& run) {
  const auto value = metric.measure(
      {.test = pair.test, .reference = pair.reference, .mask = pair.mask, .profiles = profiles});
  if (value) run.measured[metric.key] = *value;
}

/// Rows that have a term, the sharpest first: rows of one term lie together.
std::vector<const Metric*> rows_with_terms() {
  std::vector<const Metric*> rows;
  for (const Metric& metric : metric_catalogue()) {
    if (metric.term) rows.push_back(&metric);
  }
  std::ranges::stable_sort(rows, {}, [](const Metric* row) { return row->term->one; });
  return rows;
}

std::optional<ObjectiveValue> measure_faults(const Pair& pair, bool) {
  const DiagnosedImage diagnosed = diagnose(pair.test, pair.reference, pair.mask);
  if (!diagnosed.numbers.faults.mean_abs_error) return std::nullopt;
  TechniqueResult run;
  run.diagnosis = diagnosed.numbers;
  const std::vector<const Metric*> rows = rows_with_terms();
  double sum = 0.0;
  for (size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    const ObjectiveTerm& term = *rows[begin]->term;
    double of_term = 0.0;
    for (; end < rows.size() && rows[end]->term->name == term.name; ++end) {
      if (rows[end]->measure) add_measured(*rows[end], pair, diagnosed.profiles, run);
      of_term += badness(*rows[end], run).value_or(0.0);
    }
    sum += of_term / term.one;
  }
  return ObjectiveValue{sum, {}};
}

struct NamedObjective {
  const char *name, *unit;
  std::optional<ObjectiveValue> (*measure)(const Pair& pair, bool with_interval);
};
constexpr std::array kNamed = {NamedObjective{"rmse", "visibility", measure_rmse},
                               NamedObjective{"penumbra", "octaves", measure_widths},
                               NamedObjective{"faults", "weighted faults", measure_faults}};

const NamedObjective* find_named(const std::string& name) {
  const auto found =
      std::ranges::find_if(kNamed, [&](const NamedObjective& one) { return one.name == name; });
  return found == kNamed.end() ? nullptr : &*found;
}

/// The parts of a score; each row needs one.
using AddPart = void (*)(const Pair& pair, TechniqueResult& run);
constexpr std::array<AddPart, 5> kParts = {
    [](const Pair& pair, TechniqueResult& run) {
      run.error =
          measure_visibility_error(pair.test, pair.reference, pair.mask, {.bootstrap_rounds = kLeastRounds});
    },
    [](const Pair& pair, TechniqueResult& run) {
      if (pair.reference.has("irradiance_half_a"))
        run.lit_rmse = measure_lit_error(pair.test, pair.reference, pair.mask);
    },
    [](const Pair& pair, TechniqueResult& run) {
      run.judgement.significance =
          significance_numbers(measure_significance(pair.test, pair.reference, pair.mask));
    },
    [](const Pair& pair, TechniqueResult& run) {
      run.diagnosis = diagnose(pair.test, pair.reference, pair.mask).numbers;
    },
    [](const Pair& pair, TechniqueResult& run) {
      run.similarity = SimilarityReference(pair.reference, pair.mask).measure(pair.test, nullptr);
    }};

std::optional<ObjectiveValue> measure_row(const Metric& metric, const Pair& pair) {
  if (std::ranges::find(pair.mask, 1) == pair.mask.end()) return std::nullopt;
  TechniqueResult run;
  if (metric.measure) {
    add_measured(metric, pair, {}, run);
    if (!metric.of(run))
      add_measured(metric, pair, measure_penumbra(pair.test, pair.reference, pair.mask).profiles, run);
  } else {
    for (size_t k = 0; k < kParts.size() && !metric.of(run); ++k) kParts[k](pair, run);
  }
  const auto value = badness(metric, run);
  return value ? std::optional(ObjectiveValue{*value, {}}) : std::nullopt;
}

std::vector<std::string> objective_names() {
  std::vector<std::string> names;
  for (const NamedObjective& one : kNamed) names.emplace_back(one.name);
  for (const Metric& metric : metric_catalogue()) {
    if (metric.needs == MetricNeeds::picture && metric.better != Better::higher) names.push_back(metric.key);
  }
  return names;
}

[[noreturn]] void refuse(const Metric& metric) {
  if (metric.needs != MetricNeeds::picture)
    fail_input(
        fmt::format("'{}' is no objective: it needs a {}, and a search compares single pictures", metric.key,
                    metric.needs == MetricNeeds::timing ? "timing" : "sequence of pictures"),
        {}, "'umbrameter metrics' says what a row needs");
  fail_input(
      fmt::format("'{}' is no objective: it is better when higher, and a search makes its objective small",
                  metric.key),
      {}, "try rmse or ssim");
}

}  // namespace

Objective choose_objective(const std::string& name) {
  const std::vector<std::string> names = objective_names();
  if (std::ranges::find(names, name) != names.end()) return {name};
  if (const Metric* metric = find_metric(name)) refuse(*metric);
  fail_input(fmt::format("unknown objective '{}'", name), {}, suggest_name(name, names));
}

const std::string& name_of(const Objective& objective) {
  return objective.name;
}

std::string unit_of(const Objective& objective) {
  if (const NamedObjective* named = find_named(objective.name)) return named->unit;
  const Metric* metric = find_metric(objective.name);
  return metric != nullptr ? metric->unit : "";
}

std::optional<ObjectiveValue> measure_objective(const Objective& objective, const Image& test,
                                                const Image& reference, std::span<const uint8_t> all,
                                                bool with_interval) {
  const std::vector<uint8_t> mask = known_mask(all, test);
  const Pair pair = {test, reference, mask};
  if (const NamedObjective* named = find_named(objective.name)) return named->measure(pair, with_interval);
  const Metric* metric = find_metric(objective.name);
  UMBRAMETER_ASSERT(metric != nullptr, "an objective is chosen by choose_objective");
  return measure_row(*metric, pair);
}

std::optional<double> measure_width_octaves(const Image& test, const Image& reference,
                                            std::span<const uint8_t> mask) {
  const auto octaves = measure_penumbra(test, reference, known_mask(mask, test)).width_octaves;
  return octaves ? std::optional(octaves->median) : std::nullopt;
}

FaultShares measure_fault_shares(const Image& test, const Image& reference, std::span<const uint8_t> all) {
  const std::vector<uint8_t> mask = known_mask(all, test);
  const auto profiles = measure_penumbra(test, reference, mask).profiles;
  const Faults faults =
      classify_faults(test, reference, mask, profiles, measure_envelope(test, reference, mask, profiles));
  if (faults.scored_pixels == 0) return {};
  const auto share = [&](FaultClass fault) {
    return static_cast<double>(faults.of(fault).pixels) / static_cast<double>(faults.scored_pixels);
  };
  return {share(FaultClass::acne), share(FaultClass::peter_panning)};
}

}  // namespace umbrameter
