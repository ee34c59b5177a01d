// SPDX-License-Identifier: Apache-2.0
#pragma once
// Tuned values as files: a preset to be used with --preset or pasted into a manifest, and plain numbers for an engine.

#include "results/tune/tuning.h"

#include <span>
#include <string>

namespace umbrameter {

/// TOML: the technique, and one preset with what was tuned and what else differs from the technique's defaults.
std::string preset_toml(const TuneResult& result);

/// The tuning of one light of a scene.
struct LightTuning {
  std::string light;
  const TuneResult* result = nullptr;
};
/// The same with a preset a light, each with its 'light'.
std::string preset_toml(std::span<const LightTuning> tunings);

/// One "name = value" a tuned parameter, lengths in both units where the texel is known.
std::string engine_block(const TuneResult& result);

}  // namespace umbrameter
