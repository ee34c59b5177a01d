// SPDX-License-Identifier: Apache-2.0
#pragma once
// Mistakes that a scene can be drawn with all the same, for `scene check`.

#include "scenes/scene.h"

#include <string>
#include <vector>

namespace umbrameter {

/// A sentence for each of these:
///   a flat light with all of the scene behind it, or a sun that shines upwards;
///   a camera without a triangle in its view;
///   sizes that look like another unit than metres: a camera farther than 50 from its target, or nearer than 0.02;
///   a part with a hole: at most a tenth of its edges have one triangle;
///   a part without a hole that is inside out, unless the camera is in it: rooms are.
std::vector<std::string> check_scene(const Scene& scene);

}  // namespace umbrameter
