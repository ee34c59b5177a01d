// SPDX-License-Identifier: Apache-2.0
#include "results/metric_choice.h"

#include "core/error.h"
#include "core/names.h"
#include "results/catalogue.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace umbrameter {

MetricChoice choose_metrics(std::string_view list) {
  if (list.empty()) return {};
  static const std::array<std::string, 5> known = {"error", "significance", "verdict", "diagnosis",
                                                   "similarity"};
  MetricChoice choice = {false, false, false, false};
  for (size_t begin = 0; begin <= list.size();) {
    const size_t end = std::min(list.find(',', begin), list.size());
    const std::string_view name = list.substr(begin, end - begin);
    if (name == "significance") choice.significance = true;
    if (name == "verdict") choice.verdict = true;
    if (name == "diagnosis") choice.diagnosis = true;
    if (name == "similarity") choice.similarity = true;
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const Metric* row = find_metric(name);
      if (row == nullptr) fail_input(fmt::format("unknown metric '{}'", name), {}, suggest_name(name, known));
      fail_input(fmt::format("'{}' is one number; --metrics takes whole parts", name), {},
                 fmt::format("known: {}", fmt::join(known, ", ")));
    }
    begin = end + 1;
  }
  return choice;
}

}  // namespace umbrameter
