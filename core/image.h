// SPDX-License-Identifier: Apache-2.0
#pragma once
// A float image with named channels, the currency between the rooms. Not here: files (core/image_io.h).

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// Named float planes of one size: plane[y * width + x], row 0 on top. Channel names are those of DESIGN.md
/// ("visibility", "visibility_se", "position.x", ...). Integers (primitive_id) are exact up to 2^24;
/// primitive_id is -1 where nothing is hit. `metadata` goes to the EXR header.
struct Image {
  int width = 0;
  int height = 0;
  std::map<std::string, std::vector<float>, std::less<>> planes;
  std::map<std::string, std::string, std::less<>> metadata;

  Image() = default;
  Image(int width_px, int height_px) : width(width_px), height(height_px) {}

  size_t pixel_count() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
  bool has(std::string_view channel) const { return planes.find(channel) != planes.end(); }
  /// The plane of `channel`; Error{input} naming the missing and the present channels when it is not there.
  std::span<const float> plane(std::string_view channel) const;
  std::span<float> plane(std::string_view channel);
  /// Adds `channel` (or returns it when present), every pixel set to `value`.
  std::span<float> add_plane(const std::string& channel, float value = 0.0f);
};

/// Error{input} unless both images have the same size; the message names both sizes and `what`.
void require_same_size(const Image& a, const Image& b, std::string_view what);

/// Error{input} with channel, pixel and value at the first NaN or infinity in `channel`.
void require_finite(const Image& image, std::string_view channel);

}  // namespace umbrameter
