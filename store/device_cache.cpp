// SPDX-License-Identifier: Apache-2.0
#include "store/device_cache.h"

#include "core/hash.h"
#include "store/file_stamp.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>

#include <unistd.h>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Variables that choose a driver or change what it does begin like these.
constexpr std::array<std::string_view, 12> kDriverVariables{
    "MESA_", "LIBGL_",    "GALLIUM_", "LP_",   "EGL_",    "__EGL_",
    "__GL",  "DRI_PRIME", "NVIDIA",   "CUDA_", "DISPLAY", "LD_LIBRARY_PATH"};

/// Where devices and drivers come and go.
constexpr std::array<const char*, 3> kDeviceFolders{"/dev/dri", "/usr/share/glvnd/egl_vendor.d",
                                                    "/etc/glvnd/egl_vendor.d"};

std::vector<std::string> driver_variables() {
  std::vector<std::string> found;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (std::ranges::any_of(kDriverVariables, [&](auto prefix) { return text.starts_with(prefix); }))
      found.emplace_back(text);
  }
  std::ranges::sort(found);
  return found;
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::string first_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

std::string key_of(const std::string& asked) {
  Hasher hasher;
  hasher.text("device").text(asked).text(first_line("/etc/machine-id"));
  for (const std::string& variable : driver_variables()) hasher.text(variable);
  for (const char* folder : kDeviceFolders) {
    hasher.text(folder);
    for (const std::string& name : names_in(folder)) hasher.text(name);
  }
  hasher.text(file_stamp("/dev/nvidia0") == "absent" ? "" : "nvidia")
      .text(first_line("/proc/driver/nvidia/version"));
  return hasher.hex();
}

/// Libraries that this process has loaded.
std::set<std::string> loaded_libraries() {
  std::set<std::string> files;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const size_t path = line.find('/');
    if (path != std::string::npos && line.find(".so", path) != std::string::npos)
      files.insert(line.substr(path));
  }
  return files;
}

}  // namespace

std::optional<std::string> find_device(LazyStore& store, const std::string& asked) {
  const auto text = store.find(key_of(asked));
  const Json json = text ? Json::parse(*text, nullptr, false) : Json();
  if (!json.is_object()) return std::nullopt;
  for (const auto& [file, stamp] : json.at("libraries").items()) {
    if (Json(file_stamp(file)) != stamp) return std::nullopt;
  }
  return json.at("identity").get<std::string>();
}

void keep_device(LazyStore& store, const std::string& asked, const std::string& identity) {
  Json libraries = Json::object();
  for (const std::string& file : loaded_libraries()) libraries[file] = file_stamp(file);
  const Json json{{"identity", identity}, {"libraries", libraries}};
  store.store().put({key_of(asked), EntryKind::device, json.dump()});
}

}  // namespace umbrameter
