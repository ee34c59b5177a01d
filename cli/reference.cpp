// SPDX-License-Identifier: Apache-2.0

#include "cli/console.h"
#include "cli/exact_check.h"
#include "cli/exact_program.h"
#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/quality.h"
#include "cli/reference_renderer.h"
#include "cli/scene_options.h"
#include "cli/staging.h"
#include "core/image_io.h"
#include "reference/ray_budget.h"
#include "results/metadata.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace umbrameter {
namespace {

struct ReferenceOptions {
  std::string scene;
  QualityOptions quality;
  bool no_skip = false;
  int64_t exact_check = 0;  // points
};

nlohmann::json to_json(const RayBudget& budget) {
  return {{"shadow_rays_per_pixel", budget.rays_per_pixel},
          {"uniform_rays_per_pixel", budget.uniform_rays_per_pixel},
          {"background", budget.background},
          {"unlit", budget.unlit},
          {"proven_lit", budget.proven_lit},
          {"proven_dark", budget.proven_dark},
          {"sampled", budget.sampled}};
}

/// What each rule saved, of the samples that the most sampled pixel got.
std::string describe(const RayBudget& b) {
  return fmt::format(
      "{:.1f} shadow rays per pixel; pixels: {:.1f} % background, {:.1f} % unlit, {:.1f} % proven lit, "
      "{:.1f} "
      "% "
      "proven dark, {:.1f} % sampled; as many as its neediest everywhere would be {:.0f} rays per pixel\n",
      b.rays_per_pixel, 100 * b.background, 100 * b.unlit, 100 * b.proven_lit, 100 * b.proven_dark,
      100 * b.sampled, b.uniform_rays_per_pixel);
}

int render_reference(const ReferenceOptions& options, const GlobalOptions& global) {
  const Quality quality = choose_quality(options.quality);
  const SceneSearch search = scene_search(global, find_home());
  const SceneJob job = load_scene_job(options.scene, search);
  std::optional<ExactOracle> oracle;  // before any work: it may be missing, or the scene not for it
  if (options.exact_check > 0) {
    require_exact(job.scene);
    oracle = require_exact_oracle();
  }
  const StagedFile file(global.out.empty() ? "reference.exr" : global.out, ".exr");
  for (const std::string& warning : job.scene.warnings) print_warning(warning);
  const auto renderer = open_reference_renderer(global, quality.picture, !options.no_skip);
  ProgressBar progress;
  const RenderRequest request = request_of(quality.picture);
  Frame frame = renderer->render(job.scene, request, progress);
  add_metadata(frame, job.scene, request);
  write_exr(file.staged(), frame.image);
  file.publish();
  for (const std::string& warning : frame.warnings) print_warning(warning);
  const RayBudget budget = ray_budget(frame.image);
  std::optional<ExactCheck> check;
  if (oracle) {
    check = run_exact_check(job.scene, frame.image, request, static_cast<size_t>(options.exact_check),
                            *oracle, global.threads, progress);
  }
  if (global.json) {
    nlohmann::ordered_json json{{"file", file.target().string()},
                                {"scene", job.name},
                                {"scene_hash", job.scene.hash},
                                {"width_px", request.width_px},
                                {"height_px", request.height_px},
                                {"seed", request.seed},
                                {"samples_per_pixel", quality.picture.samples_per_pixel},
                                {"device", frame.device},
                                {"rays", to_json(budget)},
                                {"memory_bytes", frame.memory_bytes},
                                {"wall_time_s", frame.wall_time_s}};
    if (check) json["exact_check"] = to_json(*check);
    print_json(json);
    return kExitFine;
  }
  print_answer(fmt::format("{}: {} x {} px of {} in {:.2f} s, seed {}, {}\n", file.target().string(),
                           request.width_px, request.height_px, job.name, frame.wall_time_s, request.seed,
                           frame.device));
  print_answer(describe(budget));
  if (check) print_answer(describe(*check));
  return kExitFine;
}

}  // namespace

void add_reference(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<ReferenceOptions>();
  CLI::App* verb =
      app.add_subcommand("reference", "render the truth of a scene to --out (default reference.exr)");
  verb->fallthrough();
  verb->add_option("scene", options->scene, "library name or scene file")->required();
  add_one_view_options(*verb, line.global);
  add_quality_options(*verb, options->quality);
  verb->add_flag("--no-skip", options->no_skip, "shoot rays even where the answer is proven; same picture");
  verb->add_option(
          "--exact-check", options->exact_check,
          "compare with exact arithmetic at this many pixels, three quarters of them in the penumbra")
      ->check(CLI::Range(int64_t{1}, int64_t{1000000}));
  verb->callback(
      [options, &line] { line.verb = [options, &line] { return render_reference(*options, line.global); }; });
}

}  // namespace umbrameter
