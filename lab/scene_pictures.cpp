// SPDX-License-Identifier: Apache-2.0
#include "lab/scene_pictures.h"

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

std::string text_of_choice(const TechniqueChoice& choice) {
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

ScenePictures::ScenePictures(SceneJob job, const PictureQuality& picture, PictureRenderers renderers,
                             Progress& progress)
    : job_(std::move(job)),
      request_(request_of(picture)),
      renderers_(renderers),
      progress_(progress),
      seed_(picture.seed) {}

std::string ScenePictures::key_of(const std::string& what) const {
  return fmt::format("{} {}", seed_, what);
}

Image ScenePictures::render(Renderer& renderer, const Scene& scene, uint64_t seed,
                            const TechniqueChoice& choice, const Image* blocker_truth) {
  RenderRequest request = request_;
  request.seed = seed;
  request.technique = choice.technique;
  request.parameters = choice.parameters;
  request.blocker_truth = blocker_truth;
  return renderer.render(scene, request, progress_).image;
}

const Image& ScenePictures::truth() {
  const auto [found, is_new] = pictures_.try_emplace(key_of("truth"));
  if (is_new) found->second = truth_of(job_.scene, seed_);
  return found->second;
}

const Image& ScenePictures::exact() {
  const auto [found, is_new] = pictures_.try_emplace(key_of("exact"));
  if (is_new) found->second = truth_of(job_.scene, seed_ + 1);
  return found->second;
}

const Examined& ScenePictures::examined_exact() {
  const auto [found, is_new] = examined_.try_emplace(key_of("exact"));
  if (is_new) found->second = examine(exact(), truth(), eye_world());
  return found->second;
}

Image ScenePictures::truth_of(const Scene& changed, uint64_t seed) {
  return render(renderers_.reference, changed, seed, {});
}

Image ScenePictures::truth_of_shadows(const Scene& changed) {
  return with_shadows_of(truth_of(changed, seed_ + 1), truth(), eye_world());
}

Image ScenePictures::truth_with_other_threads() {
  return render(renderers_.reference_other_threads, job_.scene, seed_, {});
}

const Image& ScenePictures::picture(const TechniqueChoice& choice) {
  const auto [found, is_new] = pictures_.try_emplace(key_of(text_of_choice(choice)));
  if (is_new) found->second = picture(choice, seed_);
  return found->second;
}

Image ScenePictures::picture(const TechniqueChoice& choice, uint64_t seed) {
  return render(renderers_.realtime, job_.scene, seed, choice);
}

const Examined& ScenePictures::examined(const TechniqueChoice& choice) {
  const auto [found, is_new] = examined_.try_emplace(key_of(text_of_choice(choice)));
  if (is_new) found->second = examine(picture(choice), truth(), eye_world());
  return found->second;
}

Unresolved ScenePictures::unresolved(const TechniqueChoice& choice) {
  const std::vector<uint8_t>& mask = examined(choice).mask;
  if (mask.empty()) return {};
  return {share_of_coarse_edges(picture(choice), truth(), mask),
          share_of_narrow_shade(picture(choice), truth(), mask)};
}

Image ScenePictures::picture_of_shadows(const TechniqueChoice& choice, const Scene& changed) {
  return shadows_of(choice, changed, picture(choice));
}

Image ScenePictures::shadows_of(const TechniqueChoice& choice, const Scene& changed, const Image& surfaces,
                                const Image* blocker_truth) {
  return with_shadows_of(render(renderers_.realtime, changed, seed_, choice, blocker_truth), surfaces,
                         eye_world());
}

}  // namespace umbrameter
