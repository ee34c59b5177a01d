// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/file_stamps.h"

#include <algorithm>
#include <chrono>
#include <system_error>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kClockStep{100};  // of file systems: at most; ext4's is 4 ms

}  // namespace

std::optional<std::vector<int64_t>> stamps_of(std::span<const fs::path> files) {
  const fs::file_time_type latest = fs::file_time_type::clock::now() - kClockStep;
  std::vector<int64_t> stamps;
  std::vector<fs::path> places(files.begin(), files.end());
  for (const fs::path& file : files) {
    if (std::ranges::find(places, file.parent_path()) == places.end()) places.push_back(file.parent_path());
  }
  for (size_t i = 0; i < places.size(); ++i) {
    std::error_code problem;
    const fs::file_time_type time = fs::last_write_time(places[i], problem);
    if (problem || time > latest) return std::nullopt;
    stamps.push_back(time.time_since_epoch().count());
    if (i < files.size()) stamps.push_back(static_cast<int64_t>(fs::file_size(places[i], problem)));
    if (problem) return std::nullopt;
  }
  return stamps;
}

}  // namespace umbrameter
