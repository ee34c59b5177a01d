// SPDX-License-Identifier: Apache-2.0
#include "store/objects.h"

#include "core/error.h"
#include "core/files.h"
#include "core/hash.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace umbrameter {

namespace fs = std::filesystem;

namespace {

constexpr size_t kFanOut = 2;  // hex digits of the folder's name
constexpr size_t kHexDigits = 32;

std::string name_of(const std::string& hash, const std::string& extension) {
  return fmt::format("{}/{}/{}{}", kObjectsFolder, hash.substr(0, kFanOut), hash.substr(kFanOut), extension);
}

std::string hash_of(const std::string& name) {
  const fs::path path = name;
  return path.parent_path().filename().string() + path.stem().string();
}

[[noreturn]] void fail_object(const fs::path& place, const std::string& problem) {
  fail_environment(fmt::format("'{}' cannot be stored: {}", place.string(), problem),
                   "is the disk full? what is stored already stays; make room and run again");
}

/// The file's bytes, or a folder's names, are on the disk then.
void sync(const fs::path& place) {
  const int descriptor = ::open(place.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_synced = descriptor >= 0 && fsync(descriptor) == 0;
  const int problem = errno;
  if (descriptor >= 0) close(descriptor);
  if (!is_synced) fail_object(place, std::strerror(problem));
}

void copy_object(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(to, ignored);
  fail_object(to, error.message());
}

}  // namespace

std::string hash_file(const fs::path& file) {
  const std::string bytes = read_file(file);
  return Hasher().bytes(bytes.data(), bytes.size()).hex();
}

std::string keep_object(const fs::path& folder, const fs::path& file) {
  const std::string name = name_of(hash_file(file), file.extension().string());
  const fs::path place = folder / name;
  std::error_code error;
  fs::create_directories(place.parent_path(), error);
  if (error) fail_object(place, error.message());
  const fs::path temporary = temporary_name(place);
  copy_object(file, temporary);  // no link: who rewrites the file must not rewrite what is kept
  sync(temporary);
  rename_into_place(temporary, place);
  sync(place.parent_path());
  return name;
}

void place_object(const fs::path& folder, const std::string& name, const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  fs::create_hard_link(folder / name, file, error);
  if (error) copy_object(folder / name, file);
}

bool is_object_name(const std::string& name) {
  return name.starts_with(std::string(kObjectsFolder) + "/") && hash_of(name).size() == kHexDigits;
}

bool is_intact(const fs::path& folder, const std::string& name) {
  return fs::is_regular_file(folder / name) && hash_file(folder / name) == hash_of(name);
}

}  // namespace umbrameter
