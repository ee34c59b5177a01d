// SPDX-License-Identifier: Apache-2.0
#include "study/tune/search/trials.h"

namespace umbrameter {

Trials::Trials(const SearchSpace& space, const ParameterValues& base, const ObjectiveFunction& objective,
               const SearchBudget& budget, const IsActive& is_active)
    : space_(space), base_(base), objective_(objective), budget_(budget), is_active_(is_active) {}

double Trials::at(const Point& point) {
  ParameterValues values = without_inactive(space_, is_active_, values_at(space_, point, base_), base_);
  const std::string key = key_of(values);
  if (const auto found = known_.find(key); found != known_.end()) return all_[found->second].objective;
  if (is_over() && !all_.empty()) return std::numeric_limits<double>::infinity();
  const double objective = objective_(values);
  known_[key] = all_.size();
  all_.push_back({std::move(values), point, objective});
  if (objective < best().objective) best_ = all_.size() - 1;
  return objective;
}

bool Trials::is_active(size_t axis) const {
  return !is_active_ || is_active_(space_[axis], best().values);
}

bool Trials::is_over() const {
  return left() == 0 || (budget_.is_time_up && budget_.is_time_up());
}

std::string key_of(const ParameterValues& values) {
  std::string key;
  for (const auto& [name, value] : values) key += name + "=" + to_text(value) + "\n";
  return key;
}

std::vector<ParameterValues> best_values(const std::vector<TuneTrial>& trials, size_t count) {
  std::vector<const TuneTrial*> order;
  for (const TuneTrial& trial : trials) order.push_back(&trial);
  std::ranges::stable_sort(order, {}, &TuneTrial::objective);
  order.resize(std::min(order.size(), count));
  std::vector<ParameterValues> values;
  for (const TuneTrial* trial : order) values.push_back(trial->values);
  return values;
}

}  // namespace umbrameter
