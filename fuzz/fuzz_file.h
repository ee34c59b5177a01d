// SPDX-License-Identifier: Apache-2.0
#pragma once
// Input of readers that want a file: one of this process in memory, written anew each time.

#include "core/error.h"

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace umbrameter::fuzz {

/// A folder of this process; removed at its end unless it dies, and then it holds what killed it.
inline const std::filesystem::path& folder() {
  static const std::filesystem::path path = [] {
    const std::filesystem::path memory = "/dev/shm";
    const auto root = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    auto made = root / ("umbrameter-fuzz-" + std::to_string(getpid()));
    std::filesystem::create_directories(made);
    std::atexit([] { std::filesystem::remove_all(folder()); });
    return made;
  }();
  return path;
}

inline std::filesystem::path write(const std::string& name, std::span<const uint8_t> bytes) {
  const std::filesystem::path path = folder() / name;
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return path;
}

/// Bad input must end in an Error{input} of one sentence, and in nothing else.
template <class Body>
void expect_answer_or_sentence(const Body& body) {
  try {
    body();
  } catch (const Error& error) {
    const std::string text = error.what();
    if (error.kind() != ErrorKind::input || text.empty() || text.find('\n') != std::string::npos)
      std::abort();
  }
}

}  // namespace umbrameter::fuzz
