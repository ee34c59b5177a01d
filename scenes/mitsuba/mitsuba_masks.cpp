// SPDX-License-Identifier: Apache-2.0
#include "scenes/mitsuba/mitsuba_masks.h"

#include "scenes/mitsuba/mitsuba_numbers.h"
#include "scenes/read_mask.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace umbrameter {
namespace {

constexpr int kDeepestBsdf = 16;
constexpr std::array<std::string_view, 3> kAround = {"twosided", "bumpmap", "normalmap"};
constexpr std::array<std::string_view, 3> kGlass = {"dielectric", "thindielectric", "roughdielectric"};

bool is_one_of(std::span<const std::string_view> types, const std::string& type) {
  return std::ranges::find(types, type) != types.end();
}

}  // namespace

MitsubaSurface MitsubaMasks::surface_of(const MitsubaNode& shape) {
  auto bsdfs = objects_.nested(shape, "bsdf");
  for (int depth = 0; !bsdfs.empty(); ++depth) {
    const MitsubaNode& bsdf = *bsdfs.front();
    const std::string& type = bsdf.get("type");
    if (depth > kDeepestBsdf) fail_input("bsdfs are nested deeper than 16", bsdf.where);
    if (type == "null") return {.is_nothing = true, .mask = {}};
    if (is_one_of(kGlass, type)) scene_.of_meshes.add("shape of glass is solid", "shapes of glass are solid");
    if (type == "mask") {
      const MitsubaNode* opacity = bsdf.find("opacity");
      return opacity == nullptr ? all_holes(0.5) : read_opacity(objects_.resolve(*opacity));
    }
    if (!is_one_of(kAround, type)) break;
    bsdfs = objects_.nested(bsdf, "bsdf");
  }
  return {};
}

const MitsubaSurface& MitsubaMasks::read_opacity(const MitsubaNode& opacity) {
  const auto [known, is_new] = known_.try_emplace(&opacity);
  if (!is_new) return known->second;
  const std::string& type = opacity.get("type");
  if (opacity.tag != "texture") {
    const glm::dvec3 colour = mitsuba_vector(opacity, 0.5);
    known->second = all_holes(0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z);
  } else if (type == "bitmap") {
    known->second = read_bitmap(opacity);
  } else {
    scene_.of_meshes.add(fmt::format("mask by a texture of type '{}' is left out: it is solid", type),
                         fmt::format("masks by textures of type '{}' are left out: they are solid", type));
  }
  return known->second;
}

MitsubaSurface MitsubaMasks::all_holes(double opacity) {
  if (opacity > 0.0 && opacity < 1.0)
    scene_.of_meshes.add("mask of an even opacity is solid from 0.5 on, and a hole below",
                         "masks of an even opacity are solid from 0.5 on, and holes below");
  if (opacity >= static_cast<double>(kLeastAlpha)) return {};
  scene_.masks.push_back({"opacity", 1, 1, {0}});
  return {.mask = static_cast<uint32_t>(scene_.masks.size() - 1)};
}

MitsubaSurface MitsubaMasks::read_bitmap(const MitsubaNode& texture) {
  const std::filesystem::path file = find_file_(texture.text("filename", ""), texture);
  if (texture.text("wrap_mode", "repeat") != "repeat")
    scene_.of_meshes.add("mask is repeated, not clamped or mirrored",
                         "masks are repeated, not clamped or mirrored");
  scene_.masks.push_back(
      mask_by_colour(file, {.is_luminance = true, .is_encoded = !texture.boolean("raw", false)}));
  MitsubaSurface surface{.mask = static_cast<uint32_t>(scene_.masks.size() - 1)};
  // The renderer, too, takes the third column for the shift, and ignores the last column and what lies below the second row.
  const glm::dmat4 m = mitsuba_transform(texture, "to_uv");
  surface.to_uv = glm::dmat3(m[0].x, m[0].y, 0, m[1].x, m[1].y, 0, m[2].x, m[2].y, 1);
  const glm::dmat3 of_0_6(texture.number("uscale", 1.0), 0, 0, 0, texture.number("vscale", 1.0), 0,
                          texture.number("uoffset", 0.0), texture.number("voffset", 0.0), 1);
  surface.to_uv = surface.to_uv * of_0_6;
  return surface;
}

}  // namespace umbrameter
