// SPDX-License-Identifier: Apache-2.0
#pragma once
// A folder of a test's own, gone when the test ends.

#include <filesystem>

namespace umbrameter {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace umbrameter
