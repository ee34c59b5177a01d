// SPDX-License-Identifier: Apache-2.0
#include "metrics/better.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace umbrameter {
namespace {

constexpr std::array<std::string_view, 4> kBetterNames = {"lower", "higher", "nearest_zero", "nearest_one"};

}  // namespace

std::string_view name_of(Better better) {
  return kBetterNames[static_cast<size_t>(better)];
}

double badness(Better better, double value) {
  switch (better) {
    case Better::lower:
      return value;
    case Better::higher:
      return -value;
    case Better::nearest_zero:
      return std::abs(value);
    case Better::nearest_one:
      return std::abs(value - 1.0);
  }
  return value;
}

}  // namespace umbrameter
