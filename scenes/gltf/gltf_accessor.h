// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers out of a glTF file's buffers, checked before they are read.

#include "scenes/gltf/gltf_model.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace umbrameter {

/// Of an accessor: `components` values an element, one element after the other.
struct GltfNumbers {
  size_t count = 0;
  int components = 0;
  std::vector<double> values;
};

/// Integers that are `normalized` become fractions; sparse accessors are filled in. `what` names the accessor in errors.
/// Error{input} for one that does not exist, has no buffer, or reaches out of it.
GltfNumbers read_gltf_numbers(const GltfFile& file, int accessor, const std::string& what);

/// One element per index, each of up to four components. Error{input} likewise.
std::vector<glm::dvec4> read_gltf_vectors(const GltfFile& file, int accessor, const std::string& what);
std::vector<uint32_t> read_gltf_indices(const GltfFile& file, int accessor);

}  // namespace umbrameter
