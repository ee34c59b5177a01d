#include "reference/reference.h"

#include "cli/console.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/quality.h"
#include "cli/staging.h"
#include "core/image_io.h"
#include "study/metadata.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

struct ReferenceOptions {
  std::string scene;
  QualityOptions quality;
};

int render_reference(const ReferenceOptions& options, const GlobalOptions& global) {
  const Quality quality = choose_quality(options.quality);
  const SceneSearch search = scene_search(global, find_home());
  const SceneJob job = load_scene_job(options.scene, search);
  const StagedFile file(global.out.empty() ? "reference.exr" : global.out, ".exr");
  for (const std::string& warning : job.scene.warnings) print_warning(warning);
  const auto renderer =
      make_reference_renderer({quality.samples_per_pixel, quality.target_se, global.threads});
  ProgressBar progress;
  RenderRequest request;
  request.width_px = quality.width_px;
  request.height_px = quality.height_px;
  request.seed = quality.seed;
  Frame frame = renderer->render(job.scene, request, progress);
  add_metadata(frame, job.scene, request);
  write_exr(file.staged(), frame.image);
  file.publish();
  if (global.json) {
    print_json({{"file", file.target().string()},
                {"scene", job.name},
                {"scene_hash", job.scene.hash},
                {"width_px", request.width_px},
                {"height_px", request.height_px},
                {"seed", request.seed},
                {"samples_per_pixel", quality.samples_per_pixel},
                {"device", frame.device},
                {"wall_time_s", frame.wall_time_s}});
    return kExitFine;
  }
  print_answer(fmt::format("{}: {} x {} px of {} in {:.2f} s, seed {}, {}\n", file.target().string(),
                           request.width_px, request.height_px, job.name, frame.wall_time_s, request.seed,
                           frame.device));
  return kExitFine;
}

}  // namespace

void add_reference(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<ReferenceOptions>();
  CLI::App* verb =
      app.add_subcommand("reference", "render the truth of a scene to --out (default reference.exr)");
  verb->fallthrough();
  verb->add_option("scene", options->scene, "library name or scene file")->required();
  add_quality_options(*verb, options->quality);
  verb->callback(
      [options, &line] { line.verb = [options, &line] { return render_reference(*options, line.global); }; });
}

}  // namespace umbrameter
