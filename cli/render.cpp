// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"
#include "cli/home.h"
#include "cli/motion_option.h"
#include "cli/progress_bar.h"
#include "cli/quality.h"
#include "cli/scene_options.h"
#include "cli/staging.h"
#include "core/error.h"
#include "core/image_io.h"
#include "lab/timing.h"
#include "realtime/inspect.h"
#include "results/format.h"
#include "results/metadata.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace umbrameter {
namespace {

struct RenderOptions {
  std::string scene;
  std::string technique;
  std::vector<std::string> assignments;
  std::string preset;
  std::string dump;
  std::string motion;
  bool no_skip = false;
  QualityOptions quality;
};

void print_frame(const TimedRun& timed, const SceneJob& job, const TechniqueRun& run, const std::string& file,
                 bool json) {
  const Frame& frame = timed.frame;
  const auto total = total_time(summarise(timed.times));
  if (!json) {
    const std::string before = frame.frames_before == 0
                                   ? std::string()
                                   : fmt::format(" after {} frames ({})", frame.frames_before, frame.motion);
    print_answer(fmt::format("{}: {} on {}{}, {}; {}; parameters {}\n", file, run.label, job.name, before,
                             format_time(total), frame.device, to_text(frame.parameters)));
    return;
  }
  nlohmann::ordered_json answer = {{"file", file},
                                   {"scene", job.name},
                                   {"scene_hash", job.scene.hash},
                                   {"technique", run.id},
                                   {"parameters", to_text(frame.parameters)},
                                   {"device", frame.device},
                                   {"timer", timed.timer},
                                   {"memory_bytes", frame.memory_bytes},
                                   {"left_out", frame.left_out}};
  if (frame.frames_before > 0) {
    answer["frames_before"] = frame.frames_before;
    answer["motion"] = frame.motion;
  }
  answer["total_ms"] = total ? nlohmann::ordered_json(total->median_ms) : nlohmann::ordered_json(nullptr);
  print_json(answer);
}

/// Writes a texture of the technique's instead of its visibility.
int dump(const RenderOptions& options, const TechniqueRun& run, const SceneJob& job,
         const RenderRequest& request, Renderer& renderer, const GlobalOptions& global) {
  const ResourcePart part = parse_resource_part(options.dump);
  const StagedFile file(global.out.empty() ? "resource.exr" : global.out, ".exr");
  ProgressBar progress;
  const Image image = dump_resource(renderer, job.scene, request, part, progress);
  write_exr(file.staged(), image);
  file.publish();
  const std::string target = file.target().string();
  if (global.json) {
    print_json({{"file", target},
                {"scene", job.name},
                {"technique", run.id},
                {"resource", part.resource},
                {"layer", part.layer},
                {"level", part.level},
                {"width_px", image.width},
                {"height_px", image.height}});
  } else {
    print_answer(fmt::format("{}: {} of {} on {}, layer {}, level {}, {} x {} texels\n", target,
                             part.resource, run.label, job.name, part.layer, part.level, image.width,
                             image.height));
  }
  return kExitFine;
}

int render(const RenderOptions& options, const GlobalOptions& global) {
  const Quality quality = choose_quality(options.quality);
  const Home home = find_home();
  std::vector<std::string> assignments = options.assignments;
  if (!options.preset.empty()) assignments.push_back("preset=" + options.preset);
  choose_technique_runs(options.technique, assignments,
                        home);  // what is wrong with it is said before a scene is loaded
  SceneJob job = load_scene_job(options.scene, scene_search(global, home));
  const TechniqueRun run = choose_technique(options.technique, assignments, home, job.scene.light().name);
  if (!options.motion.empty()) job.scene.motion = standard_motion(options.motion, job.scene);
  const LightType light = job.scene.light().type;
  if (std::find(run.lights.begin(), run.lights.end(), light) == run.lights.end()) {
    fail_input(fmt::format("technique '{}' does not support the {} light of scene '{}'", run.id,
                           to_text(light), job.name));
  }
  for (const std::string& warning : job.scene.warnings) print_warning(warning);
  const auto renderer = open_realtime_renderer(global, home, !options.no_skip);
  RenderRequest request = request_of(quality.picture);
  request.technique = run.technique;
  request.parameters = run.parameters;
  if (!options.dump.empty())
    return dump(options, run, job, request, *open_gl_renderer(global, home, !options.no_skip), global);
  const StagedFile file(global.out.empty() ? "visibility.exr" : global.out, ".exr");
  ProgressBar progress;
  const LabelledRequest labelled{run.label, request};
  TimedRun timed = render_interleaved(*renderer, job.scene, {&labelled, 1},
                                      {.wanted_frames = quality.timed_frames}, progress)
                       .front();
  if (timed.failure) throw Error(timed.failure->kind, timed.failure->message);
  Frame& frame = timed.frame;
  for (const std::string& warning : frame.warnings) print_warning(warning);
  add_metadata(frame, job.scene, request);
  write_exr(file.staged(), frame.image);
  file.publish();
  print_frame(timed, job, run, file.target().string(), global.json);
  return kExitFine;
}

}  // namespace

void add_render(CLI::App& app, CommandLine& line) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* verb = app.add_subcommand("render", "render one technique to --out (default visibility.exr)");
  verb->fallthrough();
  verb->add_option("scene", options->scene, "library name or scene file")->required();
  verb->add_option("--technique", options->technique, "ID[:name=value,...]; ID may be a folder")->required();
  verb->add_option("--set", options->assignments, "name=value; repeatable")->allow_extra_args(false);
  verb->add_option("--preset", options->preset, "a preset of the technique, or a file that 'tune' wrote");
  verb->add_flag("--no-skip", options->no_skip,
                 "draw triangles that cannot reach the light's map, too; same picture");
  add_one_view_options(*verb, line.global);
  add_motion_option(*verb, options->motion);
  verb->add_option(
      "--dump", options->dump,
      "write this texture of the technique's instead: RESOURCE[:LAYER[:LEVEL]] (default resource.exr)");
  add_quality_options(*verb, options->quality);
  verb->callback(
      [options, &line] { line.verb = [options, &line] { return render(*options, line.global); }; });
}

}  // namespace umbrameter
