// SPDX-License-Identifier: Apache-2.0
#include "report/report.h"

#include "cli/console.h"
#include "cli/verbs.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

int make_report(const std::string& folder, const GlobalOptions& global) {
  const std::filesystem::path file =
      global.out.empty() ? std::filesystem::path(folder) / "report.html" : std::filesystem::path(global.out);
  write_report(folder, file);
  if (global.json) {
    print_json({{"file", file.string()}});
  } else {
    print_answer(fmt::format("wrote {}\n", file.string()));
  }
  return kExitFine;
}

}  // namespace

void add_report(CLI::App& app, CommandLine& line) {
  auto folder = std::make_shared<std::string>();
  CLI::App* verb =
      app.add_subcommand("report", "make the HTML page of a results folder (default DIR/report.html)");
  verb->fallthrough();
  verb->add_option("folder", *folder,
                   "folder that validate, score, sweep, bench, tune, stress or regress wrote")
      ->required();
  verb->callback(
      [folder, &line] { line.verb = [folder, &line] { return make_report(*folder, line.global); }; });
}

}  // namespace umbrameter
