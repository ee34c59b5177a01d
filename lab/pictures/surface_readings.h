// SPDX-License-Identifier: Apache-2.0
#pragma once
// How an engine's surfaces might have been meant: axes, units, kinds of depth, and channels that were never filled. Not here:
// aligning them (lab/pictures/engine_surfaces.h).

#include "lab/pictures/engine_surfaces.h"

namespace umbrameter {

/// Depth of a point, along the camera's axis or its own ray.
double depth_of(const glm::dvec3& p_world, const Camera& camera, DepthKind kind);

/// A place for every pixel of `surfaces`' depth; `unit` is its unit in ours. Not finite where depth is not.
std::vector<glm::dvec3> positions_from_depth(const Image& surfaces, const Camera& camera, DepthKind kind,
                                             double unit);

/// One sentence for each other reading that fits `reference` where `reading` does not, with the option that chooses it, and
/// for each channel that is the same in every pixel.
std::vector<std::string> better_readings(const EngineSurfaces& surfaces, const SurfaceReading& reading,
                                         const Image& reference);

}  // namespace umbrameter
