// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/technique_cache.h"

#include <algorithm>
#include <vector>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

void add_files(const fs::path& folder, std::vector<std::string>& files) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files.push_back(fmt::format("{} {} {}\n", entry.path().string(),
                                entry.last_write_time().time_since_epoch().count(), entry.file_size()));
  }
}

}  // namespace

std::string TechniqueCache::files_of(const fs::path& folder) const {
  std::vector<std::string> files;
  for (const fs::path& place : {folder, techniques_folder_ / "shared", shaders_folder_})
    add_files(place, files);
  std::ranges::sort(files);
  std::string all;
  for (const std::string& file : files) all += file;
  return all;
}

std::shared_ptr<const Technique> TechniqueCache::find(const std::string& id_or_path) {
  if (const auto found = known_.find(id_or_path); found != known_.end()) {
    if (files_of(found->second.technique->folder) == found->second.files) return found->second.technique;
    known_.erase(found);
  }
  auto technique =
      std::make_shared<const Technique>(find_technique(id_or_path, techniques_folder_, shaders_folder_));
  known_[id_or_path] = {files_of(technique->folder), technique};
  return technique;
}

}  // namespace umbrameter
