// SPDX-License-Identifier: Apache-2.0
#include "cli/score_results.h"

#include "cli/console.h"
#include "cli/staging.h"
#include "core/files.h"
#include "report/report.h"
#include "study/engine_surfaces.h"
#include "study/results_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

/// Gives out pictures that are there already.
class PictureRenderer : public Renderer {
 public:
  PictureRenderer(const Image& image, std::string device) : image_(image), device_(std::move(device)) {}
  Frame render(const Scene&, const RenderRequest& request, Progress&) override {
    Frame frame;
    frame.image = image_;
    frame.device = device_;
    frame.parameters = request.parameters;
    return frame;
  }

 private:
  const Image& image_;
  std::string device_;
};

std::string metadata(const Image& image, const char* key) {
  const auto found = image.metadata.find(key);
  return found == image.metadata.end() ? "" : found->second;
}

/// What the reference's header says of its scene; enough for results, not for rendering.
SceneJob scene_of(const ScoreInputs& inputs) {
  if (inputs.scene) return *inputs.scene;
  SceneJob job;
  job.name = metadata(inputs.reference, "scene");
  job.scene.name = job.scene.title = job.name;
  job.scene.hash = metadata(inputs.reference, "scene_hash");
  job.scene.camera.eye_world = inputs.eye_world;
  job.scene.lights.emplace_back();
  job.scene.lights.back().name = metadata(inputs.reference, "light");
  return job;
}

TechniqueRun run_of(const ScoreInputs& inputs) {
  TechniqueRun run;
  run.technique = run.id = run.label = std::filesystem::path(inputs.test_name).stem().string();
  run.title = inputs.test_name;
  run.lights = {LightType::rect, LightType::disk, LightType::sphere, LightType::sun};
  return run;
}

ValidationPlan plan_of(const ScoreInputs& inputs, const ScoreSettings& settings) {
  ValidationPlan plan;
  plan.quality = "another engine";
  plan.picture.width_px = inputs.test.width;
  plan.picture.height_px = inputs.test.height;
  const std::span<const float> samples = inputs.reference.plane("sample_count");
  plan.picture.samples_per_pixel = static_cast<int>(*std::ranges::max_element(samples));
  plan.timed_frames = 0;
  plan.techniques = {run_of(inputs)};
  plan.metrics = settings.metrics;
  plan.limit_rmse = settings.limit_rmse;
  plan.maps = settings.maps;
  return plan;
}

}  // namespace

void widen_by_rounding(double mean_square_rounding, VisibilityError& error) {
  if (!(mean_square_rounding > 0.0) || !error.mse || !error.rmse) return;
  error.mse->low -= mean_square_rounding;
  error.rmse->low = std::copysign(std::sqrt(std::abs(error.mse->low)), error.mse->low);
}

void write_score_results(const ScoreInputs& inputs, const ScoreSettings& settings, const std::string& report,
                         const std::string& out) {
  const bool keeps_folder = !out.empty();
  if (keeps_folder && std::filesystem::exists(out) && !std::filesystem::is_directory(out))
    fail_input(fmt::format("the output '{}' is not a folder", out));
  if (keeps_folder && std::filesystem::exists(std::filesystem::path(out) / "images") &&
      !std::filesystem::exists(std::filesystem::path(out) / "results.json"))
    fail_input(fmt::format("'{}/images' exists and is of no results", out), {}, "choose another --out");
  Image test = inputs.test;
  if (!has_surfaces(test)) add_surfaces({}, nullptr, DepthKind::axis, inputs.reference, test);
  PictureRenderer engine(test, "another engine"),
      truth(inputs.reference, metadata(inputs.reference, "device"));
  const Staging staging(keeps_folder ? std::filesystem::path(out) : std::filesystem::temp_directory_path());
  const SceneJob job = scene_of(inputs);
  SilentProgress silent;
  Results results =
      run_validation({&job, 1}, plan_of(inputs, settings), {truth, engine}, staging.folder(), silent);
  for (TechniqueResult& run : results.scenes.front().techniques) {
    run.warnings.insert(run.warnings.end(), inputs.notes.begin(), inputs.notes.end());
    if (run.error) widen_by_rounding(inputs.mean_square_rounding, *run.error);
  }
  write_file_atomically(staging.folder() / "results.json", to_json_text(results));
  if (!report.empty()) write_report(staging.folder(), report);
  if (!keeps_folder) return;
  write_report(staging.folder(), staging.folder() / "report.html");
  const std::filesystem::path folder = out;
  for (const std::string name : {"images", "report-data"}) {
    if (std::filesystem::exists(folder / name))
      rename_into_place(folder / name, staging.folder() / ("old-" + name));
  }
  for (const char* name : {"images", "results.json", "report-data", "report.html"}) {
    if (std::filesystem::exists(staging.folder() / name))
      rename_into_place(staging.folder() / name, folder / name);
  }
  print_note(fmt::format("wrote {}", (folder / "report.html").string()));
}

}  // namespace umbrameter
