// SPDX-License-Identifier: Apache-2.0
#include "cli/manual.h"
#include "core/error.h"
#include "core/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace umbrameter {
namespace {

/// A verb with what may follow it. Words of nested verbs are joined by a blank: "scene list".
struct Choice {
  std::string path;
  std::string about;
  std::vector<std::string> verbs;
  std::vector<std::string> options;
  std::vector<std::string> option_texts;
  std::vector<bool> takes_value;
};

/// What a shell would read as its own leaves a description; only its first sentence is shown.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text.substr(0, text.find(';'))) {
    if (std::string_view("'\"`$\\[]:").find(c) == std::string_view::npos) out += c;
  }
  return out;
}

void add_options(Choice& choice, const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) {
      choice.options.push_back(name);
      choice.option_texts.push_back(plain(option->get_description()));
      choice.takes_value.push_back(option->get_expected_max() > 0);
    }
  }
}

void collect(std::vector<Choice>& choices, const CLI::App& root, const CLI::App& app,
             const std::string& path) {
  Choice choice{.path = path,
                .about = plain(app.get_description()),
                .verbs = {},
                .options = {},
                .option_texts = {},
                .takes_value = {}};
  add_options(choice, app);
  if (&app != &root) add_options(choice, root);
  const size_t place = choices.size();
  choices.push_back(choice);
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    choices[place].verbs.push_back(verb->get_name());
    collect(choices, root, *verb, path.empty() ? verb->get_name() : path + " " + verb->get_name());
  }
}

std::string join_options(const Choice& choice) {
  std::string text;
  for (const std::string& name : choice.options) text += " --" + name;
  return text;
}

std::string bash_script(const std::vector<Choice>& choices) {
  std::string text = R"(# bash completion of umbrameter
_umbrameter() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} path=umbrameter known= i
  declare -A verbs=() options=()
)";
  for (const Choice& choice : choices) {
    const std::string path = choice.path.empty() ? "umbrameter" : "umbrameter " + choice.path;
    text += fmt::format("  verbs['{0}']='{1}' options['{0}']='{2}'\n", path, fmt::join(choice.verbs, " "),
                        join_options(choice));
  }
  return text + R"(  for ((i = 1; i < COMP_CWORD; ++i)); do
    case " ${verbs[$path]} " in *" ${COMP_WORDS[i]} "*) path="$path ${COMP_WORDS[i]}" ;; esac
  done
  case $word in -*) COMPREPLY=($(compgen -W "${options[$path]}" -- "$word")); return ;; esac
  case $before in
    --technique) known=$(umbrameter techniques list 2>/dev/null | awk 'NR > 1 { print $1 }') ;;
    -*) ;;
    *) case ${path#umbrameter } in
         validate|reference|render|tune|"scene check"|"scene export"|"scene plan")
           known=$(umbrameter scene list 2>/dev/null | awk 'NR > 1 { print $1 }') ;;
       esac ;;
  esac
  COMPREPLY=($(compgen -W "${verbs[$path]} $known" -- "$word"))
}
complete -o default -F _umbrameter umbrameter
)";
}

std::string zsh_script(const std::vector<Choice>& choices) {
  std::string text = "#compdef umbrameter\n_umbrameter() {\n  local -a names\n  case \"${words[2]}";
  text += " ${words[3]}\" in\n";
  std::string top;
  for (auto choice = choices.rbegin(); choice != choices.rend(); ++choice) {  // longer paths first
    if (choice->path.empty()) continue;
    if (choice->path.find(' ') == std::string::npos)
      top = fmt::format("    '{}:{}'\n", choice->path, choice->about) + top;
    text += fmt::format("    '{}'*) ", choice->path + " ");
    if (!choice->verbs.empty())
      text += fmt::format("(( CURRENT == 3 )) && compadd {}; ", fmt::join(choice->verbs, " "));
    text += "_arguments '*:file:_files'";
    for (size_t i = 0; i < choice->options.size(); ++i) {
      text += fmt::format(" '--{}[{}]{}'", choice->options[i], choice->option_texts[i],
                          choice->takes_value[i] ? ":value:_files" : "");
    }
    text += "; return ;;\n";
  }
  return text + "  esac\n  names=(\n" + top +
         "  )\n  (( CURRENT == 2 )) && _describe verb names\n}\n_umbrameter \"$@\"\n";
}

std::string fish_script(const std::vector<Choice>& choices) {
  std::string text = "# fish completion of umbrameter\n";
  for (const Choice& choice : choices) {
    std::string when = choice.path.empty() ? "__fish_use_subcommand" : "";
    for (size_t start = 0; start < choice.path.size();) {
      const size_t end = std::min(choice.path.find(' ', start), choice.path.size());
      when += (start > 0 ? "; and " : "") +
              ("__fish_seen_subcommand_from " + choice.path.substr(start, end - start));
      start = end + 1;
    }
    for (const std::string& verb : choice.verbs) {
      const std::string path = choice.path.empty() ? verb : choice.path + " " + verb;
      const auto found = std::find_if(choices.begin(), choices.end(),
                                      [&](const Choice& other) { return other.path == path; });
      text += fmt::format("complete -c umbrameter -n '{}' -a {} -d '{}'\n", when, verb, found->about);
    }
    for (size_t i = 0; i < choice.options.size(); ++i) {
      text += fmt::format("complete -c umbrameter -n '{}' -l {} -d '{}'{}\n", when, choice.options[i],
                          choice.option_texts[i], choice.takes_value[i] ? " -r" : "");
    }
  }
  return text;
}

}  // namespace

std::string completions(const CLI::App& app, const std::string& shell) {
  std::vector<Choice> choices;
  collect(choices, app, app, "");
  if (shell == "bash") return bash_script(choices);
  if (shell == "zsh") return zsh_script(choices);
  if (shell == "fish") return fish_script(choices);
  const std::array<std::string, 3> known{"bash", "zsh", "fish"};
  fail_input(fmt::format("no completions for the shell '{}' ({})", shell, suggest_name(shell, known)));
}

}  // namespace umbrameter
