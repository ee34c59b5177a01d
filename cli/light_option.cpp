// SPDX-License-Identifier: Apache-2.0
#include "cli/light_option.h"

namespace umbrameter {

void add_light_option(CLI::App& verb, GlobalOptions& options) {
  verb.add_option(
      "--light", options.light,
      "name of a light, or its number counted from 1; none = every light, each a view 'scene/light'");
}

void add_one_light_option(CLI::App& verb, GlobalOptions& options) {
  verb.add_option("--light", options.light,
                  "name of a light, or its number counted from 1; needed when the scene has several");
}

}  // namespace umbrameter
