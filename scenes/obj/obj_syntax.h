// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a statement of an OBJ file may look like. tinyobjloader reads garbage as zeros, so each is checked first.

#include "scenes/obj/obj_repairs.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace umbrameter {

/// From `offset` on, a statement's text is that of `line`, column 1 and on.
struct ObjPiece {
  size_t offset = 0;
  int line = 0;
};

/// A statement and where it stands.
struct ObjText {
  std::string_view text;
  const std::string& file;
  std::span<const ObjPiece> pieces;  // at least one
  bool is_last = false;              // the file ends in it, without a line end
};

/// True when `line` ends in a backslash that is not in a comment: the statement goes on in the next line.
bool is_continued(std::string_view line);

/// `statement` up to its comment: "#" anywhere after numbers; after names only as a word of its own, because names may
/// hold it.
std::string_view without_comment(std::string_view statement);

/// Throws Error{input} at file:line:column unless `text` is a statement that we read, or one that has no bearing on
/// shadows (smoothing groups, lines, points, ...). `v` and `vn` need three numbers; a corner of `f` is i, i/j, i//k or
/// i/j/k of nonzero integers. Returns true when `repaired` is to be read instead: corners without slashes at their ends,
/// a normal of zeros for one that is not finite, nothing for a face of less than three corners; each is counted.
bool check_obj_statement(const ObjText& text, ObjRepairs& repairs, std::string& repaired);

}  // namespace umbrameter
