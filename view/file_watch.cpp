// SPDX-License-Identifier: Apache-2.0
#include "view/file_watch.h"

#include "core/hash.h"

#include <algorithm>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

constexpr double kInterval_s = 0.5;

/// Name, time and size of every file; those that vanish meanwhile are left out.
void add_files(const fs::path& folder, std::vector<std::string>& files) {
  std::error_code problem;
  for (fs::recursive_directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const auto time = entry->last_write_time(problem);
    const auto size = entry->is_regular_file(problem) ? entry->file_size(problem) : 0;
    files.push_back(entry->path().string() + std::to_string(time.time_since_epoch().count()) + ' ' +
                    std::to_string(size));
  }
}

}  // namespace

FileWatch::FileWatch(std::vector<fs::path> folders)
    : folders_(std::move(folders)), stamp_(stamp()), looked_(Clock::now()) {}

bool FileWatch::has_changed() {
  if (seconds_since(looked_) < kInterval_s) return false;
  looked_ = Clock::now();
  std::string now = stamp();
  if (now == stamp_) return false;
  stamp_ = std::move(now);
  return true;
}

std::string FileWatch::stamp() const {
  std::vector<std::string> files;
  for (const fs::path& folder : folders_) add_files(folder, files);
  std::ranges::sort(files);
  Hasher hasher;
  for (const std::string& file : files) hasher.text(file);
  return hasher.hex();
}

}  // namespace umbrameter
