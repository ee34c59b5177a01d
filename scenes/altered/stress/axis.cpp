// SPDX-License-Identifier: Apache-2.0
#include "scenes/altered/stress/axis.h"

#include <fmt/format.h>

namespace umbrameter {

std::vector<StressValue> numbers(const std::vector<double>& values) {
  std::vector<StressValue> out;
  for (const double value : values) out.push_back({fmt::format("{:g}", value), value});
  return out;
}

std::vector<StressValue> words(const std::vector<std::string>& values) {
  std::vector<StressValue> out;
  for (const std::string& value : values) out.push_back({value, 0.0});
  return out;
}

}  // namespace umbrameter
