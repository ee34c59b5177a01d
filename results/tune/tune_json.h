// SPDX-License-Identifier: Apache-2.0
#pragma once
// tune.json; its keys are described in docs/tuning.md.

#include "metrics/error/lit_sum.h"
#include "results/tune/tune_files.h"

#include <span>
#include <string>

namespace umbrameter {

std::string to_json_text(const TuneResult& result);
/// Of several lights: each with its tuning, and the lit sum of each scene.
std::string lights_json_text(std::span<const LightTuning> tunings, std::span<const LitSum> sums);

}  // namespace umbrameter
