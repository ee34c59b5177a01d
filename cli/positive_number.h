// SPDX-License-Identifier: Apache-2.0
#pragma once
// A check of options: CLI::PositiveNumber answers with the 310 digits of the largest double.

#include <CLI/CLI.hpp>

#include <cmath>
#include <string>

namespace umbrameter {

/// Finite and above 0.
inline CLI::Validator positive_number() {
  const auto check = [](const std::string& text) {
    double value = 0.0;
    const bool is_right = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0.0;
    return is_right ? std::string() : "'" + text + "' is not a number above 0";
  };
  return {check, "POSITIVE"};
}

}  // namespace umbrameter
