// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which of two stored runs is nearer to the truth, from their images: no renderer is asked.

#include "results/json/record.h"
#include "store/store.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace umbrameter {

/// What a sweep keeps of a run's picture: visibility, and where it is scored.
struct StoredPicture {
  Image image;
  std::vector<uint8_t> mask;
};

/// The planes `visibility` and `scored` (0 or 1).
Image picture_to_store(const Image& image, std::span<const uint8_t> mask);

/// The mask of such a picture; empty without one.
std::vector<uint8_t> stored_mask(const Image& picture);

/// Of the run under `key`; absent when it is not stored, failed, was not comparable, or another verb made it.
std::optional<StoredPicture> find_picture(Store& store, const std::string& key);

/// Sets the verdicts of all runs: against the scene's first run, as the sweep had it, or against the run labelled `baseline`
/// of the same picture. Runs without a picture, and those whose baseline or truth is not stored, get none.
void judge_runs(Store& store, std::span<RunRecord> runs, const std::string& baseline = {});

}  // namespace umbrameter
