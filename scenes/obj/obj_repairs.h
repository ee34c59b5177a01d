// SPDX-License-Identifier: Apache-2.0
#pragma once
// What was odd in an OBJ file and read all the same, counted.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace umbrameter {

enum class ObjRepair {
  trailing_slash,
  small_face,
  normal_not_finite,
  texture_not_finite,
  equal_neighbours,
  crossing_face
};

class ObjRepairs {
 public:
  /// `line` is 1-based.
  void add(ObjRepair kind, int line, size_t count = 1);
  /// Appends one line a kind that occurred: "`file`: how many, what was done, where the first is".
  void report(const std::string& file, std::vector<std::string>& warnings) const;

 private:
  struct Tally {
    size_t count = 0;
    int first_line = 0;
  };
  std::array<Tally, 6> tallies_{};
};

}  // namespace umbrameter
