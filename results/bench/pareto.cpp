// SPDX-License-Identifier: Apache-2.0
#include "results/bench/pareto.h"

#include <algorithm>

namespace umbrameter {
namespace {

using Measure = std::optional<Interval> (*)(const BenchEntry&);

std::optional<Interval> rmse_of(const BenchEntry& entry) {
  return entry.rmse();
}

std::optional<Interval> time_of(const BenchEntry& entry) {
  return entry.time_ms;
}

bool is_below(const Interval& a, const Interval& b) {
  return a.high < b.low;
}

bool dominates(const BenchEntry& a, const BenchEntry& b) {
  return is_below(*a.time_ms, *b.time_ms) && is_below(*a.rmse(), *b.rmse());
}

/// The smallest `wanted` where `limited` stays under `limit`.
Ranking smallest(std::span<const BenchEntry> entries, Measure wanted, Measure limited, double limit) {
  Ranking ranking;
  for (size_t i = 0; i < entries.size(); ++i) {
    const BenchEntry& entry = entries[i];
    if (entry.has_place && limited(entry)->high < limit) ranking.push_back(i);
  }
  const auto value = [&](size_t i) { return wanted(entries[i])->value; };
  std::ranges::stable_sort(ranking, {}, value);
  std::erase_if(ranking, [&, best = ranking.empty() ? size_t{0} : ranking.front()](size_t i) {
    return is_below(*wanted(entries[best]), *wanted(entries[i]));
  });
  return ranking;
}

}  // namespace

void find_front(std::vector<BenchEntry>& entries) {
  for (BenchEntry& entry : entries)
    entry.has_place = !entry.failure && entry.time_ms.has_value() && entry.rmse().has_value();
  for (BenchEntry& entry : entries) {
    entry.dominated_by.reset();
    if (!entry.has_place) continue;
    const BenchEntry* fastest = nullptr;
    for (const BenchEntry& other : entries) {
      if (!other.has_place || !dominates(other, entry)) continue;
      if (fastest == nullptr || other.time_ms->value < fastest->time_ms->value) fastest = &other;
    }
    if (fastest != nullptr) entry.dominated_by = fastest->label;
  }
}

Ranking best_under(std::span<const BenchEntry> entries, double limit_ms) {
  return smallest(entries, rmse_of, time_of, limit_ms);
}

Ranking cheapest_below_rmse(std::span<const BenchEntry> entries, double limit) {
  return smallest(entries, time_of, rmse_of, limit);
}

}  // namespace umbrameter
