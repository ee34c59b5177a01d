// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a line of an OBJ file may look like. tinyobjloader reads garbage as zeros, so each line is checked
// first.

#include <string>
#include <string_view>

namespace umbrameter {

/// Throws Error{input} at file:line:column unless `text` (without its line end) is a statement that we read,
/// or one that has no bearing on shadows (texture coordinates, smoothing groups, material files, lines,
/// points, ...). `v` and `vn` need three numbers; `f` needs three corners i, i/j, i//k or i/j/k of nonzero
/// integers.
void check_obj_line(std::string_view text, const std::string& file, int line);

}  // namespace umbrameter
