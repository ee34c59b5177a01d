// SPDX-License-Identifier: Apache-2.0
#pragma once
// What material files (MTL) say about holes, through tinyobjloader; everything else in them has no bearing on shadows.

#include "scenes/cutouts.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// Of a material whose surface is not solid everywhere.
struct MaterialHoles {
  float alpha = 1.0f;                         // d, or 1 - Tr
  std::string picture;                        // map_d as written; empty = none
  std::filesystem::path file;                 // where it should be
  glm::vec2 uv_scale{1.0f}, uv_offset{0.0f};  // of the picture: -s and -o
  bool clamps = false;
};

class MaterialLibrary {
 public:
  /// Reads `file`. A file that is not there is a line in `warnings` that begins with `obj_name`.
  void read(const std::filesystem::path& file, const std::string& obj_name,
            std::vector<std::string>& warnings);
  /// The holes of material `name`; null when it is solid or not known.
  const MaterialHoles* find(const std::string& name) const;
  bool has_holes() const { return !holes_.empty(); }

 private:
  std::map<std::string, MaterialHoles> holes_;
};

}  // namespace umbrameter
