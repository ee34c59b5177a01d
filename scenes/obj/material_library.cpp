// SPDX-License-Identifier: Apache-2.0
#include "scenes/obj/material_library.h"

#include "core/files.h"
#include "scenes/obj/tinyobj.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace umbrameter {
namespace {

/// Windows writes backslashes.
std::filesystem::path picture_file(const std::filesystem::path& library, std::string picture) {
  std::replace(picture.begin(), picture.end(), '\\', '/');
  return library.parent_path() / picture;
}

MaterialHoles holes_of(const tinyobj::material_t& material, const std::filesystem::path& library) {
  const tinyobj::texture_option_t& options = material.alpha_texopt;
  MaterialHoles holes;
  holes.alpha = static_cast<float>(material.dissolve);
  holes.picture = material.alpha_texname;
  if (!holes.picture.empty()) holes.file = picture_file(library, holes.picture);
  holes.uv_scale = {static_cast<float>(options.scale[0]), static_cast<float>(options.scale[1])};
  holes.uv_offset = {static_cast<float>(options.origin_offset[0]),
                     static_cast<float>(options.origin_offset[1])};
  holes.clamps = options.clamp;
  return holes;
}

}  // namespace

void MaterialLibrary::read(const std::filesystem::path& file, const std::string& obj_name,
                           std::vector<std::string>& warnings) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    warnings.push_back(fmt::format("{}: the material library '{}' is not there, so no material has holes",
                                   obj_name, file.filename().string()));
    return;
  }
  std::istringstream text(read_file(file));
  std::map<std::string, int> indices;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  tinyobj::LoadMtl(&indices, &materials, &text, &warning, &error);
  for (const tinyobj::material_t& material : materials) {
    const MaterialHoles holes = holes_of(material, file);
    if (!holes.picture.empty() || !(holes.alpha >= kLeastAlpha)) holes_[material.name] = holes;
  }
}

const MaterialHoles* MaterialLibrary::find(const std::string& name) const {
  const auto found = holes_.find(name);
  return found == holes_.end() ? nullptr : &found->second;
}

}  // namespace umbrameter
