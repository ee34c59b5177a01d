// SPDX-License-Identifier: Apache-2.0
#include "scenes/gltf/gltf_mask.h"

#include "core/error.h"
#include "core/image_io.h"
#include "scenes/gltf/tinygltf.h"
#include "scenes/read_mask.h"

#include <cmath>

namespace umbrameter {
namespace {

constexpr double kBlendCutoff = 0.5;

double number_in(const tinygltf::Value& object, const char* key, size_t index, double fallback) {
  if (!object.Has(key)) return fallback;
  const tinygltf::Value& value = object.Get(key);
  const tinygltf::Value& item = value.IsArray() && index < value.ArrayLen() ? value.Get(index) : value;
  return item.IsNumber() ? item.GetNumberAsDouble() : fallback;
}

/// KHR_texture_transform: translation * rotation * scale; then v, which glTF counts downwards, is turned.
glm::dmat3 uv_transform(const tinygltf::TextureInfo& info) {
  glm::dmat3 transform(1.0);
  const auto found = info.extensions.find("KHR_texture_transform");
  if (found != info.extensions.end()) {
    const tinygltf::Value& e = found->second;
    const double angle_rad = number_in(e, "rotation", 0, 0.0);
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    const glm::dvec2 scale(number_in(e, "scale", 0, 1.0), number_in(e, "scale", 1, 1.0));
    transform = glm::dmat3(glm::dvec3(c * scale.x, -s * scale.x, 0), glm::dvec3(s * scale.y, c * scale.y, 0),
                           glm::dvec3(number_in(e, "offset", 0, 0.0), number_in(e, "offset", 1, 0.0), 1));
  }
  return glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 1, 1)) * transform;
}

const tinygltf::Image* picture_of(const tinygltf::Model& model, int texture) {
  if (texture < 0 || static_cast<size_t>(texture) >= model.textures.size()) return nullptr;
  const int source = model.textures[static_cast<size_t>(texture)].source;
  if (source < 0 || static_cast<size_t>(source) >= model.images.size()) return nullptr;
  return &model.images[static_cast<size_t>(source)];
}

std::string name_of(const tinygltf::Image& image) {
  if (!image.uri.empty() && !image.uri.starts_with("data:")) return image.uri;
  const bool is_jpeg = image.mimeType == "image/jpeg";
  return (image.name.empty() ? "picture" : image.name) + (is_jpeg ? ".jpg" : ".png");
}

/// Alpha times this is at least kLeastAlpha where the material is solid.
float alpha_scale(const tinygltf::Material& material, double cutoff) {
  const std::vector<double>& color = material.pbrMetallicRoughness.baseColorFactor;
  const double alpha = color.size() == 4 ? color[3] : 1.0;
  return static_cast<float>(static_cast<double>(kLeastAlpha) * alpha / cutoff);
}

}  // namespace

std::optional<GltfHoles> read_gltf_holes(const GltfFile& file, int material,
                                         std::vector<std::string>& warnings) {
  const tinygltf::Model& model = *file.model;
  if (material < 0 || static_cast<size_t>(material) >= model.materials.size()) return std::nullopt;
  const tinygltf::Material& m = model.materials[static_cast<size_t>(material)];
  const bool is_blend = m.alphaMode == "BLEND";
  if (m.alphaMode != "MASK" && !is_blend) return std::nullopt;
  const double cutoff = is_blend ? kBlendCutoff : m.alphaCutoff;
  if (!(cutoff > 0.0)) return std::nullopt;
  const std::string what = fmt::format("{}: material '{}'", file.path.filename().string(), m.name);
  if (is_blend)
    warnings.push_back(fmt::format("{} blends: it is solid from an alpha of 0.5 on, and a hole below", what));
  const tinygltf::TextureInfo& info = m.pbrMetallicRoughness.baseColorTexture;
  const float scale = alpha_scale(m, cutoff);
  const tinygltf::Image* picture = picture_of(model, info.index);
  if (picture == nullptr) {
    if (scale >= kLeastAlpha) return std::nullopt;
    return GltfHoles{AlphaMask{m.name, 1, 1, {0}}, 0, glm::dmat3(1.0)};
  }
  if (picture->image.empty()) {
    warnings.push_back(
        fmt::format("{}: the picture '{}' is not there, so it is solid", what, name_of(*picture)));
    return std::nullopt;
  }
  auto mask = mask_by_alpha(read_image(std::span<const uint8_t>(picture->image), name_of(*picture)),
                            name_of(*picture), scale);
  if (!mask && scale >= kLeastAlpha) return std::nullopt;  // no alpha channel: 1 everywhere
  if (!mask) mask = AlphaMask{m.name, 1, 1, {0}};
  return GltfHoles{std::move(*mask), info.texCoord, uv_transform(info)};
}

}  // namespace umbrameter
