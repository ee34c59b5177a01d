// SPDX-License-Identifier: Apache-2.0
#include "report/side_files.h"

#include "core/error.h"
#include "core/files.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder, const std::string& verb) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && name.starts_with(verb) && name.ends_with(".json"))
      files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

void for_side_files(const std::filesystem::path& folder, const FileSchema& schema, const ReadSideFile& read) {
  for (const std::filesystem::path& path : files_of(folder, schema.what)) {
    try {
      const auto document = nlohmann::ordered_json::parse(read_file(path));
      require_schema(document, schema, path.string());
      read(document, path.filename().string());
    } catch (const nlohmann::json::exception& error) {  // a foreign exception becomes ours here
      fail_input(fmt::format("not what '{}' writes: {}", schema.what, error.what()), {path.string()},
                 fmt::format("{}, or move it elsewhere", schema.again));
    }
  }
}

std::vector<std::filesystem::path> side_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> all;
  for (const FileSchema& schema : {kBenchSchema, kRegressSchema, kStressSchema, kTuneSchema}) {
    const std::vector<std::filesystem::path> files = files_of(folder, schema.what);
    all.insert(all.end(), files.begin(), files.end());
  }
  return all;
}

}  // namespace umbrameter
