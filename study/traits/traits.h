// SPDX-License-Identifier: Apache-2.0
#pragma once
// The six properties by which paper E (table 4.1) tells techniques apart, computed instead of judged. Sees only
// Renderer&. docs/traits.md says what each number means.

#include "lab/answers.h"
#include "lab/keys.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

enum class Trait { precise, soft, anti_aliased, contact_hardening, acne_free, noise_free };
inline constexpr size_t kTraits = 6;
std::string_view name_of(Trait trait);
/// What is measured, in one line.
std::string_view measure_of(Trait trait);

enum class TraitVerdict { yes, partly, no };
/// "Y", "~", "N", as in the paper.
std::string_view symbol_of(TraitVerdict verdict);

/// Absent value: the technique does not take part, or there was nothing to measure.
struct TraitResult {
  std::optional<double> value;
  std::optional<TraitVerdict> verdict;
};

struct TechniqueTraits {
  std::string id;
  std::array<TraitResult, kTraits> results;
  std::string failure;  // of the first render that failed
  const TraitResult& of(Trait trait) const { return results[static_cast<size_t>(trait)]; }
};

/// The verdict on a measured value.
TraitVerdict judge(Trait trait, double value);

/// What paper E claims of a technique, by our id; empty for those it does not have.
std::span<const TraitVerdict> paper_e_claim(std::string_view technique_id);

/// The library scenes that the measurements need, in the order of TraitScenes.
std::span<const std::string> trait_scene_names();

/// Parameters of the group "bias" at their neutral values: numbers at their minimum, choices at their first.
using NeutralBias = std::function<ParameterValues(const TechniqueRun&)>;

inline constexpr PictureQuality kTraitPicture{.width_px = 480, .height_px = 270, .samples_per_pixel = 1024};

struct TraitInputs {
  std::span<const SceneJob> scenes;  // trait_scene_names()
  Renderers renderers;
  NeutralBias neutral_bias;
  PictureQuality picture = kTraitPicture;  // the samples are those that `renderers` were made with
  Makers makers = {};                      // of what is kept
  Answers* answers = nullptr;              // where values are kept; null: nowhere
};

/// One row a run. The stairs of `hard` at a small map are the unit of anti_aliased. A render that fails is recorded and the
/// rest goes on.
std::vector<TechniqueTraits> measure_traits(std::span<const TechniqueRun> runs, const TraitInputs& inputs,
                                            Progress& progress);

}  // namespace umbrameter
