// SPDX-License-Identifier: Apache-2.0
#pragma once
// Wavefront OBJ files (plain or .zst) through tinyobjloader: polygons, normals, materials and groups as
// parts.

#include "scenes/mesh_data.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

/// Which faces to keep, by the name of their material, group or object. Empty `include` keeps all.
struct ObjFilter {
  std::vector<std::string> include;
  std::vector<std::string> exclude;
};

/// Reads `path`. Polygons are triangulated. `vn` become shading normals when every kept corner has one that
/// is not zero, else they are dropped with a note in `warnings`. Triangles are grouped into one part per
/// material (else group, else object), in order of appearance. Vertices no triangle uses may remain.
/// Error{input} naming the file and, where there is one, the line: unreadable or truncated file, not an OBJ,
/// numbers not finite, indices of vertices not defined above, no faces, more than kMaxTriangles triangles, a
/// filter name that is not in the file.
MeshData load_obj(const std::filesystem::path& path, const ObjFilter& filter,
                  std::vector<std::string>& warnings);

}  // namespace umbrameter
