// SPDX-License-Identifier: Apache-2.0
#include "cli/duration.h"

#include "core/error.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace umbrameter {

double milliseconds(const std::string& option, const std::string& text) {
  struct Unit {
    std::string_view name;
    double ms;
  };
  constexpr std::array<Unit, 4> kUnits{{{"ms", 1.0}, {"us", 1e-3}, {"s", 1e3}, {"min", 6e4}}};
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string_view unit(end, static_cast<size_t>(text.data() + text.size() - end));
  while (unit.starts_with(' ')) unit.remove_prefix(1);
  for (const Unit& known : kUnits) {
    if (problem == std::errc() && unit == known.name && std::isfinite(value) && value > 0.0)
      return value * known.ms;
  }
  fail_input(fmt::format("{} is '{}', not a time", option, text), {}, "a number with its unit, such as 1ms");
}

}  // namespace umbrameter
