// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether files below some folders were saved.

#include "core/clock.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

class FileWatch {
 public:
  explicit FileWatch(std::vector<std::filesystem::path> folders);
  /// True once after a file was written, came or went. Looks at most twice a second.
  bool has_changed();

 private:
  std::string stamp() const;

  std::vector<std::filesystem::path> folders_;
  std::string stamp_;
  Clock::time_point looked_;
};

}  // namespace umbrameter
