#include "study/tune/judge.h"

#include "core/error.h"
#include "study/guard.h"

#include <algorithm>
#include <limits>

namespace umbrameter {
namespace {

constexpr double kLeastScale = 1e-4;  // below it defaults are perfect, and their noise is no scale
constexpr double kNone = std::numeric_limits<double>::infinity();

}  // namespace

Judge::Judge(Studio& studio, std::vector<View> views, Objective objective, const ParameterValues& defaults)
    : studio_(studio), views_(std::move(views)), objective_(objective) {
  std::vector<std::optional<ObjectiveValue>> measures;
  for (const View& view : views_) {
    const Frame frame = studio.render(view, defaults);
    const auto measured = measure_objective(objective, frame.image, view.reference, view.mask, false);
    if (!measured) {
      fail_input(fmt::format("{} has nothing that objective '{}' measures", view.name, name_of(objective)),
                 {}, "choose another objective");
    }
    scales_.push_back(std::max(measured->value, kLeastScale));
    measures.push_back(measured);
  }
  known_[key_of(defaults)] = ratio_of(measures);
}

double Judge::ratio(const ParameterValues& values) {
  const auto [place, is_new] = known_.try_emplace(key_of(values), kNone);
  if (!is_new) return place->second;
  std::vector<std::optional<ObjectiveValue>> measures;
  for (size_t i = 0; i < views_.size(); ++i) {
    measures.push_back(measure(i, values, false));
    if (!measures.back()) return kNone;
  }
  return place->second = ratio_of(measures);
}

std::optional<ObjectiveValue> Judge::measure(size_t view, const ParameterValues& values) const {
  return measure(view, values, true);
}

std::optional<ObjectiveValue> Judge::measure(size_t index, const ParameterValues& values,
                                             bool with_interval) const {
  const View& view = views_[index];
  std::optional<ObjectiveValue> measured;
  // Values that a technique's constraints forbid fail here: a wall of the search, not its end.
  guarded([&] {
    const Frame frame = studio_.render(view, values);
    measured = measure_objective(objective_, frame.image, view.reference, view.mask, with_interval);
  });
  return measured;
}

double Judge::ratio_of(const std::vector<std::optional<ObjectiveValue>>& measures) const {
  double sum = 0.0;
  for (size_t i = 0; i < measures.size(); ++i) {
    if (!measures[i]) return kNone;
    sum += measures[i]->value / scales_[i];
  }
  return sum / static_cast<double>(measures.size());
}

}  // namespace umbrameter
