// SPDX-License-Identifier: Apache-2.0
#include "report/before.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

/// `file` of `from`, as seen from `to`.
void move_file(std::string& file, const std::filesystem::path& from, const std::filesystem::path& to) {
  if (!file.empty()) file = std::filesystem::relative(from / file, to).string();
}

TechniqueResult marked(TechniqueResult run, const std::filesystem::path& from,
                       const std::filesystem::path& to) {
  run.label += kBeforeMark;
  for (std::string* file :
       {&run.image_file, &run.picture_file, &run.error_picture_file, &run.fault_picture_file, &run.maps_file})
    move_file(*file, from, to);
  return run;
}

}  // namespace

void add_before(Results& now, const std::filesystem::path& folder, const Results& before,
                const std::filesystem::path& before_folder) {
  const bool is_same_size =
      now.picture.width_px == before.picture.width_px && now.picture.height_px == before.picture.height_px;
  size_t common = 0;
  for (SceneResult& scene : now.scenes) {
    const auto old = std::ranges::find(before.scenes, scene.name, &SceneResult::name);
    if (old == before.scenes.end()) continue;
    ++common;
    if (old->hash != scene.hash || !is_same_size) {
      scene.warnings.push_back(
          fmt::format("no pictures of before: {}",
                      is_same_size ? "the scene has changed since" : "they were drawn at another size"));
      continue;
    }
    for (const TechniqueResult& run : old->techniques)
      scene.techniques.push_back(marked(run, before_folder, folder));
  }
  if (common == 0)
    fail_input(fmt::format("no scene of '{}' is in '{}'", folder.string(), before_folder.string()), {},
               "--before takes a folder of the same suite or validation");
}

}  // namespace umbrameter
