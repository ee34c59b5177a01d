// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/verbs.h"
#include "results/catalogue.h"
#include "results/json/run_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

/// "error: 0.03 + 25 %": what may be added to the baseline's.
std::string gate_text(const Metric& metric) {
  if (!metric.gate) return "";
  const GateLimit& limit = metric.gate->limit;
  return fmt::format("{}: {:g} + {:g} %", name_of(metric.gate->kind), limit.excess, 100.0 * limit.share);
}

std::string term_text(const Metric& metric) {
  return metric.term ? fmt::format("{} / {:g}", metric.term->name, metric.term->one) : "";
}

int print_metrics(const GlobalOptions& global) {
  if (global.json) {
    print_json({{"metrics", catalogue_json()}});
    return kExitFine;
  }
  std::vector<std::vector<std::string>> rows;
  for (const Metric& metric : metric_catalogue())
    rows.push_back({metric.key, metric.group, metric.unit, std::string(name_of(metric.better)),
                    gate_text(metric), term_text(metric), metric.doc});
  print_answer(format_table({"metric", "group", "unit", "better", "gate", "in faults", "what it is"}, rows));
  return kExitFine;
}

}  // namespace

void add_metrics(CLI::App& app, CommandLine& line) {
  CLI::App* verb = app.add_subcommand("metrics", "list every number that a run is given (docs/metrics.md)");
  verb->fallthrough();
  verb->callback([&line] { line.verb = [&line] { return print_metrics(line.global); }; });
}

}  // namespace umbrameter
