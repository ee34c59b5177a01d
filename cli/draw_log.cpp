// SPDX-License-Identifier: Apache-2.0
#include "cli/draw_log.h"

#include "core/error.h"
#include "results/metadata.h"
#include "scenes/scene_hash.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

namespace umbrameter {

void log_drawn(std::string_view what, const Scene& scene, const RenderRequest& request,
               std::string_view settings) {
  const char* file = std::getenv("UMBRAMETER_DRAW_LOG");
  if (file == nullptr || *file == '\0') return;
  std::string line = fmt::format("{}{} {}/{} {}x{} {}", what, settings, hash_scene(scene), scene.active_light,
                                 request.width_px, request.height_px, request.seed);
  if (!request.technique.empty())
    line += fmt::format(" {} {}", request.technique, to_text(request.parameters));
  if (request.blocker_truth != nullptr) line += " with the truth's blockers";
  std::ofstream out(file, std::ios::app);
  out << line + "\n" << std::flush;
  if (!out) fail_input("the log of UMBRAMETER_DRAW_LOG cannot be written", {file});
}

}  // namespace umbrameter
