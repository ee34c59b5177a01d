// SPDX-License-Identifier: Apache-2.0
#include "report/report.h"

#include "cli/console.h"
#include "cli/verbs.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

struct ReportOptions {
  std::string folder, before;
};

int make_report(const ReportOptions& options, const GlobalOptions& global) {
  const std::filesystem::path folder = options.folder;
  const std::filesystem::path file =
      global.out.empty() ? folder / "report.html" : std::filesystem::path(global.out);
  write_report(folder, file, kPageBudget_bytes, {}, options.before);
  if (global.json) {
    print_json({{"file", file.string()}});
  } else {
    print_answer(fmt::format("wrote {}\n", file.string()));
  }
  return kExitFine;
}

}  // namespace

void add_report(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* verb =
      app.add_subcommand("report", "make the HTML page of a results folder (default DIR/report.html)");
  verb->fallthrough();
  verb->add_option("folder", options->folder,
                   "folder that validate, score, sweep, bench, tune, stress or regress wrote")
      ->required();
  verb->add_option("--before", options->before,
                   "an earlier folder of the same scenes: its pictures to slide against those of now");
  verb->callback(
      [options, &line] { line.verb = [options, &line] { return make_report(*options, line.global); }; });
}

}  // namespace umbrameter
