// SPDX-License-Identifier: Apache-2.0
#include "core/files.h"

#include "core/error.h"
#include "core/file_hint.h"

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <system_error>

namespace umbrameter {

namespace fs = std::filesystem;

namespace {

constexpr uintmax_t kMaxFileBytes = uintmax_t{4} << 30;

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) fail_input("the file does not exist", {path.string()}, hint_for_missing(path));
  if (fs::is_directory(status)) fail_input("a folder, not a file", {path.string()});
  const uintmax_t size = fs::file_size(path, error);
  if (!error && size > kMaxFileBytes) {
    fail_input(fmt::format("the file has {} bytes, more than the limit of {}", size, kMaxFileBytes),
               {path.string()});
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail_input("the file cannot be opened", {path.string()}, "check its permissions");
  std::string bytes(error ? 0 : size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (stream.bad()) fail_input("the file cannot be read", {path.string()});
  bytes.resize(static_cast<size_t>(stream.gcount()));
  return bytes;
}

fs::path temporary_name(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  const std::string stem = fmt::format(".{}.{}-{}.tmp", path.stem().string(), getpid(), counter++);
  return path.parent_path() / (stem + path.extension().string());
}

void rename_into_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::rename(from, to, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(from, ignored);
  fail_input(fmt::format("cannot be written: {}", error.message()), {to.string()});
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  const fs::path temporary = temporary_name(path);
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    fail_input("cannot be written", {path.string()},
               "does the folder exist, and is there room and permission?");
  }
  rename_into_place(temporary, path);
}

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_input(fmt::format("the folder cannot be created: {}", error.message()), {folder.string()});
  if (access(folder.c_str(), W_OK) != 0) {
    fail_input("the folder cannot be written to", {folder.string()}, "check its permissions");
  }
}

}  // namespace umbrameter
