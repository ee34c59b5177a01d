// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which faces of a mesh file to keep.

#include <compare>
#include <string>
#include <vector>

namespace umbrameter {

/// Where a mesh file's holes come from.
enum class MeshMasks {
  own,    // its materials
  none,   // nowhere: all of it is solid
  given,  // the caller, who adds mask 0: every triangle is a cutout of it, with the file's texture coordinates
};

/// By the names of materials, groups, objects, nodes or meshes. Empty `include` keeps all.
struct MeshFilter {
  std::vector<std::string> include;
  std::vector<std::string> exclude;
  MeshMasks masks = MeshMasks::own;
  auto operator<=>(const MeshFilter&) const = default;
};

}  // namespace umbrameter
