// SPDX-License-Identifier: Apache-2.0
#include "core/file_hint.h"

#include "core/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

namespace umbrameter {

std::string hint_for_missing(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!fs::is_directory(folder, failed)) return fmt::format("there is no folder '{}'", folder.string());
  std::vector<std::string> names;
  for (auto entry = fs::directory_iterator(folder, failed); !failed && entry != fs::directory_iterator();
       entry.increment(failed))
    names.push_back(entry->path().filename().string());
  std::sort(names.begin(), names.end());  // equally near ones in no chance order
  const std::string nearest = nearest_name(file.filename().string(), names);
  if (nearest.empty()) return {};
  const fs::path whole = file.has_parent_path() ? folder / nearest : fs::path(nearest);
  return fmt::format("did you mean '{}'?", whole.string());
}

}  // namespace umbrameter
