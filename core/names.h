// SPDX-License-Identifier: Apache-2.0
#pragma once
// Spelling help for unknown keys, parameters, techniques and scenes.

#include <span>
#include <string>
#include <string_view>

namespace umbrameter {

/// The known name nearest to `name` in edit distance, of equally near ones the one that begins alike for longest ("pcs" is
/// "pcss", not "pcf"); empty when none is near (more than half the letters differ).
std::string nearest_name(std::string_view name, std::span<const std::string> known);

/// A hint for an unknown name: "did you mean 'x'?", else "known: a, b, c"; empty when nothing is known.
std::string suggest_name(std::string_view name, std::span<const std::string> known);

}  // namespace umbrameter
