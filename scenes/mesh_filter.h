// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which faces of a mesh file to keep.

#include <compare>
#include <string>
#include <vector>

namespace umbrameter {

/// By the names of materials, groups, objects, nodes or meshes. Empty `include` keeps all.
struct MeshFilter {
  std::vector<std::string> include;
  std::vector<std::string> exclude;
  auto operator<=>(const MeshFilter&) const = default;
};

}  // namespace umbrameter
