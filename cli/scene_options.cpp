// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_options.h"

#include <cmath>

namespace umbrameter {
namespace {

std::string check_moment(const std::string& text) {
  double time_s = 0.0;
  const bool is_right = CLI::detail::lexical_cast(text, time_s) && std::isfinite(time_s);
  return is_right ? std::string() : "'" + text + "' is not a number of seconds";
}

}  // namespace

void add_light_option(CLI::App& verb, GlobalOptions& options) {
  verb.add_option(
      "--light", options.light,
      "name of a light, or its number counted from 1; none = every light, each a view 'scene/light'");
}

void add_time_options(CLI::App& verb, GlobalOptions& options) {
  CLI::Option* time =
      verb.add_option("--time", options.time_s,
                      "moment of the animation, in seconds, of scenes whose mesh files have one; "
                      "the view is called 'scene@1.5s'");
  time->check(CLI::Validator(check_moment, "SECONDS"));
  verb.add_option(
          "--animation", options.animation,
          "of --time: name of an animation, its number counted from 1, or 'all' at once; none = the first")
      ->needs(time);
}

void add_scene_options(CLI::App& verb, GlobalOptions& options) {
  add_light_option(verb, options);
  add_time_options(verb, options);
}

void add_one_view_options(CLI::App& verb, GlobalOptions& options) {
  verb.add_option("--light", options.light,
                  "name of a light, or its number counted from 1; needed when the scene has several");
  add_time_options(verb, options);
}

std::optional<AnimationTime> chosen_time(const GlobalOptions& options) {
  if (!options.time_s) return std::nullopt;
  return AnimationTime{*options.time_s, options.animation};
}

}  // namespace umbrameter
