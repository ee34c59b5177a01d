// SPDX-License-Identifier: Apache-2.0
#pragma once
// A loaded scene from another camera.

#include "scenes/scene.h"

namespace umbrameter {

/// The scene from `camera`, with the hash of a file that says so. A near plane of 0 is derived.
Scene seen_from(Scene scene, const Camera& camera);

}  // namespace umbrameter
