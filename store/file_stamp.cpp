// SPDX-License-Identifier: Apache-2.0
#include "store/file_stamp.h"

#include <fmt/format.h>

#include <sys/stat.h>

namespace umbrameter {

std::string file_stamp(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return "absent";
  constexpr int64_t kNsPerSecond = 1000000000;
  return fmt::format("{} {}", status.st_size,
                     int64_t{status.st_mtim.tv_sec} * kNsPerSecond + status.st_mtim.tv_nsec);
}

}  // namespace umbrameter
