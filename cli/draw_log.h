// SPDX-License-Identifier: Apache-2.0
#pragma once
// UMBRAMETER_DRAW_LOG=FILE: a line per picture that a process really made, so that reuse can be counted (docs/store.md).

#include "core/renderer.h"

#include <string_view>

namespace umbrameter {

/// Appends "<what> <scene and light> <width>x<height> <seed> [<technique> <name=value,...>]" where the variable is set. `settings`
/// stand behind `what`. Error{input} when the file cannot be written.
void log_drawn(std::string_view what, const Scene& scene, const RenderRequest& request,
               std::string_view settings = {});

}  // namespace umbrameter
