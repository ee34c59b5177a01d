// SPDX-License-Identifier: Apache-2.0
#include "core/data_folder.h"

#include "core/error.h"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <system_error>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;

constexpr std::array kParts = {"scenes/library", "realtime/techniques", "realtime/shaders"};
constexpr const char* kHint =
    "UMBRAMETER_HOME names the folder that holds scenes/library, realtime/techniques and realtime/shaders";

void require_parts(const fs::path& root, const std::string& origin) {
  std::error_code ignored;
  for (const char* part : kParts) {
    if (!fs::is_directory(root / part, ignored) || fs::is_empty(root / part, ignored))
      fail_environment(fmt::format("{} '{}' has no {}, or an empty one", origin, root.string(), part), kHint);
  }
}

}  // namespace

fs::path find_data_folder(const fs::path& program, int levels) {
  std::error_code failed;
  if (const char* chosen = std::getenv("UMBRAMETER_HOME"); chosen != nullptr && *chosen != '\0') {
    require_parts(chosen, "UMBRAMETER_HOME");
    return chosen;
  }
  const fs::path start = program.parent_path();
  fs::path folder = start;
  for (int level = 0; level < levels && folder.has_relative_path(); ++level) {
    folder = folder.parent_path();
    const fs::path root = fs::canonical(folder / "share" / "umbrameter", failed);
    if (failed) continue;
    require_parts(root, "the data folder");
    return root;
  }
  fail_environment(fmt::format("no data folder: '{}' is not there",
                               (start.parent_path() / "share" / "umbrameter").string()),
                   kHint);
}

fs::path program_file() {
  std::error_code failed;
  const fs::path file = fs::read_symlink("/proc/self/exe", failed);
  if (failed) fail_environment(fmt::format("/proc/self/exe cannot be read: {}", failed.message()));
  return file;
}

}  // namespace umbrameter
