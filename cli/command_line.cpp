// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"

#include "cli/console.h"
#include "cli/examples.h"
#include "cli/ignored_options.h"
#include "cli/sweep_verbs.h"
#include "cli/verbs.h"
#include "cli/view_verb.h"
#include "core/names.h"
#include "core/version.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

void add_global_options(CLI::App& app, GlobalOptions& options) {
  app.add_option("--assets", options.assets, "folder with the models that asset scenes need")
      ->envname("UMBRAMETER_ASSETS");
  app.add_option("--device", options.device, "GL device: index or part of its name (see doctor)");
  app.add_option("-o,--out", options.out, "output file or folder");
  app.add_option("--threads", options.threads, "threads of the reference; 0 = all")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  app.add_flag("--json", options.json, "print one JSON object and nothing else");
}

/// CLI11 only says that a command is missing; this names the one that it did not know.
std::string usage_problem(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* verb = &app;
  while (!verb->get_subcommands().empty()) verb = verb->get_subcommands().front();
  std::vector<std::string> known;
  for (const CLI::App* choice : verb->get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(choice->get_name());
  }
  const std::vector<std::string> unknown = app.remaining(true);
  if (known.empty() || unknown.empty() || unknown.front().starts_with('-')) return error.what();
  return fmt::format("unknown command '{}' ({})", unknown.front(), suggest_name(unknown.front(), known));
}

struct VerbGroup {
  const char* title;
  std::vector<const char*> verbs;
};

/// The headings of --help; a verb that none of them lists stands under CLI11's own.
void group_verbs(CLI::App& app) {
  const VerbGroup groups[] = {
      {"Measure", {"validate", "score", "bench", "tune"}},
      {"Studies of many runs", {"plan", "sweep", "merge", "export", "report"}},
      {"Guard against regressions", {"regress", "stress", "selftest"}},
      {"Look at one thing", {"view", "reference", "render", "scene", "techniques", "engines", "metrics"}},
      {"Help", {"doctor", "help"}}};
  for (const VerbGroup& group : groups) {
    for (const char* name : group.verbs) app.get_subcommand(name)->group(group.title);
  }
}

}  // namespace

std::optional<int> parse_command_line(int argc, const char* const* argv, CLI::App& app, CommandLine& line) {
  app.name("umbrameter");
  app.description("Umbrameter measures how wrong a real-time shadow is, why, and what it costs.");
  app.fallthrough();
  app.require_subcommand(1);
  app.set_version_flag("--version", fmt::format("umbrameter {} ({})", kVersion, kCommit));
  app.footer(
      "Exit codes: 0 fine, 1 a gate failed, 2 bad input or usage, 3 the environment lacks something, 4 our "
      "bug.");
  add_global_options(app, line.global);
  add_validate(app, line);
  add_bench(app, line);
  add_tune(app, line);
  add_plan(app, line);
  add_sweep(app, line);
  add_merge(app, line);
  add_export(app, line);
  add_reference(app, line);
  add_render(app, line);
  add_view(app, line);
  add_score(app, line);
  add_report(app, line);
  add_techniques(app, line);
  add_engines(app, line);
  add_scene(app, line);
  add_selftest(app, line);
  add_regress(app, line);
  add_stress(app, line);
  add_metrics(app, line);
  add_doctor(app, line);
  add_help(app, line);
  group_verbs(app);
  add_examples(app);
  try {
    app.parse(argc, argv);
    warn_of_ignored_options(app);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    print_error(fmt::format("{} (see umbrameter --help)", usage_problem(app, error)));
    return kExitBadInput;
  }
  return std::nullopt;
}

}  // namespace umbrameter
