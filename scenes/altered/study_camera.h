// SPDX-License-Identifier: Apache-2.0
#pragma once
// `[[camera]]` of a study file (docs/studies.md): from where each of its scenes is seen, instead of the scene's own camera.

#include "core/toml.h"
#include "scenes/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

struct StudyCamera {
  std::string name;              // unique in the study
  double orbit_deg = 0.0;        // the scene's camera turned around its target
  std::optional<Camera> camera;  // instead of it; near_world may be 0
};

/// "plate"; from a study's camera "plate, left".
std::string full_name(const std::string& scene, const std::string& camera);

/// Lists of `orbit_deg` expanded, in file order; none without `[[camera]]`. Error{input} at its place for unknown keys,
/// names given twice and cameras that see nothing.
std::vector<StudyCamera> read_study_cameras(TomlReader& study);

/// The camera in a scene whose own is `own`.
Camera camera_in(const StudyCamera& chosen, const Camera& own);

}  // namespace umbrameter
