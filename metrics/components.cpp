#include "metrics/components.h"

#include "core/error.h"

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

}  // namespace

Components label_components(std::span<const uint8_t> mask, int width, int height) {
  const size_t columns = static_cast<size_t>(width);
  UMBRAMETER_ASSERT(mask.size() == columns * static_cast<size_t>(height), "{} pixels", mask.size());
  Components out;
  out.label.assign(mask.size(), -1);
  std::vector<int32_t> parent;
  for (size_t row = 0; row < mask.size(); row += columns) {
    for (size_t x = 0; x < columns; ++x) {
      const size_t i = row + x;
      if (mask[i] == 0) continue;
      int32_t label = -1;
      const auto join = [&](size_t neighbour) {
        if (out.label[neighbour] >= 0) label = unite(parent, label, out.label[neighbour]);
      };
      if (x > 0) join(i - 1);
      // The pixel above touches both diagonals, which are then joined already.
      if (row > 0 && out.label[i - columns] >= 0) {
        join(i - columns);
      } else if (row > 0) {
        if (x > 0) join(i - columns - 1);
        if (x + 1 < columns) join(i - columns + 1);
      }
      if (label < 0) {
        label = static_cast<int32_t>(parent.size());
        parent.push_back(label);
      }
      out.label[i] = label;
    }
  }

  // A root comes before its members, so one sweep numbers them all.
  std::vector<int32_t> number(parent.size());
  for (size_t k = 0; k < parent.size(); ++k) {
    const int32_t root = find_root(parent, static_cast<int32_t>(k));
    number[k] = root == static_cast<int32_t>(k) ? static_cast<int32_t>(out.count++)
                                                : number[static_cast<size_t>(root)];
  }
  for (int32_t& label : out.label) {
    if (label >= 0) label = number[static_cast<size_t>(label)];
  }
  return out;
}

}  // namespace umbrameter
