// SPDX-License-Identifier: Apache-2.0
#include "cli/manual.h"

#include "cli/examples.h"
#include "core/version.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

/// roff reads "-" as a hyphen, a leading "." or "'" as a request and "\" as its own.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool starts_line = out.empty() || out.back() == '\n';
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      if (starts_line && (c == '.' || c == '\'')) out += "\\&";
      out += c;
    }
  }
  return out;
}

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

std::string option_entry(const CLI::Option& option) {
  const bool is_positional = option.get_positional();
  std::string name = roff(option.get_name(is_positional, !is_positional));
  if (!is_positional && option.get_expected_max() > 0)
    name += fmt::format(" \\fI{}\\fB", roff(option.get_type_name()));
  std::string text = fmt::format(".TP\n\\fB{}\\fR\n{}", name, roff(option.get_description()));
  if (!option.get_default_str().empty())
    text += fmt::format(" (default: {})", roff(option.get_default_str()));
  return text + "\n";
}

std::string options_of(const CLI::App& app, bool with_help) {
  std::string text;
  for (const CLI::Option* option : app.get_options()) {
    const bool is_help = option == app.get_help_ptr();
    if (!option->get_group().empty() && (with_help || !is_help)) text += option_entry(*option);
  }
  return text;
}

std::string verb_section(const CLI::App& verb, const std::string& path) {
  std::string text = fmt::format(".SS {}\n{}\n", roff(path), roff(verb.get_description()));
  text += options_of(verb, false);
  const std::vector<std::string> examples = examples_of(path);
  if (!examples.empty()) text += ".PP\nExamples:\n";
  for (const std::string& example : examples) text += fmt::format(".PP\n.nf\n{}\n.fi\n", roff(example));
  for (const CLI::App* part : verbs_of(verb)) text += verb_section(*part, path + " " + part->get_name());
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH UMBRAMETER 1 \"\" \"umbrameter {}\" \"User Commands\"\n.SH NAME\numbrameter \\- measure how wrong "
      "a "
      "real\\-time shadow is, why, and what it costs\n.SH SYNOPSIS\n.B umbrameter\n[\\fIOPTION\\fR]... "
      "\\fIVERB\\fR [\\fIARGUMENT\\fR]...\n.SH DESCRIPTION\n{}\nOptions before or after the verb mean the "
      "same.\n.SH OPTIONS\n",
      kVersion, roff(app.get_description()));
  text += options_of(app, true) + ".SH VERBS\n";
  for (const CLI::App* verb : verbs_of(app)) text += verb_section(*verb, verb->get_name());
  text +=
      ".SH EXIT STATUS\n0 fine, 1 a gate failed, 2 bad input or usage, 3 the environment lacks something, 4 "
      "a bug of\numbrameter.\n.SH ENVIRONMENT\n.TP\n\\fBUMBRAMETER_ASSETS\\fR\nthe folder with models, as "
      "\\-\\-assets\n.TP\n\\fBUMBRAMETER_HOME\\fR\nthe folder that holds scenes/library, "
      "realtime/techniques and realtime/shaders\n.SH FILES\n.TP\n\\fI../share/umbrameter\\fR\nscenes, "
      "techniques and shaders, relative to the program\n";
  return text;
}

}  // namespace umbrameter
