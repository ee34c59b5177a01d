// SPDX-License-Identifier: Apache-2.0
#include "lab/score.h"

#include "core/error.h"
#include "core/guard.h"
#include "metrics/error/lit_error.h"
#include "metrics/maps.h"
#include "results/catalogue.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

namespace umbrameter {
namespace {

constexpr std::array<std::string_view, 8> kSurfaceChannels{
    "position.x", "position.y", "position.z",   "normal.x",
    "normal.y",   "normal.z",   "primitive_id", "unshadowed_irradiance"};

const SimilarityReference& similarity_reference(const Image& reference, std::span<const uint8_t> mask,
                                                SharedTruth& shared) {
  if (!shared.similarity || !std::ranges::equal(shared.similarity->mask(), mask))
    shared.similarity.emplace(reference, mask);
  return *shared.similarity;
}

/// And its profiles, for rows that are measured from them; none without a diagnosis.
std::vector<PenumbraProfile> add_diagnosis(const Image& test, const Image& reference, Score& score) {
  std::vector<PenumbraProfile> profiles;
  score.no_diagnosis = guarded([&] {
    DiagnosedImage diagnosed = diagnose(test, reference, score.mask);
    score.diagnosis = diagnosed.numbers;
    if (score.maps) add_diagnosis_maps(diagnosed, score.mask, *score.maps);
    score.fault_classes = std::move(diagnosed.classes);
    profiles = std::move(diagnosed.profiles);
  });
  return profiles;
}

}  // namespace

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
  const std::vector<uint8_t> scorable = scorable_mask(reference);
  score.scorable_pixels = static_cast<size_t>(std::ranges::count(scorable, 1));
  score.parity = compare_surfaces(score.has_surfaces ? test : reference, reference, eye_world);
  if (!score.parity.passes) return score;
  score.mask = scored_mask(score.parity, reference);
  for (size_t i = 0; i < settings.known.size(); ++i) score.mask[i] &= settings.known[i];
  score.error = measure_visibility_error(test, reference, score.mask);
  if (score.error->scored_pixels == 0) return score;  // nothing is neither right nor alike
  if (reference.has("irradiance_half_a")) score.lit_rmse = measure_lit_error(test, reference, score.mask);
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
  std::vector<PenumbraProfile> profiles;
  if (settings.metrics.diagnosis) profiles = add_diagnosis(test, reference, score);
  score.measured =
      measure_rows({.test = test, .reference = reference, .mask = score.mask, .profiles = profiles});
  return score;
}

}  // namespace umbrameter
