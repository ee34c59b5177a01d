// SPDX-License-Identifier: Apache-2.0
#pragma once
// Wavefront OBJ files (plain or .zst) through tinyobjloader: polygons, normals, materials and groups as
// parts.

#include "scenes/mesh_data.h"
#include "scenes/mesh_filter.h"

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

/// Reads `path`. Polygons are triangulated. `vn` become shading normals; triangles without three usable ones keep their
/// own normal. Triangles are grouped into one part per material (else group, else object), in order of appearance.
/// Vertices no triangle uses may remain. What is odd but clear is repaired (obj_repairs.h), counted in `warnings`.
/// Error{input} naming the file and, where there is one, the line: unreadable or truncated file, not an OBJ,
/// numbers not finite, indices of vertices not defined above, no faces, more than kMaxTriangles triangles, a
/// filter name that is not in the file.
MeshData load_obj(const std::filesystem::path& path, const MeshFilter& filter,
                  std::vector<std::string>& warnings);

}  // namespace umbrameter
