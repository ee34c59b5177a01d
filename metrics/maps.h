// SPDX-License-Identifier: Apache-2.0
#pragma once
// The metrics' per-pixel answers as channels of an EXR (docs/results.md). Not here: pictures of them (results/pictures/pictures.h).

#include "core/image.h"
#include "metrics/diagnosis.h"
#include "metrics/statistics/significance.h"

#include <cstdint>
#include <span>

namespace umbrameter {

/// Adds z: the standard normal deviate of the error, 0 where not tested; positive is too bright.
void add_z_map(const Significance& significance, Image& maps);

/// Adds fault_class (index of FaultClass), width_octaves and offset_world of the nearest accepted profile, within its
/// true width of the ridge, and width_known: 1 where there is one, 0 elsewhere, where both others are 0.
void add_diagnosis_maps(const DiagnosedImage& diagnosed, std::span<const uint8_t> mask, Image& maps);

}  // namespace umbrameter
