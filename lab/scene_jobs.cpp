// SPDX-License-Identifier: Apache-2.0
#include "lab/scene_jobs.h"

#include "core/error.h"
#include "scenes/choose_light.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace umbrameter {

std::string scene_name(const std::filesystem::path& file, const SceneSearch& search) {
  const auto inside = file.lexically_relative(search.library);
  const bool is_library_scene = !inside.empty() && *inside.begin() != "..";
  std::filesystem::path name = is_library_scene ? inside : file.filename();
  return name.replace_extension().generic_string();
}

std::vector<SceneJob> load_scene_jobs(const std::string& name_or_path, const SceneSearch& search) {
  const std::filesystem::path file = resolve_scene(name_or_path, search);
  const Scene scene = load_scene(file, search);
  std::vector<SceneJob> jobs;
  const std::string name = timed_name(scene_name(file, search), search.at);
  for (const size_t light : choose_lights(scene.lights, search.light))
    jobs.push_back({lit_name(name, scene.lights, light), lit_by(scene, light)});
  return jobs;
}

SceneJob load_scene_job(const std::string& name_or_path, const SceneSearch& search) {
  std::vector<SceneJob> jobs = load_scene_jobs(name_or_path, search);
  if (jobs.size() == 1) return std::move(jobs.front());
  std::vector<std::string> names;
  for (const SceneJob& job : jobs) names.push_back(job.scene.light().name);
  fail_input(fmt::format("scene '{}' has {} lights: {}", name_or_path, jobs.size(), fmt::join(names, ", ")),
             {}, "choose one with --light");
}

}  // namespace umbrameter
