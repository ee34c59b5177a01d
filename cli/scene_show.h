// SPDX-License-Identifier: Apache-2.0
#pragma once
// A quick look at a scene.

#include "cli/verbs.h"

#include <string>

namespace umbrameter {

/// Traces the scene with few samples, under the chosen light or all of them, and writes a PNG for the eye: what lights see
/// of a white scene, each light as bright as any other, with a faint light from the camera.
int show_scene(const std::string& name, const GlobalOptions& global);

}  // namespace umbrameter
