// SPDX-License-Identifier: Apache-2.0
#pragma once
// {name} in commands and file names of a manifest. Values become parts of arguments, never of a shell's line.

#include "core/error.h"
#include "engines/host/manifest.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

using PlaceholderValues = std::map<std::string, std::string>;

/// Whether a request gives `name` a value of its own: scene, name, out, lit, unlit, surfaces, width, height, seed,
/// folder, installed.
bool is_request_placeholder(std::string_view name);
/// Those that a form knows.
std::vector<std::string> placeholders_of(EngineForm form);

/// Arguments of a command line: separated by blanks, "..." and '...' hold blanks. No variables, no escapes.
std::vector<std::string> split_command(std::string_view command, const FileLocation& where);

/// Error{input} at `where` for a brace without its partner or a name that is not in `known`.
void check_placeholders(std::string_view text, std::span<const std::string> known, const FileLocation& where);

/// Every placeholder replaced; Error{input} for unknown ones.
std::string fill_placeholders(std::string_view text, const PlaceholderValues& values,
                              const FileLocation& where = {});
/// Those that `values` knows replaced, the others kept.
std::string fill_some(std::string_view text, const PlaceholderValues& values);

}  // namespace umbrameter
