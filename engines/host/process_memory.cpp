// SPDX-License-Identifier: Apache-2.0
#include "engines/host/process_memory.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

namespace umbrameter {
namespace {

/// 0 unless the process is of the group. /proc/<id>/stat: after the name in parentheses come state, parent, group, and
/// resident pages as the 22nd of those (proc(5)).
uint64_t pages_in_group(const std::filesystem::path& process, pid_t group) {
  std::ifstream file(process / "stat");
  std::ostringstream all;
  all << file.rdbuf();
  const std::string text = all.str();
  const size_t end_of_name = text.rfind(')');
  if (end_of_name == std::string::npos) return 0;
  std::istringstream fields(text.substr(end_of_name + 1));
  std::string state, skipped;
  pid_t parent = 0, its_group = 0;
  fields >> state >> parent >> its_group;
  if (!fields || its_group != group) return 0;
  for (int i = 4; i < 22; ++i) fields >> skipped;
  uint64_t pages = 0;
  fields >> pages;
  return fields ? pages : 0;
}

}  // namespace

uint64_t resident_bytes_of_group(pid_t group) {
  uint64_t pages = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
    const std::string name = entry.path().filename().string();
    if (std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; }))
      pages += pages_in_group(entry.path(), group);
  }
  return pages * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace umbrameter
