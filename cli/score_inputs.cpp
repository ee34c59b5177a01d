// SPDX-License-Identifier: Apache-2.0
#include "cli/score_inputs.h"

#include "cli/home.h"
#include "cli/progress_bar.h"
#include "cli/reference_renderer.h"
#include "core/error.h"
#include "core/image_io.h"
#include "study/engine_image.h"
#include "study/engine_surfaces.h"
#include "study/format.h"
#include "study/metadata.h"
#include "study/score.h"

#include <fmt/format.h>

#include <cmath>

namespace umbrameter {
namespace {

void check_options(const ScoreInputOptions& options) {
  const bool is_pair = !options.shadowed.empty() || !options.unshadowed.empty();
  if (is_pair && (options.shadowed.empty() || options.unshadowed.empty()))
    fail_input("--shadowed and --unshadowed go together", {}, "give both, or one image with visibility");
  if (is_pair == !options.test.empty())
    fail_input(is_pair ? "an image and a pair are given" : "there is nothing to score", {},
               "give one image with visibility, or --shadowed and --unshadowed");
  if (options.reference.empty() && options.scene.empty())
    fail_input("there is nothing to score against", {}, "--reference FILE, or --scene NAME to render it");
}

/// The truth of the scene at the picture's size.
Image render_truth(const SceneJob& job, const ScoreInputOptions& options, const GlobalOptions& global,
                   const Image& test) {
  QualityOptions wanted = options.quality;
  wanted.width = test.width;
  wanted.height = test.height;
  const Quality quality = choose_quality(wanted);
  const auto renderer = open_reference_renderer(global, quality.picture);
  ProgressBar progress;
  const RenderRequest request = request_of(quality.picture);
  Frame frame = renderer->render(job.scene, request, progress);
  add_metadata(frame, job.scene, request);
  return std::move(frame.image);
}

void require_same_size(const ScoreInputs& inputs) {
  const Image &a = inputs.test, &b = inputs.reference;
  if (a.width == b.width && a.height == b.height) return;
  fail_input(fmt::format("'{}' is {} x {} px and '{}' is {} x {}", inputs.test_name, a.width, a.height,
                         inputs.reference_name, b.width, b.height),
             {}, "render the picture at the reference's size; scaling would make other shadows");
}

Image read_surfaces(const ScoreInputOptions& options) {
  Image all;
  for (const std::string& file : options.surfaces) {
    Image image = read_image(file);
    if (all.planes.empty()) all = Image(image.width, image.height);
    umbrameter::require_same_size(all, image, "surface channels");
    all.planes.merge(image.planes);
  }
  return all;
}

void note_rounding(const EngineVisibility& engine, ScoreInputs& inputs) {
  if (engine.dark > 0)
    inputs.notes.push_back(
        fmt::format("{} pixels left out: so dark without shadows that their ratio is 0 / 0", engine.dark));
  if (engine.brighter > 0)
    inputs.notes.push_back(
        fmt::format("{} pixels left out: brighter with shadows than without", engine.brighter));
  if (engine.largest_step <= 0.0) return;
  inputs.mean_square_rounding = engine.mean_square_rounding;
  inputs.notes.push_back(
      fmt::format("the pictures' steps are up to {:.4f} of visibility; their rounding, {:.5f} in the root "
                  "mean square, is "
                  "added to the uncertainty",
                  engine.largest_step, std::sqrt(engine.mean_square_rounding)));
}

/// One image as ours, or a pair.
EngineVisibility engine_visibility(const ScoreInputOptions& options) {
  const auto decode = [&](const std::string& file) {
    return decode_engine_image(read_image(file), file, options.transfer);
  };
  if (options.test.empty()) return visibility_of_pair(decode(options.shadowed), decode(options.unshadowed));
  return visibility_of(decode(options.test));
}

void note_alignment(ScoreInputs& inputs) {
  if (const auto better = better_alignment(inputs.test, inputs.reference))
    inputs.notes.push_back("the picture fits the truth far better when it is read " + *better);
}

}  // namespace

void add_score_input_options(CLI::App& verb, ScoreInputOptions& options) {
  verb.add_option("test", options.test, "image: channel 'visibility', 'Y', a single channel, or grey RGB");
  verb.add_option("--reference", options.reference, "EXR made by 'umbrameter reference'");
  verb.add_option("--scene", options.scene,
                  "scene that the picture shows; renders the reference unless it is given");
  verb.add_option("--shadowed", options.shadowed,
                  "instead of an image: the scene lit by the light alone, with shadows");
  verb.add_option("--unshadowed", options.unshadowed, "the same without shadows; visibility is their ratio");
  verb.add_option("--transfer", options.transfer,
                  "how numbers of pictures of 8 or 16 bits follow from light: srgb, linear or gamma2.2");
  verb.add_option("--surfaces", options.surfaces,
                  "EXR with position.x/y/z or depth, normal.x/y/z, primitive_id; repeatable")
      ->allow_extra_args(false);
  verb.add_option("--depth", options.depth, "what a depth channel measures: axis (of the camera) or ray")
      ->check(CLI::IsMember({"axis", "ray"}));
  verb.add_option("--quality", options.quality.quality,
                  "of a reference that is rendered; the size is the picture's")
      ->capture_default_str();
  verb.add_option("--spp", options.quality.samples_per_pixel,
                  "samples a pixel of a reference that is rendered");
  verb.add_option("--seed", options.quality.seed, "likewise")->capture_default_str();
}

ScoreInputs load_score_inputs(const ScoreInputOptions& options, const GlobalOptions& global) {
  check_options(options);
  if (!global.light.empty() && options.scene.empty())
    fail_input("--light goes with --scene: a reference image is of one light already");
  ScoreInputs inputs;
  inputs.test_name = options.test.empty() ? options.shadowed : options.test;
  inputs.reference_name = options.reference.empty() ? options.scene : options.reference;
  // Our own images, and any other that already has a visibility channel of floats, are taken as they are.
  const bool is_plain = !options.test.empty() && options.transfer.empty() && options.test.ends_with(".exr");
  std::optional<EngineVisibility> engine;
  if (is_plain) {
    inputs.test = with_visibility(read_image(options.test), options.test);
  } else {
    engine = engine_visibility(options);
    inputs.test = engine->image;
  }
  if (!options.scene.empty()) inputs.scene = load_scene_job(options.scene, scene_search(global, find_home()));
  inputs.reference = options.reference.empty() ? render_truth(*inputs.scene, options, global, inputs.test)
                                               : read_image(options.reference);
  inputs.eye_world = eye_of(inputs.reference, inputs.reference_name);
  require_same_size(inputs);
  const bool was_aligned = has_surfaces(inputs.test);
  if (!was_aligned && !options.surfaces.empty()) {
    const Camera* camera = inputs.scene ? &inputs.scene->scene.camera : nullptr;
    const DepthKind kind = options.depth == "ray" ? DepthKind::ray : DepthKind::axis;
    const Image surfaces = read_surfaces(options);
    for (std::string& note : add_surfaces(surfaces, camera, kind, inputs.reference, inputs.test))
      inputs.notes.push_back(std::move(note));
  } else if (!was_aligned) {
    inputs.notes.push_back(
        "no surface channels: not known whether the picture shows the same places under the same light; give "
        "--surfaces");
  }
  if (!was_aligned) note_alignment(inputs);
  if (engine) {
    apply_rounding(*engine, inputs.test, inputs.reference);
    note_rounding(*engine, inputs);
  }
  return inputs;
}

}  // namespace umbrameter
