// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_export.h"

#include "cli/console.h"
#include "cli/home.h"
#include "core/error.h"
#include "core/files.h"
#include "scenes/export_scene.h"
#include "scenes/instances.h"

#include <fmt/format.h>

namespace umbrameter {

int export_scene(const std::string& name, const QualityOptions& size, const GlobalOptions& global) {
  if (global.out.empty()) fail_input("there is no place to export to", {}, "give --out FOLDER");
  const Quality quality = choose_quality(size);
  const SceneJob job = load_scene_job(name, scene_search(global, find_home()));
  if (const uint64_t holes = count_shown_cutouts(job.scene); holes > 0)
    print_warning(fmt::format("{} of {} triangles have holes, which scene.obj does not", holes,
                              count_shown_triangles(job.scene)));
  const std::filesystem::path folder = global.out;
  create_folder(folder);
  const PictureQuality& picture = quality.picture;
  const std::string json = scene_json_text(job.scene, job.name, picture.width_px, picture.height_px);
  write_file_atomically(folder / "scene.obj", scene_obj_text(job.scene));
  write_file_atomically(folder / "scene.json", json);
  if (global.json) {
    print_answer(json);
  } else {
    print_answer(fmt::format("{}: {} triangles in scene.obj, camera and light in scene.json\n",
                             folder.string(), count_shown_triangles(job.scene)));
  }
  return kExitFine;
}

}  // namespace umbrameter
