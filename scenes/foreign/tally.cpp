// SPDX-License-Identifier: Apache-2.0
#include "scenes/foreign/tally.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {

void Tally::add(const std::string& one, const std::string& many) {
  const auto known = std::ranges::find(kinds_, many, &Kind::many);
  if (known != kinds_.end())
    ++known->count;
  else
    kinds_.push_back({one, many, 1});
}

void Tally::leave_out(const std::string& noun, const std::string& type) {
  add(fmt::format("{} of type '{}' is left out", noun, type),
      fmt::format("{}s of type '{}' are left out", noun, type));
}

std::vector<std::string> Tally::lines() const {
  std::vector<std::string> lines;
  for (const Kind& kind : kinds_)
    lines.push_back(fmt::format("{} {}", kind.count, kind.count == 1 ? kind.one : kind.many));
  return lines;
}

}  // namespace umbrameter
