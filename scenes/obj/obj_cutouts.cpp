// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/obj_cutouts.h"

#include "core/error.h"
#include "scenes/read_mask.h"

#include <algorithm>
#include <cmath>

namespace umbrameter {
namespace {

bool is_in_range(const glm::vec2& uv) {
  return std::abs(uv.x) <= kMaxUv && std::abs(uv.y) <= kMaxUv;  // false for what is not finite
}

bool is_in_range(const std::array<glm::vec2, 3>& uv) {
  return std::all_of(uv.begin(), uv.end(), [](const glm::vec2& at) { return is_in_range(at); });
}

}  // namespace

ObjCutouts::ObjCutouts(std::filesystem::path file) : file_(std::move(file)) {}

void ObjCutouts::read_library(const std::string& name, size_t triangles) {
  side_files_.push_back(file_.parent_path() / name);
  library_.read(side_files_.back(), obj_name(), warnings_);
  if (triangles == 0 || !library_.has_holes()) return;
  warnings_.push_back(
      fmt::format("{}: the material library '{}' is named after the first face; faces before it are solid",
                  obj_name(), name));
}

void ObjCutouts::add(size_t triangle, const std::string& material, const std::array<glm::vec2, 3>& uv) {
  const auto known = std::find(materials_.begin(), materials_.end(), material);
  const auto index = static_cast<size_t>(known - materials_.begin());
  if (known == materials_.end()) {
    materials_.push_back(material);
    triangle_counts_.push_back(0);
  }
  ++triangle_counts_[index];
  entries_.push_back({triangle, index, uv});
}

/// None: the material stays solid, and `what` it is was said.
std::optional<AlphaMask> ObjCutouts::mask_of(const MaterialHoles& holes, const std::string& what) {
  if (holes.picture.empty()) {
    warnings_.push_back(fmt::format("{} (d = {:.3g}), less than half there: a hole", what, holes.alpha));
    return AlphaMask{"d", 1, 1, {0}};
  }
  side_files_.push_back(holes.file);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(holes.file, ignored)) {
    warnings_.push_back(
        fmt::format("{}: the mask '{}' is not there, so they are solid", what, holes.picture));
    return std::nullopt;
  }
  AlphaMask mask = read_mask(holes.file, holes.alpha);
  if (holes.clamps)
    warnings_.push_back(fmt::format("{}: the mask '{}' is repeated, not clamped", what, holes.picture));
  return mask;
}

void ObjCutouts::finish(MeshData& mesh, std::vector<std::string>& warnings) {
  std::vector<std::optional<uint32_t>> masks;
  for (size_t i = 0; i < materials_.size(); ++i) {
    const std::string what =
        fmt::format("{}: {} triangle{} of material '{}'", obj_name(), triangle_counts_[i],
                    triangle_counts_[i] == 1 ? "" : "s", materials_[i]);
    auto mask = mask_of(*library_.find(materials_[i]), what);
    masks.push_back(mask ? std::optional(static_cast<uint32_t>(mesh.masks.size())) : std::nullopt);
    if (mask) mesh.masks.push_back(std::move(*mask));
  }
  size_t out_of_range = 0;
  if (!mesh.masks.empty()) mesh.cutout_of_triangle.assign(mesh.triangles.size(), kSolid);
  for (Entry& entry : entries_) {
    if (!masks[entry.material]) continue;
    const MaterialHoles& holes = *library_.find(materials_[entry.material]);
    for (glm::vec2& uv : entry.uv) uv = uv * holes.uv_scale + holes.uv_offset;
    if (!is_in_range(entry.uv)) {
      ++out_of_range;
      continue;
    }
    mesh.cutout_of_triangle[entry.triangle] = static_cast<uint32_t>(mesh.cutouts.size());
    mesh.cutouts.push_back({entry.uv, *masks[entry.material]});
  }
  if (out_of_range > 0)
    warnings_.push_back(
        fmt::format("{}: {} triangle{} with holes: texture coordinates not finite or beyond {}; solid",
                    obj_name(), out_of_range, out_of_range == 1 ? "" : "s", kMaxUv));
  mesh.side_files = std::move(side_files_);
  warnings.insert(warnings.end(), warnings_.begin(), warnings_.end());
}

}  // namespace umbrameter
