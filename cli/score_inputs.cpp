// SPDX-License-Identifier: Apache-2.0
#include "cli/score_inputs.h"

#include "cli/home.h"
#include "cli/positive_number.h"
#include "cli/progress_bar.h"
#include "cli/reuse.h"
#include "core/error.h"
#include "core/image_io.h"
#include "lab/score.h"
#include "results/metadata.h"

#include <fmt/format.h>

namespace umbrameter {
namespace {

void check_options(const ScoreInputOptions& options, const GlobalOptions& global) {
  const bool is_pair = !options.shadowed.empty() || !options.unshadowed.empty();
  if (is_pair && (options.shadowed.empty() || options.unshadowed.empty()))
    fail_input("--shadowed and --unshadowed go together", {}, "give both, or one image with visibility");
  if (is_pair == !options.pictures.empty())
    fail_input(is_pair ? "an image and a pair are given" : "there is nothing to score", {},
               "give images with visibility, or --shadowed and --unshadowed");
  require_store(options.no_reuse, global);
  if (options.reference.empty() && options.scene.empty())
    fail_input("there is nothing to score against", {}, "--reference FILE, or --scene NAME to render it");
}

/// The truth of the scene at the picture's size.
Image render_truth(const SceneJob& job, const ScoreInputOptions& options, const GlobalOptions& global,
                   const EngineImage& picture) {
  QualityOptions wanted = options.quality;
  wanted.width = picture.width;
  wanted.height = picture.height;
  const Quality quality = choose_quality(wanted);
  VerbCache cache = open_cache(global, global.out, !options.no_reuse);
  ProgressBar progress;
  const RenderRequest request = request_of(quality.picture);
  Frame frame = cache.reference(quality.picture).render(job.scene, request, progress);
  print_reuse(cache);
  add_metadata(frame, job.scene, request);
  return std::move(frame.image);
}

PictureFiles files_of(const ScoreInputOptions& options) {
  PictureFiles files;
  files.shadowed = options.shadowed;
  files.unshadowed = options.unshadowed;
  files.transfer = options.transfer;
  files.choice = options.choice;
  files.surfaces = options.surfaces;
  return files;
}

std::vector<PictureInput> read_pictures(const ScoreInputOptions& options) {
  if (options.pictures.empty()) return {read_picture_input(files_of(options))};
  std::vector<PictureInput> inputs;
  for (const std::string& file : options.pictures) {
    PictureFiles files = files_of(options);
    files.picture = file;
    inputs.push_back(read_picture_input(files));
  }
  return inputs;
}

/// One picture, read as the others are.
PictureInput read_baseline(const ScoreInputOptions& options) {
  PictureFiles files = files_of(options);
  files.shadowed.clear();
  files.unshadowed.clear();
  files.picture = options.baseline;
  return read_picture_input(files);
}

}  // namespace

void add_score_input_options(CLI::App& verb, ScoreInputOptions& options) {
  verb.add_option("picture", options.pictures,
                  "pictures of visibility: channel 'visibility', grey, or grey colours of any layer");
  verb.add_option("--reference", options.reference, "EXR made by 'umbrameter reference'");
  verb.add_option("--scene", options.scene,
                  "scene that the pictures show; renders the reference unless it is given");
  verb.add_flag("--no-reuse", options.no_reuse,
                "render the truth of --scene though the store in --out knows it");
  verb.add_option("--shadowed", options.shadowed,
                  "instead of pictures: the scene lit by the light alone, with shadows");
  verb.add_option("--unshadowed", options.unshadowed, "the same without shadows; their ratio is scored");
  verb.add_option("--transfer", options.transfer,
                  "how numbers of pictures of 8 or 16 bits follow from light: srgb, linear or gamma2.2");
  verb.add_option("--channel", options.choice.channel,
                  "channel or layer that is the picture, such as Z or ViewLayer.Combined");
  verb.add_option("--part", options.choice.part,
                  "part of the file that is the picture: a number from 1, or a name");
  verb.add_option("--surfaces", options.surfaces,
                  "file with position or depth, normal, primitive_id; position=FILE says what it holds; "
                  "repeatable (default: the picture's own file)")
      ->allow_extra_args(false);
  verb.add_option("--depth", options.depth, "what a depth channel measures: axis (of the camera) or ray")
      ->check(CLI::IsMember({"axis", "ray"}));
  verb.add_option("--axes", options.axes,
                  "our x, y, z by the surfaces' axes, such as --axes=x,z,-y where z is up");
  verb.add_option("--unit", options.unit, "length of the surfaces' unit in ours: 0.01 for centimetres")
      ->check(positive_number());
  verb.add_option("--quality", options.quality.quality,
                  "of a reference that is rendered; the size is the picture's")
      ->capture_default_str();
  verb.add_option("--spp", options.quality.samples_per_pixel,
                  "samples per pixel of a reference that is rendered");
  verb.add_option("--seed", options.quality.seed, "likewise")->capture_default_str();
}

ScoreInputs load_score_inputs(const ScoreInputOptions& options, const GlobalOptions& global) {
  check_options(options, global);
  if (!global.light.empty() && options.scene.empty())
    fail_input("--light goes with --scene: a reference image is of one light already");
  if (global.time_s && options.scene.empty())
    fail_input("--time goes with --scene: a reference image is of one moment already");
  SurfaceReading reading;
  reading.depth = options.depth == "ray" ? DepthKind::ray : DepthKind::axis;
  reading.space = parse_surface_space(options.axes, options.unit);
  const std::vector<PictureInput> pictures = read_pictures(options);
  std::optional<PictureInput> baseline;
  if (!options.baseline.empty()) baseline = read_baseline(options);
  ScoreInputs inputs;
  inputs.reference_name = options.reference.empty() ? options.scene : options.reference;
  if (!options.scene.empty()) inputs.scene = load_scene_job(options.scene, scene_search(global, find_home()));
  inputs.reference = options.reference.empty()
                         ? render_truth(*inputs.scene, options, global, pictures.front().picture)
                         : read_image(options.reference);
  inputs.eye_world = eye_of(inputs.reference, inputs.reference_name);
  if (inputs.scene) reading.camera = &inputs.scene->scene.camera;
  for (const PictureInput& picture : pictures)
    inputs.pictures.push_back(align_picture(picture, reading, inputs.reference));
  if (baseline) inputs.baseline = align_picture(*baseline, reading, inputs.reference);
  return inputs;
}

}  // namespace umbrameter
