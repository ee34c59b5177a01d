// SPDX-License-Identifier: Apache-2.0
#pragma once
// What every image file says about itself in its header ("umbrameter:<key>").

#include "core/renderer.h"
#include "scenes/scene.h"

#include <string>

namespace umbrameter {

/// Adds scene, scene_hash, light, animated ("fan: spin at 0.5 s", where something is), eye_world, seed, device, version and
/// commit; with a technique also technique and parameters.
void add_metadata(Frame& frame, const Scene& scene, const RenderRequest& request);

/// "a=1 b=2", by name.
std::string to_text(const ParameterValues& parameters);

/// A file name of letters, digits, '.', '_' and '-' that stays recognisable ("assets/bunny" ->
/// "assets-bunny").
std::string file_name_of(const std::string& label);

}  // namespace umbrameter
