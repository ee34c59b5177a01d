// SPDX-License-Identifier: Apache-2.0
// Help by word, and the same text for man(1) and shells.

#include "cli/console.h"
#include "cli/manual.h"
#include "cli/verbs.h"
#include "core/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace umbrameter {
namespace {

struct HelpOptions {
  std::vector<std::string> path;
  std::string completions;
  bool manual = false;
};

const CLI::App& find_verb(const CLI::App& app, const std::vector<std::string>& path) {
  const CLI::App* verb = &app;
  for (const std::string& name : path) {
    const std::vector<const CLI::App*> choices = verb->get_subcommands([](const CLI::App*) { return true; });
    std::vector<std::string> known;
    const CLI::App* found = nullptr;
    for (const CLI::App* choice : choices) {
      known.push_back(choice->get_name());
      if (choice->get_name() == name) found = choice;
    }
    if (found == nullptr)
      fail_input(fmt::format("there is no verb '{}' to explain", name), {}, suggest_name(name, known));
    verb = found;
  }
  return *verb;
}

std::vector<std::string> with_program(const CLI::App& app, std::vector<std::string> path) {
  path.insert(path.begin(), app.get_name());
  return path;
}

int help(const HelpOptions& options, const CLI::App& app) {
  if (!options.completions.empty()) {
    print_answer(completions(app, options.completions));
  } else if (options.manual) {
    print_answer(manual_page(app));
  } else {
    const CLI::App& verb = find_verb(app, options.path);
    const std::string name = fmt::format("{}", fmt::join(with_program(app, options.path), " "));
    print_answer(verb.get_formatter()->make_help(&verb, name, CLI::AppFormatMode::Normal));
  }
  return kExitFine;
}

}  // namespace

void add_help(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<HelpOptions>();
  CLI::App* verb = app.add_subcommand("help", "what a verb does and takes: help validate");
  verb->fallthrough();
  verb->add_option("verb", options->path, "a verb, and a part of it: help scene check");
  verb->add_flag("--man", options->manual, "print the manual page for man(1)");
  verb->add_option("--completions", options->completions, "print the completions for bash, zsh or fish");
  verb->callback([options, &app, &line] { line.verb = [options, &app] { return help(*options, app); }; });
}

}  // namespace umbrameter
