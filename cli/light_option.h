// SPDX-License-Identifier: Apache-2.0
#pragma once
// --light, for verbs that look at scenes.

#include "cli/verbs.h"

namespace umbrameter {

/// For a verb that takes scenes with any number of lights: without the option each light is a view of its own.
void add_light_option(CLI::App& verb, GlobalOptions& options);
/// For a verb that takes one light: a scene with several needs the option.
void add_one_light_option(CLI::App& verb, GlobalOptions& options);

}  // namespace umbrameter
