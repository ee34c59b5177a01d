// SPDX-License-Identifier: Apache-2.0
#pragma once
// How verbs look at scenes: --light, --time, --animation.

#include "cli/verbs.h"
#include "scenes/animation_time.h"

namespace umbrameter {

/// --light alone, for studies, whose files say the time: without the option each light is a view of its own.
void add_light_option(CLI::App& verb, GlobalOptions& options);
/// --time and --animation alone.
void add_time_options(CLI::App& verb, GlobalOptions& options);

/// For a verb that takes scenes with any number of lights.
void add_scene_options(CLI::App& verb, GlobalOptions& options);
/// For a verb that makes one picture: a scene with several lights needs --light.
void add_one_view_options(CLI::App& verb, GlobalOptions& options);

/// What --time and --animation say; absent without --time.
std::optional<AnimationTime> chosen_time(const GlobalOptions& options);

}  // namespace umbrameter
