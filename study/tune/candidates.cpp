// SPDX-License-Identifier: Apache-2.0
#include "study/tune/candidates.h"

#include <algorithm>

namespace umbrameter {
namespace {

bool is_cost(const Parameter& parameter, const SearchSpace& space) {
  if (std::ranges::find(space, parameter.name, &Parameter::name) != space.end()) return false;
  return !parameter.tune || is_cost_like(parameter);
}

ParameterValues with(ParameterValues values, const ParameterValues& changed) {
  for (const auto& [name, value] : changed) values[name] = value;
  return values;
}

void add(std::vector<Candidate>& all, const std::string& name, bool same_cost, ParameterValues values) {
  const auto same = std::ranges::find(all, values, &Candidate::values);
  if (same != all.end()) {
    same->name += ", " + name;
    return;
  }
  Candidate candidate;
  candidate.name = name;
  candidate.same_cost = same_cost;
  candidate.values = std::move(values);
  all.push_back(std::move(candidate));
}

}  // namespace

std::vector<Candidate> make_candidates(const TunePlan& plan, const SearchSpace& space) {
  const ParameterValues& base = plan.technique.parameters;
  std::vector<Candidate> all;
  add(all, "default", true, base);
  for (const NamedValues& preset : plan.presets) {
    ParameterValues at_same_cost;
    for (const auto& [name, value] : preset.values) {
      if (!is_cost(find_parameter(plan.parameters, name, plan.technique.id), space))
        at_same_cost[name] = value;
    }
    const ParameterValues given = with(base, preset.values), cheap = with(base, at_same_cost);
    add(all, preset.name, true, cheap);
    if (given != cheap) add(all, preset.name + " (own cost)", false, given);
  }
  return all;
}

}  // namespace umbrameter
