// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes that a pbrt file holds itself.

#include "scenes/foreign/foreign_scene.h"
#include "scenes/pbrt/pbrt_parameters.h"

namespace umbrameter {

/// Error{input} for no positions, indices out of range or not in threes (fours), and lists of another length than the positions.
Primitive pbrt_triangles(const PbrtParameters& parameters);
/// Two triangles a patch; patches that are not flat are counted in `said`.
Primitive pbrt_patches(const PbrtParameters& parameters, Tally& said);

}  // namespace umbrameter
