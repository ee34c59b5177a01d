// SPDX-License-Identifier: Apache-2.0
#include "metrics/image/components.h"

#include "core/error.h"
#include "metrics/image/tiles.h"

#include <algorithm>

namespace umbrameter {

namespace {

// Roots are the smallest provisional label of their set.
int32_t find_root(std::vector<int32_t>& parent, int32_t label) {
  while (parent[static_cast<size_t>(label)] != label) {
    int32_t& up = parent[static_cast<size_t>(label)];
    up = parent[static_cast<size_t>(up)];
    label = up;
  }
  return label;
}

int32_t unite(std::vector<int32_t>& parent, int32_t a, int32_t b) {
  if (a < 0) return b;
  if (a == b) return a;
  const int32_t root_a = find_root(parent, a), root_b = find_root(parent, b);
  const int32_t low = std::min(root_a, root_b);
  parent[static_cast<size_t>(std::max(root_a, root_b))] = low;
  return low;
}

struct Grid {
  std::span<const uint8_t> mask;
  size_t columns = 0;

  size_t rows() const { return columns == 0 ? 0 : mask.size() / columns; }
  /// visit(neighbour) for the pixels before `i` in reading order that it connects to, those of the row above
  /// only if `above` does.
  template <class Visit>
  void for_neighbours(size_t i, bool beside, bool above, const Visit& visit) const {
    const size_t x = i % columns;
    const auto visit_equal = [&](size_t j) {
      if (mask[j] == mask[i]) visit(j);
    };
    if (beside && x > 0) visit_equal(i - 1);
    if (!above) return;
    // The pixel above touches both diagonals, which are then joined already.
    if (mask[i - columns] == mask[i]) return visit(i - columns);
    if (x > 0) visit_equal(i - columns - 1);
    if (x + 1 < columns) visit_equal(i - columns + 1);
  }
};

/// Rows y0 <= y < y1 with labels of their own, from 0.
struct Strip {
  size_t y0 = 0, y1 = 0;
  std::vector<int32_t> parent;
};

void label_strip(const Grid& grid, Strip& strip, std::vector<int32_t>& labels) {
  for (size_t i = strip.y0 * grid.columns; i < strip.y1 * grid.columns; ++i) {
    if (grid.mask[i] == 0) continue;
    int32_t label = -1;
    grid.for_neighbours(i, true, i >= (strip.y0 + 1) * grid.columns,
                        [&](size_t j) { label = unite(strip.parent, label, labels[j]); });
    if (label < 0) {
      label = static_cast<int32_t>(strip.parent.size());
      strip.parent.push_back(label);
    }
    labels[i] = label;
  }
}

// One list of parents for all strips, joined along their upper rims; afterwards `first[k]` belongs to label 0
// of strip k.
std::vector<int32_t> join_strips(const Grid& grid, const std::vector<Strip>& strips,
                                 std::span<const int32_t> labels, std::vector<int32_t>& first) {
  std::vector<int32_t> parent;
  for (const Strip& strip : strips) {
    first.push_back(static_cast<int32_t>(parent.size()));
    for (const int32_t up : strip.parent) parent.push_back(first.back() + up);
  }
  for (size_t k = 1; k < strips.size(); ++k) {
    const size_t begin = strips[k].y0 * grid.columns;
    for (size_t i = begin; i < begin + grid.columns; ++i) {
      if (grid.mask[i] == 0) continue;
      grid.for_neighbours(i, false, true,
                          [&](size_t j) { unite(parent, first[k] + labels[i], first[k - 1] + labels[j]); });
    }
  }
  return parent;
}

// A root comes before its members, so one sweep numbers them all.
size_t number_roots(std::vector<int32_t>& parent) {
  std::vector<int32_t> number(parent.size());
  size_t count = 0;
  for (size_t k = 0; k < parent.size(); ++k) {
    const int32_t root = find_root(parent, static_cast<int32_t>(k));
    number[k] =
        root == static_cast<int32_t>(k) ? static_cast<int32_t>(count++) : number[static_cast<size_t>(root)];
  }
  parent = std::move(number);
  return count;
}

}  // namespace

Components label_components(std::span<const uint8_t> mask, int width, int height) {
  constexpr size_t kStripRows = 64;
  const Grid grid = {mask, static_cast<size_t>(width)};
  UMBRAMETER_ASSERT(mask.size() == grid.columns * static_cast<size_t>(height), "{} pixels", mask.size());
  Components out;
  out.label.assign(mask.size(), -1);
  const size_t rows = grid.rows();
  std::vector<Strip> strips =
      for_each_index<Strip>((rows + kStripRows - 1) / kStripRows, [&](size_t k, Strip& strip) {
        strip.y0 = k * kStripRows;
        strip.y1 = std::min(rows, strip.y0 + kStripRows);
        label_strip(grid, strip, out.label);
      });
  std::vector<int32_t> first;
  std::vector<int32_t> number = join_strips(grid, strips, out.label, first);
  out.count = number_roots(number);
  for_each_row(height, [&](int y) {
    const size_t begin = static_cast<size_t>(y) * grid.columns;
    const int32_t offset = first[static_cast<size_t>(y) / kStripRows];
    for (size_t i = begin; i < begin + grid.columns; ++i) {
      int32_t& label = out.label[i];
      if (label >= 0) label = number[static_cast<size_t>(offset + label)];
    }
  });
  return out;
}

}  // namespace umbrameter
