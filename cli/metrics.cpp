// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/verbs.h"
#include "results/catalogue.h"
#include "results/json/run_json.h"

#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

int print_metrics(const GlobalOptions& global) {
  if (global.json) {
    print_json({{"schema", 1}, {"metrics", catalogue_json()}});
    return kExitFine;
  }
  std::vector<std::vector<std::string>> rows;
  for (const Metric& metric : metric_catalogue())
    rows.push_back({metric.key, metric.group, metric.unit, std::string(name_of(metric.better)), metric.doc});
  print_answer(format_table({"metric", "group", "unit", "better", "what it is"}, rows));
  return kExitFine;
}

}  // namespace

void add_metrics(CLI::App& app, CommandLine& line) {
  CLI::App* verb = app.add_subcommand("metrics", "list every number that a run is given (docs/metrics.md)");
  verb->fallthrough();
  verb->callback([&line] { line.verb = [&line] { return print_metrics(line.global); }; });
}

}  // namespace umbrameter
