// SPDX-License-Identifier: Apache-2.0
#pragma once
// Parity, visibility error, significance and diagnosis of one image against the reference; what `validate` and `score` both ask.

#include "core/image.h"
#include "metrics/error/lit_similarity.h"
#include "metrics/error/visibility_error.h"
#include "metrics/image/parity.h"
#include "results/metric_choice.h"
#include "results/results.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// `error` is absent when parity fails: such a comparison says nothing. Without a verdict: see judge_against.
struct Score : Measures {
  bool has_surfaces = false;  // whether the test image brought what parity needs
  Parity parity;  // without surfaces: the reference against itself, so it only finds the background
  std::vector<uint8_t> mask;              // scored pixels; empty when parity fails
  size_t scorable_pixels = 0;             // that the truth can score
  std::vector<FaultClass> fault_classes;  // [height][width]; empty without diagnosis
  std::optional<Failure> no_diagnosis;    // why; `error` stands without it
  std::optional<Image> maps;              // see metrics/maps.h; when asked for
};

struct ScoreSettings {
  MetricChoice metrics;
  std::optional<double> limit_rmse;
  bool maps = false;                    // of the metrics that are asked for
  std::span<const uint8_t> known = {};  // pixels of the picture that may be scored; empty: all
};

/// What the scores of one reference share, kept from one to the next; made anew where the mask is another.
struct SharedTruth {
  std::optional<SimilarityReference> similarity;
};

/// True when `image` has all channels that compare_surfaces needs.
bool has_surfaces(const Image& image);

/// Eye position that add_metadata stored; Error{input} when it is missing or malformed.
glm::dvec3 eye_of(const Image& reference, const std::string& file);

/// Scores visibility of `test` where its surfaces agree with the reference's; `shared`, if given, is of this
/// reference. Error{input} for size mismatch, missing reference channels, NaN and values outside [0,1].
Score score_image(const Image& test, const Image& reference, const glm::dvec3& eye_world,
                  const ScoreSettings& settings = {}, SharedTruth* shared = nullptr);

}  // namespace umbrameter
