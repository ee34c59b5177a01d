// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_mask.h"

#include "core/image_io.h"

namespace umbrameter {
namespace {

/// Pictures name their channels; grey ones have one, of any name.
std::span<const float> coverage_of(const Image& image) {
  for (const char* name : {"A", "R"}) {
    if (image.has(name)) return image.plane(name);
  }
  return image.planes.begin()->second;
}

AlphaMask make_mask(const Image& image, std::span<const float> coverage, const std::string& name,
                    float alpha) {
  AlphaMask mask{name, static_cast<uint32_t>(image.width), static_cast<uint32_t>(image.height), {}};
  mask.bits.resize((image.pixel_count() + 31) / 32, 0);
  for (uint32_t y = 0; y < mask.height; ++y) {
    const size_t row = size_t{mask.height - 1 - y} * mask.width;
    for (uint32_t x = 0; x < mask.width; ++x) {
      const uint32_t texel = y * mask.width + x;
      if (coverage[row + x] * alpha >= kLeastAlpha) mask.bits[texel / 32] |= 1u << (texel % 32);
    }
  }
  return mask;
}

}  // namespace

AlphaMask read_mask(const std::filesystem::path& path, float alpha) {
  const Image image = read_image(path);
  return make_mask(image, coverage_of(image), path.filename().string(), alpha);
}

std::optional<AlphaMask> mask_by_alpha(const Image& image, const std::string& name, float alpha) {
  if (!image.has("A")) return std::nullopt;
  return make_mask(image, image.plane("A"), name, alpha);
}

}  // namespace umbrameter
