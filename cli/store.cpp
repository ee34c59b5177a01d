// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/staging.h"
#include "cli/sweep_text.h"
#include "cli/sweep_verbs.h"
#include "core/error.h"
#include "core/files.h"
#include "core/names.h"
#include "lab/merge.h"
#include "lab/stored_runs.h"
#include "lab/verdicts.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

int merge(const std::vector<std::string>& folders, const GlobalOptions& global) {
  if (global.out.empty()) fail_input("merged results need a folder", {}, "give --out DIR");
  for (const std::string& folder : folders) {
    if (!has_store(folder))
      Store(folder, Database::Mode::read);  // says what is wrong before anything is written
    std::error_code ignored;
    if (!std::filesystem::equivalent(folder, global.out, ignored)) continue;
    fail_input(fmt::format("'{}' cannot be merged into itself", folder), {}, "choose another --out");
  }
  Store into(global.out, Database::Mode::write);
  set_interruption_note("interrupted; what was merged is stored, the same command goes on from there");
  MergeCounts counts;
  for (const std::string& folder : folders) {
    Store from(folder, Database::Mode::read);
    const MergeCounts added = merge_store(from, into);
    counts.added += added.added;
    counts.present += added.present;
    print_warnings(from);
  }
  print_warnings(into);
  if (global.json) {
    print_json({{"added", counts.added}, {"present", counts.present}});
  } else {
    print_answer(fmt::format("{} entries added, {} were there already\n", counts.added, counts.present));
  }
  return kExitFine;
}

struct ExportOptions {
  std::string folder;
  bool csv = false;
  bool all = false;
  std::string baseline;
};

void require_label(const std::vector<RunRecord>& runs, const std::string& label) {
  std::vector<std::string> known;
  for (const RunRecord& run : runs) known.push_back(run.result.label);
  if (label.empty() || std::ranges::find(known, label) != known.end()) return;
  fail_input(fmt::format("no stored run is labelled '{}', which --baseline names", label), {},
             suggest_name(label, known));
}

int export_store(const ExportOptions& options, const GlobalOptions& global) {
  if (options.csv && global.json) fail_input("both --csv and --json are given", {}, "choose one");
  Store store(options.folder, Database::Mode::read);
  StoredRuns runs = stored_runs(store, options.all);
  require_label(runs.runs, options.baseline);
  judge_runs(store, runs.runs, options.baseline);
  print_warnings(store);
  if (runs.older > 0)
    print_note(fmt::format("{} older results of the same runs are left out (--all shows them)", runs.older));
  if (runs.foreign > 0)
    print_warning(fmt::format("{} results of another version are left out", runs.foreign));
  const std::string text = global.json ? to_json_text(runs) : options.csv ? to_csv(runs) : stored_text(runs);
  if (global.out.empty()) {
    print_answer(text);
    return kExitFine;
  }
  if (std::filesystem::is_directory(global.out))
    fail_input(fmt::format("'{}' is a folder", global.out), {}, "--out of 'export' is the file to write");
  write_file_atomically(global.out, text);
  print_note(fmt::format("wrote {}", global.out));
  return kExitFine;
}

}  // namespace

void print_warnings(Store& store) {
  print_warnings(store.take_warnings());
}

void add_merge(CLI::App& app, CommandLine& line) {
  auto folders = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = app.add_subcommand("merge", "add the results of several sweeps to the store --out");
  verb->fallthrough();
  verb->add_option("folders", *folders, "--out folders of sweeps")->required();
  verb->callback([folders, &line] { line.verb = [folders, &line] { return merge(*folders, line.global); }; });
}

void add_export(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* verb = app.add_subcommand(
      "export", "print the runs of a store, or write them to the file --out: ranked, as --csv or as --json");
  verb->fallthrough();
  verb->add_option("folder", options->folder, "--out folder of a sweep")->required();
  verb->add_flag("--csv", options->csv, "one line a run, with a column for each parameter");
  verb->add_option("--baseline", options->baseline,
                   "label of the run that verdicts are against; default: each scene's first in its sweep");
  verb->add_flag("--all", options->all,
                 "also results that were made again since, by other code or on another device");
  verb->callback(
      [options, &line] { line.verb = [options, &line] { return export_store(*options, line.global); }; });
}

}  // namespace umbrameter
