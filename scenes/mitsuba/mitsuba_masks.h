// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a bsdf of Mitsuba says about holes.

#include "scenes/foreign/foreign_scene.h"
#include "scenes/mitsuba/mitsuba_objects.h"

#include <glm/mat3x3.hpp>

#include <functional>
#include <map>
#include <optional>

namespace umbrameter {

struct MitsubaSurface {
  bool is_nothing = false;       // bsdf `null`: no surface at all
  std::optional<uint32_t> mask;  // in the scene's masks
  glm::dmat3 to_uv{1.0};         // of homogeneous coordinates, before v is turned upwards
};

/// Finds a file that an element names; Error{input} when it is not there.
using FindFile = std::function<std::filesystem::path(const std::string& name, const MitsubaNode& where)>;

class MitsubaMasks {
 public:
  MitsubaMasks(const MitsubaObjects& objects, FindFile find_file, ForeignScene& scene)
      : objects_(objects), find_file_(std::move(find_file)), scene_(scene) {}

  /// Of a shape, by its first bsdf.
  MitsubaSurface surface_of(const MitsubaNode& shape);

 private:
  const MitsubaSurface& read_opacity(const MitsubaNode& opacity);
  MitsubaSurface read_bitmap(const MitsubaNode& texture);
  MitsubaSurface all_holes(double opacity);

  const MitsubaObjects& objects_;
  FindFile find_file_;
  ForeignScene& scene_;
  std::map<const MitsubaNode*, MitsubaSurface> known_;
};

}  // namespace umbrameter
