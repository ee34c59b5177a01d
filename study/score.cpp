// SPDX-License-Identifier: Apache-2.0
#include "study/score.h"

#include "core/error.h"
#include "study/guard.h"
#include "study/maps.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

namespace umbrameter {
namespace {

constexpr std::array<std::string_view, 8> kSurfaceChannels{
    "position.x", "position.y", "position.z",   "normal.x",
    "normal.y",   "normal.z",   "primitive_id", "unshadowed_irradiance"};

bool is_grey(const Image& image) {
  if (!image.has("R") || !image.has("G") || !image.has("B")) return false;
  const auto r = image.plane("R");
  const auto g = image.plane("G");
  const auto b = image.plane("B");
  return std::equal(r.begin(), r.end(), g.begin()) && std::equal(r.begin(), r.end(), b.begin());
}

std::string visibility_channel(const Image& image, const std::string& file) {
  if (image.has("Y")) return "Y";
  if (image.planes.size() == 1) return image.planes.begin()->first;
  if (is_grey(image)) return "R";
  std::vector<std::string> names;
  for (const auto& [name, plane] : image.planes) names.push_back(name);
  fail_input(fmt::format("the image has no visibility channel, only {}", fmt::join(names, ", ")), {file},
             "name the channel 'visibility', or give a grey image");
}

const SimilarityReference& similarity_reference(const Image& reference, std::span<const uint8_t> mask,
                                                SharedTruth& shared) {
  if (!shared.similarity || !std::ranges::equal(shared.similarity->mask(), mask))
    shared.similarity.emplace(reference, mask);
  return *shared.similarity;
}

}  // namespace

Image with_visibility(Image image, const std::string& file) {
  if (image.has("visibility")) return image;
  auto node = image.planes.extract(visibility_channel(image, file));
  node.key() = "visibility";
  image.planes.insert(std::move(node));
  return image;
}

bool has_surfaces(const Image& image) {
  return std::all_of(kSurfaceChannels.begin(), kSurfaceChannels.end(),
                     [&](std::string_view channel) { return image.has(channel); });
}

glm::dvec3 eye_of(const Image& reference, const std::string& file) {
  const auto found = reference.metadata.find("eye_world");
  if (found == reference.metadata.end()) {
    fail_input("the reference has no 'umbrameter:eye_world' in its header", {file},
               "make it with 'umbrameter reference'");
  }
  std::istringstream text(found->second);
  glm::dvec3 eye_world{0.0};
  text >> eye_world.x >> eye_world.y >> eye_world.z;
  if (!text)
    fail_input(
        fmt::format("the reference's 'umbrameter:eye_world' is '{}', not three numbers", found->second),
        {file});
  return eye_world;
}

Score score_image(const Image& test, const Image& reference, const glm::dvec3& eye_world,
                  const ScoreSettings& settings, SharedTruth* shared) {
  Score score;
  SharedTruth own;
  SharedTruth& truth = shared != nullptr ? *shared : own;
  score.has_surfaces = has_surfaces(test);
  const double eye[3] = {eye_world.x, eye_world.y, eye_world.z};
  score.parity = compare_surfaces(score.has_surfaces ? test : reference, reference, eye);
  if (!score.parity.passes) return score;
  score.mask = scored_mask(score.parity, reference);
  score.error = measure_visibility_error(test, reference, score.mask);
  if (settings.maps) score.maps = Image(test.width, test.height);
  Image* maps = score.maps ? &*score.maps : nullptr;
  if (settings.metrics.significance) {
    const Significance significance = measure_significance(test, reference, score.mask);
    score.judgement.significance = significance_numbers(significance);
    if (maps != nullptr) add_z_map(significance, *maps);
  }
  if (settings.limit_rmse) {
    score.judgement.limit = judge_against(*settings.limit_rmse, *score.error, reference, score.mask);
  }
  if (settings.metrics.similarity)
    score.similarity = similarity_reference(reference, score.mask, truth).measure(test, maps);
  if (!settings.metrics.diagnosis) return score;
  score.no_diagnosis = guarded([&] {
    DiagnosedImage diagnosed = diagnose(test, reference, score.mask);
    score.diagnosis = diagnosed.numbers;
    if (maps != nullptr) add_diagnosis_maps(diagnosed, score.mask, *maps);
    score.fault_classes = std::move(diagnosed.classes);
  });
  return score;
}

}  // namespace umbrameter
