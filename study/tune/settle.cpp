// SPDX-License-Identifier: Apache-2.0
#include "study/tune/settle.h"

#include <algorithm>
#include <numeric>

namespace umbrameter {
namespace {

constexpr size_t kFinalists = 5;

class Settling {
 public:
  Settling(Judge& searched, Judge* checked) : searched_(searched), checked_(checked) {}

  const ParameterValues& best_of(std::span<const ParameterValues> all) {
    return *std::ranges::min_element(all, {}, [&](const ParameterValues& values) { return score(values); });
  }

  bool is_worse_somewhere(const ParameterValues& values, const ParameterValues& other) {
    if (searched_.ratio(values) > searched_.ratio(other)) return true;
    return checked_ != nullptr && checked_->ratio(values) > checked_->ratio(other);
  }

  bool is_worth(const ParameterValues& change, const ParameterValues& plain) {
    return score(plain) > (1.0 + kWorthChanging) * score(change) && !is_worse_somewhere(change, plain);
  }

 private:
  /// Mean ratio over all cameras.
  double score(const ParameterValues& values) {
    std::vector<double> ratios = searched_.ratios(values);
    if (checked_ != nullptr) {
      const std::vector<double>& more = checked_->ratios(values);
      ratios.insert(ratios.end(), more.begin(), more.end());
    }
    return mean_of(ratios);
  }

  Judge& searched_;
  Judge* checked_;
};

/// The best on the cameras searched, as many as finalists: only they are asked on the others.
std::vector<ParameterValues> first_of(std::span<const ParameterValues> all, Judge& searched) {
  std::vector<ParameterValues> sorted(all.begin(), all.end());
  std::ranges::stable_sort(sorted, {}, [&](const ParameterValues& values) { return searched.ratio(values); });
  sorted.resize(std::min(sorted.size(), kFinalists));
  return sorted;
}

}  // namespace

ParameterValues settle(const SearchSpace& space, const SearchResult& found,
                       std::span<const ParameterValues> by_hand, Judge& searched, Judge* checked) {
  Settling settling(searched, checked);
  const ParameterValues plain = settling.best_of(first_of(by_hand, searched));
  const std::vector<ParameterValues> finalists = best_values(found.trials, kFinalists);
  const ParameterValues best = settling.best_of(finalists);
  if (!settling.is_worth(best, plain)) return plain;
  std::vector<size_t> weakest_first(space.size());
  std::iota(weakest_first.begin(), weakest_first.end(), size_t{0});
  std::ranges::stable_sort(weakest_first, {}, [&](size_t i) { return found.effects[i].relative_spread; });
  ParameterValues kept = best;
  for (const size_t i : weakest_first) {
    ParameterValues plainer = kept;
    plainer[space[i].name] = plain.at(space[i].name);
    if (settling.is_worth(best, plainer) || settling.is_worse_somewhere(plainer, plain)) continue;
    kept = plainer;
  }
  return kept;
}

}  // namespace umbrameter
