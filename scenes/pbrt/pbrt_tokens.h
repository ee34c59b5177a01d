// SPDX-License-Identifier: Apache-2.0
#pragma once
// Words of a pbrt file, through the files it includes.

#include "core/error.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct PbrtToken {
  std::string text;        // without its quotes
  bool is_string = false;  // had quotes
  FileLocation where;
};

class PbrtTokens {
 public:
  /// Error{input} when the file cannot be read.
  explicit PbrtTokens(const std::filesystem::path& path) { open(path, {}); }

  /// The next one; absent at the end of the first file. Error{input} for a string without an end.
  std::optional<PbrtToken> next();
  /// The same, not taken.
  const PbrtToken* peek();

  /// Goes on with `path`, and behind it where it was. Error{input} for a file that is not there, includes itself, or is one of
  /// more than 1,000.
  void open(const std::filesystem::path& path, const FileLocation& from);
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  struct Source {
    std::filesystem::path path, whole;
    std::string bytes;
    size_t at = 0;
    int line = 1;
  };
  std::optional<PbrtToken> read(Source& source) const;

  std::vector<Source> open_;  // innermost last
  std::vector<std::filesystem::path> files_;
  std::optional<PbrtToken> peeked_;
};

}  // namespace umbrameter
