// SPDX-License-Identifier: Apache-2.0
#include "view/script.h"

#include "core/names.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace umbrameter {
namespace {

struct Command {
  std::string_view name;
  size_t least_words = 0, most_words = 0;
};

constexpr Command kCommands[] = {
    {"key", 1, 1},                        // a key pressed and let go, "CTRL+Q" with a modifier
    {"press", 1, 1},                      // and held
    {"release", 1, 1},   {"drag", 5, 5},  // BUTTON X1 Y1 X2 Y2 over the picture
    {"scroll", 1, 1},                     // steps, up is positive
    {"hover", 2, 2},                      // X Y
    {"resize", 2, 2},                     // the window
    {"open", 1, 1},                       // a scene, by its name or file
    {"technique", 1, 1},                  // by its id
    {"set", 2, 2},                        // parameter value
    {"unfold", 1, 1},                     // a section of the panel; the others are folded
    {"layout", 1, 1},    {"layer", 1, 1},  {"orbit", 1, 1},  // for as many pictures
    {"switch", 1, 1},                                        // techniques, so many, one after the other
    {"mark", 0, 0},                                          // the memory that the report counts from
    {"frames", 1, 1},                                        // of the window
    {"wait", 1, 2},                                          // full | truth [SE] | judged | faults | problem
    {"window", 1, 1},                                        // PNG of the whole window
    {"picture", 1, 1},                                       // PNG of the picture
    {"scene", 1, 1},     {"preset", 1, 1}, {"study", 1, 1},
    {"path", 1, 1},      {"play", 1, 1},  // a recorded path
    {"close", 0, 0},
};

struct NamedKey {
  std::string_view name;
  int key;
};

constexpr NamedKey kKeys[] = {
    {"SPACE", GLFW_KEY_SPACE},     {"TAB", GLFW_KEY_TAB},
    {"ESCAPE", GLFW_KEY_ESCAPE},   {"HOME", GLFW_KEY_HOME},
    {"PAGE_UP", GLFW_KEY_PAGE_UP}, {"PAGE_DOWN", GLFW_KEY_PAGE_DOWN},
    {"F1", GLFW_KEY_F1},           {"F2", GLFW_KEY_F2},
    {"F5", GLFW_KEY_F5},           {"UP", GLFW_KEY_UP},
    {"DOWN", GLFW_KEY_DOWN},       {"LEFT", GLFW_KEY_LEFT},
    {"RIGHT", GLFW_KEY_RIGHT},     {"COMMA", GLFW_KEY_COMMA},
    {"PERIOD", GLFW_KEY_PERIOD},   {"SHIFT", GLFW_KEY_LEFT_SHIFT},
};

ScriptStep checked(ScriptStep step) {
  const auto known = std::ranges::find(kCommands, step.command, &Command::name);
  if (known == std::end(kCommands)) {
    std::vector<std::string> names;
    for (const Command& command : kCommands) names.emplace_back(command.name);
    fail_input(fmt::format("unknown command '{}'", step.command), step.where,
               suggest_name(step.command, names));
  }
  if (step.words.size() < known->least_words || step.words.size() > known->most_words)
    fail_input(fmt::format("'{}' has {} words behind it", step.command, step.words.size()), step.where,
               fmt::format("it takes {}", known->most_words));
  return step;
}

}  // namespace

double ScriptStep::number(size_t index) const {
  const std::string& word = words.at(index);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    fail_input(fmt::format("'{}' is not a number", word), where);
  return value;
}

std::vector<ScriptStep> parse_script(std::string_view text, const std::string& file) {
  std::vector<ScriptStep> steps;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    ScriptStep step;
    step.where = {file, number};
    if (!(words >> step.command)) continue;
    for (std::string word; words >> word;) step.words.push_back(word);
    steps.push_back(checked(std::move(step)));
  }
  return steps;
}

int key_of(std::string_view name) {
  if (name.size() == 1) {
    const char letter = name[0];
    const bool is_key = (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9');
    return is_key ? letter : -1;  // GLFW's numbers are ASCII's there
  }
  const auto found = std::ranges::find(kKeys, name, &NamedKey::name);
  return found == std::end(kKeys) ? -1 : found->key;
}

}  // namespace umbrameter
