// SPDX-License-Identifier: Apache-2.0
#pragma once
// Files named by what is in them: objects/ab/cdef....exr is the file whose XXH3 hash is abcdef.... Not here: which
// results they belong to (store/store.h).

#include <filesystem>
#include <string>

namespace umbrameter {

inline constexpr const char* kObjectsFolder = "objects";

/// The hash of the file's bytes, in hex.
std::string hash_file(const std::filesystem::path& file);

/// Keeps a copy of `file` in `folder`/objects; returns its name there,
/// "objects/ab/cdef....exr". It is on the disk and under that name when this returns. Error{environment} when it cannot
/// be written; then nothing has changed.
std::string keep_object(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Makes `file` the object's file, without a second copy of its bytes where the file system can: whoever changes the one
/// changes the other, which is found when it is asked for. Error{environment} when it cannot be made.
void place_object(const std::filesystem::path& folder, const std::string& name,
                  const std::filesystem::path& file);

/// Whether `name` reads like that of an object.
bool is_object_name(const std::string& name);

/// Whether the bytes still are those of the name; false for a missing file.
bool is_intact(const std::filesystem::path& folder, const std::string& name);

}  // namespace umbrameter
