// SPDX-License-Identifier: Apache-2.0
#pragma once
// Many pixels at once proven lit: most of a picture needs no look at its pixels one by one.

#include "reference/light_proof.h"

#include <span>

namespace umbrameter {

/// Whether no triangle meets the hull of all the pixels' shafts, so that each of them sees the whole light. Errs towards
/// false as prove_light() does.
bool proves_all_lit(const OccluderTree& tree, const Scene& scene, double scene_extent_world,
                    std::span<const ShaftPixel> pixels);

}  // namespace umbrameter
