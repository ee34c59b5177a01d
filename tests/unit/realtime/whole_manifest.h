// SPDX-License-Identifier: Apache-2.0
#pragma once
// A manifest with one of everything, and what becomes of it after a slip.

#include "realtime/manifest/technique.h"
#include "tests/support/technique_folder.h"

#include <string>
#include <string_view>

namespace umbrameter {

/// The fragment shader `resolve.frag` of whole_manifest().
extern const std::string_view kFragment;

/// Its parameters: `taps` (define), `softness` (uniform), `map_size` and `map_fit` (host).
std::string whole_manifest();

/// Writes manifest and shader to `folder` and loads it.
Technique load(TechniqueFolder& folder, const std::string& manifest);

/// The message without the folder's path, "technique.toml:3:1: ...", or "no error".
std::string error_of(TechniqueFolder& folder, const std::string& manifest);

/// The same of whole_manifest() with one place changed.
std::string error_after(std::string_view from, std::string_view to);

}  // namespace umbrameter
