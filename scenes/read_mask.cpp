// SPDX-License-Identifier: Apache-2.0
#include "scenes/read_mask.h"

#include "core/image_io.h"
#include "core/srgb.h"

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

std::span<const float> first_colour_of(const Image& image) {
  for (const char* name : {"R", "Y"}) {
    if (image.has(name)) return image.plane(name);
  }
  return image.planes.begin()->second;
}

}  // namespace

AlphaMask read_mask(const std::filesystem::path& path, float alpha) {
  const Image image = read_image(path);
  return make_mask(image, coverage_of(image), path.filename().string(), alpha);
}

AlphaMask mask_by_colour(const std::filesystem::path& path, const ColourMask& how) {
  const ImagePart part = std::move(read_image_parts(path).front());
  const Image& image = part.image;
  const bool is_encoded = how.is_encoded && part.levels > 0;
  const auto linear = [is_encoded](float value) {
    return is_encoded ? static_cast<float>(linear_of_srgb(static_cast<double>(value))) : value;
  };
  std::vector<float> values;
  values.reserve(image.pixel_count());
  if (how.is_luminance && image.has("R") && image.has("G") && image.has("B")) {
    const auto r = image.plane("R"), g = image.plane("G"), b = image.plane("B");
    for (size_t i = 0; i < r.size(); ++i)
      values.push_back(0.2126f * linear(r[i]) + 0.7152f * linear(g[i]) + 0.0722f * linear(b[i]));
  } else {
    for (const float value : first_colour_of(image)) values.push_back(linear(value));
  }
  for (float& value : values) value = how.inverts ? 1.0f - how.scale * value : how.scale * value;
  return make_mask(image, values, path.filename().string(), 1.0f);
}

std::optional<AlphaMask> mask_by_alpha(const Image& image, const std::string& name, float alpha) {
  if (!image.has("A")) return std::nullopt;
  return make_mask(image, image.plane("A"), name, alpha);
}

}  // namespace umbrameter
