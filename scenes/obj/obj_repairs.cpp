// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/obj_repairs.h"

#include <fmt/format.h>

#include <string_view>

namespace umbrameter {
namespace {

struct RepairText {
  std::string_view one, many;  // what follows the count
};

// In the order of ObjRepair.
constexpr std::array<RepairText, 6> kTexts = {{
    {"corner with slashes at its end is read without them",
     "corners with slashes at their ends are read without them"},
    {"face of less than three corners is left out", "faces of less than three corners are left out"},
    {"normal that is not finite is not used", "normals that are not finite are not used"},
    {"texture point that is no number is taken as 0 0",
     "texture points that are no numbers are taken as 0 0"},
    {"corner is left out, being where its neighbour is",
     "corners are left out, being where their neighbours are"},
    {"face crosses itself, so its triangles are a guess",
     "faces cross themselves, so their triangles are a guess"},
}};

}  // namespace

void ObjRepairs::add(ObjRepair kind, int line, size_t count) {
  Tally& tally = tallies_[static_cast<size_t>(kind)];
  if (tally.count == 0) tally.first_line = line;
  tally.count += count;
}

void ObjRepairs::report(const std::string& file, std::vector<std::string>& warnings) const {
  for (size_t i = 0; i < tallies_.size(); ++i) {
    const Tally& tally = tallies_[i];
    if (tally.count == 0) continue;
    warnings.push_back(tally.count == 1 ? fmt::format("{}: {} {} (line {})", file, tally.count, kTexts[i].one,
                                                      tally.first_line)
                                        : fmt::format("{}: {} {} (the first in line {})", file, tally.count,
                                                      kTexts[i].many, tally.first_line));
  }
}

}  // namespace umbrameter
