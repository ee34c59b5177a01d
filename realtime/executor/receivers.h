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

/// Share of the receivers that lie outside what `view` covers, in [0,1]; 0 without receivers.
double share_outside(const Image& gbuffer, const LightView& view);

/// The plane on which most receivers lie, coplanar triangles taken together: unit normal as the G-buffer has it (towards
/// the camera) and w with n . p + w = 0. (0, 1, 0, 0) without receivers.
glm::dvec4 receiver_plane(const Image& gbuffer);

}  // namespace umbrameter
