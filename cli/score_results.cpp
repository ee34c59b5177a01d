// SPDX-License-Identifier: Apache-2.0
#include "cli/score_results.h"

#include "cli/console.h"
#include "cli/staging.h"
#include "core/error.h"
#include "core/files.h"
#include "core/image_io.h"
#include "core/version.h"
#include "lab/scene_run.h"
#include "lab/stored_truth.h"
#include "report/report.h"
#include "results/json/results_json.h"
#include "results/metadata.h"

#include <fmt/format.h>

#include <algorithm>

namespace umbrameter {
namespace {

/// Nothing is rendered here.
class NoRenderer : public Renderer {
 public:
  Frame render(const Scene&, const RenderRequest&, Progress&) override {
    throw Error(ErrorKind::internal, "a picture's score renders nothing");
  }
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

/// Files of one stem get different labels.
std::string label_of(const std::string& file, const std::vector<TechniqueFrame>& taken) {
  const std::string stem = std::filesystem::path(file).stem().string();
  const auto is_taken = [&](const std::string& label) {
    return std::ranges::any_of(taken, [&](const TechniqueFrame& run) { return run.result.label == label; });
  };
  std::string label = stem;
  for (int number = 2; is_taken(label); ++number) label = fmt::format("{}-{}", stem, number);
  return label;
}

TechniqueFrame run_of(const SceneContext& context, const ScoredPicture& scored,
                      const std::vector<TechniqueFrame>& taken) {
  TechniqueFrame run;
  TechniqueResult& result = run.result;
  result.technique = result.label = label_of(scored.picture.name, taken);
  result.title = scored.picture.name;
  result.device = "another renderer";
  run.frame.image = scored.picture.test;
  if (!has_surfaces(run.frame.image)) borrow_surfaces(scored.score.reference, run.frame.image);
  result.image_file = context.relative(file_name_of(result.label) + ".exr");
  write_exr(context.folder / result.image_file, run.frame.image);
  take_score(context, scored.score.reference, scored.score.score, run);
  result.warnings.insert(result.warnings.end(), scored.score.notes.begin(), scored.score.notes.end());
  return run;
}

Results results_of(const ScoreInputs& inputs, const std::vector<ScoredPicture>& scored, ValidationPlan plan,
                   const std::filesystem::path& folder) {
  const SceneJob job = scene_of(inputs);
  const std::span<const float> samples = inputs.reference.plane("sample_count");
  plan.quality = "pictures";
  plan.picture.width_px = inputs.reference.width;
  plan.picture.height_px = inputs.reference.height;
  plan.picture.samples_per_pixel = static_cast<int>(*std::ranges::max_element(samples));
  NoRenderer none;
  SilentProgress silent;
  const SceneContext context{job.name, job.scene, plan, {none, none}, folder, silent};
  SceneResult scene = source_of(job).description;
  create_folder((folder / context.relative("reference.exr")).parent_path());
  const ShadowQuantity quantity = scored.front().score.quantity;
  scene.quantity = to_text(quantity);
  Frame truth;
  truth.image = with_quantity(inputs.reference, quantity);
  truth.device = metadata(inputs.reference, "device");
  take_truth(context, truth.image, describe_truth(truth), scene);
  take_parity(context, scored.front().score.score.parity, scene);
  std::vector<TechniqueFrame> runs;
  for (const ScoredPicture& picture : scored) runs.push_back(run_of(context, picture, runs));
  for (TechniqueFrame& run : runs) scene.techniques.push_back(std::move(run.result));
  Results results;
  results.version = kVersion;
  results.commit = kCommit;
  results.quality = plan.quality;
  results.picture = plan.picture;
  results.scenes.push_back(std::move(scene));
  return results;
}

}  // namespace

void write_score_results(const ScoreInputs& inputs, const std::vector<ScoredPicture>& scored,
                         const ValidationPlan& plan, const std::string& report, const std::string& out) {
  const std::filesystem::path folder = out;
  if (!out.empty()) check_results_folder(folder);
  const Staging staging(out.empty() ? std::filesystem::temp_directory_path() : folder);
  const Results results = results_of(inputs, scored, plan, staging.folder());
  write_file_atomically(staging.folder() / "results.json", to_json_text(results));
  if (!report.empty()) write_report(staging.folder(), report);
  if (out.empty()) return;
  write_report(staging.folder(), staging.folder() / "report.html");
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
