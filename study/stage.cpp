// SPDX-License-Identifier: Apache-2.0
#include "study/stage.h"

#include "lab/score.h"
#include "metrics/error/truth_check.h"
#include "metrics/image/shadow_quantity.h"
#include "results/guard.h"
#include "results/measured.h"
#include "results/metadata.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <array>

namespace umbrameter {
namespace {

constexpr double kSameSurface = 1e-3;  // of the distance to the eye
constexpr std::array kShadowChannels = {"visibility",
                                        "visibility_se",
                                        "half_a",
                                        "half_b",
                                        "irradiance_ratio",
                                        "irradiance_ratio_se",
                                        "irradiance_half_a",
                                        "irradiance_half_b",
                                        "sample_count",
                                        "blocker_distance",
                                        "blocker_distance_min",
                                        "blocker_layers",
                                        "blocker_offset.x",
                                        "blocker_offset.y",
                                        "blocker_offset.z",
                                        "texel.x",
                                        "texel.y",
                                        "texel_world",
                                        "bias_world",
                                        "map_index"};

std::string text_of(const TechniqueChoice& choice) {
  return choice.technique + " " + to_text(choice.parameters);
}

glm::dvec3 place(const Image& image, size_t i) {
  return {image.plane("position.x")[i], image.plane("position.y")[i], image.plane("position.z")[i]};
}

// Shadows of `from` where it shows the same places.
Image with_shadows_of(const Image& from, Image onto, const glm::dvec3& eye_world) {
  for (const char* channel : kShadowChannels) {
    if (!from.has(channel) || !onto.has(channel)) continue;
    const std::span<const float> source = from.plane(channel);
    const std::span<float> target = onto.plane(channel);
    for (size_t i = 0; i < target.size(); ++i) {
      const glm::dvec3 p_world = place(onto, i);
      if (glm::distance(place(from, i), p_world) <= kSameSurface * glm::distance(eye_world, p_world))
        target[i] = source[i];
    }
  }
  return onto;
}

}  // namespace

TechniqueChoice with(TechniqueChoice choice, const ParameterValues& parameters) {
  for (const auto& [name, value] : parameters) choice.parameters[name] = value;
  return choice;
}

Examined examine(const Image& picture, const Image& truth, const glm::dvec3& eye_world,
                 const ErrorMetric& metric) {
  Examined out;
  out.run.metric_problems = metric_problems(metric);
  Score score;
  std::optional<Image> made;
  out.run.failure =
      guarded([&] { score = score_image(picture, truth_for(picture, truth, made), eye_world); });
  if (out.run.failure) return out;
  out.run.parity_passes = score.parity.passes;
  out.run.is_other_light = score.parity.is_other_light;
  if (!score.parity.passes) return out;
  if (const auto reason = unmeasured(score.error->scored_pixels, score.scorable_pixels)) {
    out.run.failure = Failure{ErrorKind::input, *reason};
    return out;
  }
  out.run.truth_problems = truth_problems(truth, score.mask);
  out.run.error = score.error;
  out.run.diagnosis = score.diagnosis;
  out.run.measured = score.measured;
  out.run.failure = score.no_diagnosis;
  out.mask = std::move(score.mask);
  out.fault_classes = std::move(score.fault_classes);
  return out;
}

std::string text_of(const SelftestRound& round) {
  return fmt::format("{} x {} px, seed {}", round.width_px, round.height_px, round.seed);
}

Stage::Stage(SceneJob job, const SelftestSettings& settings, const SelftestRound& round,
             SelftestRenderers renderers, Progress& progress)
    : job_(std::move(job)),
      settings_(settings),
      round_(round),
      renderers_(renderers),
      progress_(progress),
      seed_(round.seed) {}

std::string Stage::key_of(const std::string& what) const {
  return fmt::format("{} {}", seed_, what);
}

Image Stage::render(Renderer& renderer, const Scene& scene, uint64_t seed, const TechniqueChoice& choice,
                    const Image* blocker_truth) {
  RenderRequest request;
  request.width_px = round_.width_px;
  request.height_px = round_.height_px;
  request.seed = seed;
  request.technique = choice.technique;
  request.parameters = choice.parameters;
  request.blocker_truth = blocker_truth;
  return renderer.render(scene, request, progress_).image;
}

const Image& Stage::truth() {
  const auto [found, is_new] = pictures_.try_emplace(key_of("truth"));
  if (is_new) found->second = truth_of(job_.scene, seed_);
  return found->second;
}

const Image& Stage::exact() {
  const auto [found, is_new] = pictures_.try_emplace(key_of("exact"));
  if (is_new) found->second = truth_of(job_.scene, seed_ + 1);
  return found->second;
}

const Examined& Stage::examined_exact() {
  const auto [found, is_new] = examined_.try_emplace(key_of("exact"));
  if (is_new) found->second = examine(exact(), truth(), eye_world());
  return found->second;
}

Image Stage::truth_of(const Scene& changed, uint64_t seed) {
  return render(renderers_.reference, changed, seed, {});
}

Image Stage::truth_of_shadows(const Scene& changed) {
  return with_shadows_of(truth_of(changed, seed_ + 1), truth(), eye_world());
}

Image Stage::truth_with_other_threads() {
  return render(renderers_.reference_other_threads, job_.scene, seed_, {});
}

const Image& Stage::picture(const TechniqueChoice& choice) {
  const auto [found, is_new] = pictures_.try_emplace(key_of(text_of(choice)));
  if (is_new) found->second = picture(choice, seed_);
  return found->second;
}

Image Stage::picture(const TechniqueChoice& choice, uint64_t seed) {
  return render(renderers_.realtime, job_.scene, seed, choice);
}

const Examined& Stage::examined(const TechniqueChoice& choice) {
  const auto [found, is_new] = examined_.try_emplace(key_of(text_of(choice)));
  if (is_new) found->second = examine(picture(choice), truth(), eye_world());
  return found->second;
}

Unresolved Stage::unresolved(const TechniqueChoice& choice) {
  const std::vector<uint8_t>& mask = examined(choice).mask;
  if (mask.empty()) return {};
  return {share_of_coarse_edges(picture(choice), truth(), mask),
          share_of_narrow_shade(picture(choice), truth(), mask)};
}

Image Stage::picture_of_shadows(const TechniqueChoice& choice, const Scene& changed) {
  return shadows_of(choice, changed, picture(choice));
}

Image Stage::shadows_of(const TechniqueChoice& choice, const Scene& changed, const Image& surfaces,
                        const Image* blocker_truth) {
  return with_shadows_of(render(renderers_.realtime, changed, seed_, choice, blocker_truth), surfaces,
                         eye_world());
}

}  // namespace umbrameter
