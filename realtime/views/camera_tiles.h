// SPDX-License-Identifier: Apache-2.0
#pragma once
// The part of a scene's box that the camera's frustum touches. No GL.

#include "realtime/views/light_view.h"

namespace umbrameter {

/// The cells of the scene's box, 16 a side, that are not wholly outside one of the frustum's planes (near and far apart:
/// only what lies behind the eye is left out).
std::vector<ReceiverTile> camera_tiles(const Scene& scene, int width_px, int height_px);

}  // namespace umbrameter
