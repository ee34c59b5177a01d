// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a walked profile says about width and place of an edge. Not here: finding and walking it
// (metrics/penumbra/penumbra_walk.h) and what many of them say (metrics/penumbra/penumbra.h).

#include "metrics/penumbra/penumbra.h"
#include "metrics/penumbra/penumbra_walk.h"

#include <cstdint>
#include <span>

namespace umbrameter {

/// Both sides of a seed.
struct WalkedProfile {
  const ReferenceField& field;
  std::span<const float> test;
  size_t seed = 0;
  const Ascent& ascent;
  const Walk &dark, &bright;
};

/// Judges the reference, then the test, by their whole rise where the reference has one, else by the stretch that there
/// is. Fills in the profile's widths, offsets, levels and outcome.
void judge_profile(const WalkedProfile& walked, const PenumbraSettings& settings, PenumbraProfile& profile);

/// By the stretch alone: for seeds off the ridge.
void judge_stretch(const WalkedProfile& walked, const PenumbraSettings& settings, PenumbraProfile& profile);

}  // namespace umbrameter
