// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which triangles of an OBJ file have holes, and where.

#include "scenes/mesh_data.h"
#include "scenes/obj/material_library.h"

#include <string>
#include <vector>

namespace umbrameter {

/// Collects the texture coordinates of triangles whose material has holes; finish() reads the masks.
class ObjCutouts {
 public:
  /// `file`: the OBJ file, beside which material libraries are looked for.
  explicit ObjCutouts(std::filesystem::path file);

  /// `mtllib name`, after `triangles` triangles.
  void read_library(const std::string& name, size_t triangles);
  /// Null when `material` is solid.
  const MaterialHoles* find(const std::string& material) const { return library_.find(material); }
  /// Triangle number `triangle` is of `material`, which has holes; numbers grow.
  void add(size_t triangle, const std::string& material, const std::array<glm::vec2, 3>& uv);
  /// Fills cutouts and masks of `mesh`, whose triangles are still in the order in which they were added. A material whose
  /// picture cannot be used stays solid. What was done is said in `warnings`.
  void finish(MeshData& mesh, std::vector<std::string>& warnings);

 private:
  struct Entry {
    size_t triangle = 0;
    size_t material = 0;
    std::array<glm::vec2, 3> uv{};
  };
  std::string obj_name() const { return file_.filename().string(); }
  std::optional<AlphaMask> mask_of(const MaterialHoles& holes, const std::string& what);

  std::filesystem::path file_;
  MaterialLibrary library_;
  std::vector<std::string> materials_;   // with holes and in use
  std::vector<size_t> triangle_counts_;  // of each
  std::vector<Entry> entries_;
  std::vector<std::filesystem::path> side_files_;
  std::vector<std::string> warnings_;
};

}  // namespace umbrameter
