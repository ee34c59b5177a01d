// SPDX-License-Identifier: Apache-2.0
#include "cli/ignored_options.h"

#include "cli/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace umbrameter {
namespace {

struct Ignored {
  const char* option;
  std::vector<std::string_view> by;  // verbs, with all their parts
};

/// Verbs that answer on the standard output, draw nothing, or trace nothing.
const std::array<Ignored, 4>& ignored_options() {
  static const std::array<Ignored, 4> kIgnored = {
      {{"--out",
        {"doctor", "help", "metrics", "engines", "scene list", "scene check", "scene plan", "techniques list",
         "techniques show", "techniques check", "regress prove"}},
       {"--device",
        {"merge", "export", "report", "help", "metrics", "engines list", "engines show", "techniques list",
         "techniques show", "techniques doc", "scene list", "scene check", "scene import", "scene export"}},
       {"--threads",
        {"plan", "render", "merge", "export", "report", "help", "metrics", "engines", "techniques list",
         "techniques show", "techniques doc", "techniques check", "techniques glsl", "scene list",
         "scene check", "scene plan", "scene import", "scene export"}},
       {"--json", {"help", "techniques doc"}}}};
  return kIgnored;
}

std::string parsed_path(const CLI::App& app) {
  std::string path;
  const CLI::App* verb = &app;
  while (!verb->get_subcommands().empty()) {
    verb = verb->get_subcommands().front();
    path += (path.empty() ? "" : " ") + verb->get_name();
  }
  return path;
}

}  // namespace

void warn_of_ignored_options(const CLI::App& app) {
  const std::string path = parsed_path(app);
  const auto is_part = [&](std::string_view verb) {
    return path == verb || path.starts_with(std::string(verb) + " ");
  };
  for (const auto& [option, by] : ignored_options()) {
    if (app.get_option(option)->count() > 0 && std::ranges::any_of(by, is_part))
      print_warning(fmt::format("{} is ignored: '{}' makes nothing of it", option, path));
  }
}

}  // namespace umbrameter
