// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene with several lights is several views of it, one a light.

#include "scenes/scene.h"

#include <string>
#include <vector>

namespace umbrameter {

/// Index of the light called `text`, else of the one whose number it is, counted from 1. Error{input} with the names
/// there are.
size_t find_light(const std::vector<Light>& lights, const std::string& text);

/// The indices that `text` chooses: of find_light(), or of all when it is empty.
std::vector<size_t> choose_lights(const std::vector<Light>& lights, const std::string& text);

/// What the view of a scene under one of its lights is called: "scene", or "scene/light" when there are several.
std::string lit_name(const std::string& scene, const std::vector<Light>& lights, size_t light);

/// The scene with that light alone, hashed like a file that holds no other.
Scene lit_by(Scene scene, size_t light);

}  // namespace umbrameter
