// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_import.h"

#include "cli/console.h"
#include "cli/scene_options.h"
#include "core/error.h"
#include "core/files.h"
#include "scenes/import_scene.h"
#include "scenes/instances.h"
#include "scenes/load_scene.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {

int import_scene(const std::string& name, const GlobalOptions& global) {
  namespace fs = std::filesystem;
  if (!is_importable(name))
    fail_input(fmt::format("'{}' has an unknown format", name), {},
               "'.gltf', '.glb', '.fbx', '.xml' (Mitsuba) and '.pbrt' are read");
  const fs::path file(name);
  const fs::path target = global.out.empty() ? "scene.toml" : global.out;
  if (target.extension() != ".toml")
    fail_input(fmt::format("the output '{}' does not end in '.toml'", target.string()));
  const fs::path folder = fs::absolute(target).parent_path();
  const ImportedScene imported =
      import_file(file, chosen_time(global), fs::relative(fs::absolute(file), folder));
  create_folder(folder);  // '../x.glb' is found from a folder that exists
  const Scene scene = parse_scene(imported.toml, target, {});
  write_file_atomically(target, imported.toml);
  for (const auto* warnings : {&imported.warnings, &scene.warnings}) {
    for (const std::string& warning : *warnings) print_warning(warning);
  }
  if (global.json) {
    print_json({{"file", target.string()},
                {"triangles", count_shown_triangles(scene)},
                {"lights", scene.lights.size()}});
  } else {
    print_answer(fmt::format("{}: {} triangles, {} light{}\n", target.string(), count_shown_triangles(scene),
                             scene.lights.size(), scene.lights.size() == 1 ? "" : "s"));
  }
  return kExitFine;
}

}  // namespace umbrameter
