// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the camera sees of the scene that light could reach: from a G-buffer image with its channels
// position.*, primitive_id and unshadowed_irradiance (receiver_plane: normal.* too).

#include "core/image.h"
#include "realtime/views/light_view.h"

#include <vector>

namespace umbrameter {

inline constexpr int kReceiverTilePx = 16;

/// A box around the receivers of each 16x16 px tile that has any.
std::vector<ReceiverTile> receiver_tiles(const Image& gbuffer);

/// The same of the receivers in a slice of the camera's frustum.
std::vector<ReceiverTile> receiver_tiles(const Image& gbuffer, const Camera& camera,
                                         const CameraSlice& slice);

/// Nearest and farthest distance of the receivers along the camera's axis; twice its near plane without receivers.
DistanceRange receiver_range(const Image& gbuffer, const Camera& camera);

/// Share of the receivers that none of `views` covers, in [0,1]; 0 without receivers.
double share_outside(const Image& gbuffer, std::span<const LightView> views);

/// The plane on which most receivers lie, coplanar triangles taken together: unit normal as the G-buffer has it (towards
/// the camera) and w with n . p + w = 0. (0, 1, 0, 0) without receivers.
glm::dvec4 receiver_plane(const Image& gbuffer);

}  // namespace umbrameter
