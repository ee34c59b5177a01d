// SPDX-License-Identifier: Apache-2.0
#pragma once
// A recorded flight: cameras over time, kept in a TOML file of [[camera]] tables.

#include "scenes/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

struct CameraKey {
  double time_s = 0.0;  // since the path's start, rising
  Camera camera;
};

/// The camera at `time_s`, linear between keys; the first or last beyond them. `path` must not be empty.
Camera camera_at(const std::vector<CameraKey>& path, double time_s);

std::string camera_path_toml(const std::vector<CameraKey>& path);

/// Error{input} at its place for what camera_path_toml() would not write. Near planes are `near_world`.
std::vector<CameraKey> read_camera_path(const std::filesystem::path& file, double near_world);

}  // namespace umbrameter
