// SPDX-License-Identifier: Apache-2.0
#include "core/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace umbrameter {

namespace {

size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
    }
  }
  return row[b.size()];
}

size_t common_start(std::string_view a, std::string_view b) {
  const auto [end, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<size_t>(end - a.begin());
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> known) {
  std::string best;
  size_t best_distance = std::max<size_t>(1, name.size() / 2) + 1;
  size_t best_start = 0;
  for (const std::string& candidate : known) {
    const size_t distance = edit_distance(name, candidate);
    const size_t start = common_start(name, candidate);
    const bool is_nearer =
        distance < best_distance || (distance == best_distance && !best.empty() && start > best_start);
    if (!is_nearer) continue;
    best_distance = distance;
    best_start = start;
    best = candidate;
  }
  return best;
}

std::string suggest_name(std::string_view name, std::span<const std::string> known) {
  if (known.empty()) return {};
  const std::string nearest = nearest_name(name, known);
  if (!nearest.empty()) return fmt::format("did you mean '{}'?", nearest);
  return fmt::format("known: {}", fmt::join(known, ", "));
}

}  // namespace umbrameter
