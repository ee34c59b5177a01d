// SPDX-License-Identifier: Apache-2.0
#include "lab/causes/replacement.h"

#include "core/error.h"
#include "lab/causes/light_parts.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

using enum RunPart;

constexpr std::string_view kWholeScene = "scene";  // the choice of a map's fit that leaves nothing out
constexpr uint64_t kMostMemory_bytes = uint64_t{2} << 30;

bool is_number(const Parameter& parameter) {
  return parameter.type == ParameterType::integer || parameter.type == ParameterType::real;
}

bool is_length_in_texels(const Parameter& parameter) {
  return is_number(parameter) && parameter.unit == "texels";
}

bool is_of_maps(const Parameter& parameter) {
  return parameter.group == "shadow_map" || parameter.group == "cascades";
}

bool is_size_of_map(const Parameter& parameter) {
  return is_of_maps(parameter) && is_length_in_texels(parameter) && parameter.scale == ParameterScale::pow2;
}

/// A linear number of taps is the side of a grid, whose width it changes, too.
bool is_count_of_taps(const Parameter& parameter) {
  if (parameter.type != ParameterType::integer || parameter.scale == ParameterScale::linear) return false;
  return parameter.unit == "taps" || parameter.unit == "patches" ||
         (parameter.group == "light" && parameter.unit == "count");
}

bool is_size_of_filter(const Parameter& parameter) {
  if (!is_number(parameter)) return false;
  const bool is_length = parameter.unit == "texels" || parameter.unit == "world";
  const bool is_scale_of_light = parameter.unit == "none" && parameter.scale == ParameterScale::log;
  return (parameter.group == "filter" && is_length) || (parameter.group == "light" && is_scale_of_light);
}

bool is_fit(const Parameter& parameter) {
  return parameter.type == ParameterType::choice && is_of_maps(parameter) &&
         std::ranges::find(parameter.choices, kWholeScene) != parameter.choices.end();
}

/// Notes what became of one parameter; whether anything did.
bool set_value(const Parameter& parameter, const ParameterValue& value, const char* remark,
               Replacement& out) {
  ParameterValue& current = out.parameters.at(parameter.name);
  const std::string from = to_text(current), to = to_text(value);
  if (from == to) return false;
  current = value;
  out.changes.push_back(fmt::format("{} {} -> {}{}", parameter.name, from, to, remark));
  return true;
}

/// Within its range. Whether anything changed.
bool set_number(const Parameter& parameter, double wanted, Replacement& out) {
  const double number = std::clamp(wanted, parameter.min, parameter.max);
  const char* remark = number < wanted ? " (its largest)" : number > wanted ? " (its smallest)" : "";
  return set_value(parameter, value_of_number(parameter, number), remark, out);
}

double number_of(const Parameter& parameter, const ParameterValues& values) {
  return numeric_value(parameter, values.at(parameter.name));
}

/// What is 0 grows from its default.
template <class IsPart>
bool scale_numbers(const SubstitutedRun& run, double factor, const IsPart& is_part, Replacement& out) {
  bool is_changed = false;
  for (const Parameter& declared : run.declared) {
    if (!is_part(declared)) continue;
    const Parameter parameter = in_world(declared, run.diagonal_world);
    const double number = number_of(parameter, run.parameters);
    const bool grows_from_default = number == 0.0 && factor > 1.0;
    const double base = grows_from_default ? numeric_value(parameter, parameter.default_value) : number;
    is_changed = set_number(parameter, factor * base, out) || is_changed;
  }
  return is_changed;
}

/// The largest power of two up to `factor` with which the run's textures stay small enough, and sizes and lengths in texels
/// within their ranges: a filter that cannot grow along would be another filter.
double affordable(const SubstitutedRun& run, double factor) {
  const auto fits = [&](double by) {
    const bool fits_memory =
        by * by * static_cast<double>(run.memory_bytes) <= static_cast<double>(kMostMemory_bytes);
    return fits_memory && std::ranges::all_of(run.declared, [&](const Parameter& parameter) {
             return !is_length_in_texels(parameter) ||
                    by * number_of(parameter, run.parameters) <= parameter.max;
           });
  };
  while (factor > 1.0 && !fits(factor)) factor /= 2.0;
  return factor;
}

/// The next smaller factor that maps grow by; 1 for the smallest.
double tried_before(double factor) {
  double before = 1.0;
  for (const Substitution& other : substitutions()) {
    if (other.part == map_size && other.factor < factor) before = std::max(before, other.factor);
  }
  return before;
}

/// Lengths in texels stay as long in the world. Not where that is no larger than the map of a smaller substitution.
bool grow_map(const SubstitutedRun& run, double wanted, Replacement& out) {
  const double factor = affordable(run, wanted);
  if (factor <= tried_before(wanted) || !scale_numbers(run, factor, is_size_of_map, out)) return false;
  keep_lengths(run, factor, out);
  return true;
}

bool fit_whole_scene(const SubstitutedRun& run, Replacement& out) {
  bool is_changed = false;
  for (const Parameter& parameter : run.declared) {
    if (is_fit(parameter)) is_changed = set_value(parameter, std::string(kWholeScene), "", out) || is_changed;
  }
  out.moves_texels = is_changed;
  return is_changed;
}

bool is_group(const SubstitutedRun& run, std::string_view group) {
  return std::ranges::any_of(run.declared, [&](const Parameter& p) { return p.group == group; });
}

bool apply(const Substitution& substitution, const SubstitutedRun& run, Replacement& out) {
  switch (substitution.part) {
    case bias:
      return scale_numbers(
          run, substitution.factor, [](const Parameter& p) { return is_number(p) && p.group == "bias"; },
          out);
    case map_size:
      return grow_map(run, substitution.factor, out);
    case taps:
      return scale_numbers(run, substitution.factor, is_count_of_taps, out);
    case map_fit:
      return fit_whole_scene(run, out);
    case filter_size:
      return scale_numbers(run, substitution.factor, is_size_of_filter, out);
    case light_points:
      if (!is_group(run, "shadow_map") && !is_group(run, "cascades")) return false;
      out.lights = light_parts(run.light);
      return true;
    case blocker_distance:
      out.takes_blocker_truth = true;
      return is_group(run, "search");
  }
  return false;
}

}  // namespace

std::optional<Replacement> replace(const Substitution& substitution, const SubstitutedRun& run) {
  Replacement out;
  out.parameters = run.parameters;
  out.lights = {run.light};
  if (!apply(substitution, run, out)) return std::nullopt;
  return out;
}

bool keep_lengths(const SubstitutedRun& run, double factor, Replacement& replacement) {
  const auto is_length = [&](const Parameter& parameter) {
    return is_length_in_texels(parameter) && !is_size_of_map(parameter) &&
           number_of(parameter, run.parameters) != 0.0;
  };
  return scale_numbers(run, factor, is_length, replacement);
}

}  // namespace umbrameter
