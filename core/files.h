// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text files: read whole, write whole or not at all.

#include <filesystem>
#include <string>
#include <string_view>

namespace umbrameter {

/// The file's bytes; Error{input} when it is missing, a folder, unreadable or larger than 4 GiB.
std::string read_file(const std::filesystem::path& path);

/// Writes to a temporary name beside `path`, then renames; Error{input} when the place cannot be written.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Creates `folder` and its parents; Error{input} saying why not.
void create_folder(const std::filesystem::path& folder);

/// A temporary name beside `path` with the same extension, unique to this process and call.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Renames `from` over `to`; Error{input} (and `from` removed) when that fails.
void rename_into_place(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace umbrameter
