// SPDX-License-Identifier: Apache-2.0
#include "core/image.h"

#include "core/error.h"
#include "core/names.h"

#include <cmath>
#include <utility>

namespace umbrameter {

namespace {

std::vector<std::string> channel_names(const Image& image) {
  std::vector<std::string> names;
  for (const auto& [name, plane] : image.planes) names.push_back(name);
  return names;
}

}  // namespace

std::span<const float> Image::plane(std::string_view channel) const {
  const auto found = planes.find(channel);
  if (found == planes.end()) {
    fail_input(fmt::format("the image has no channel '{}'", channel), {},
               suggest_name(channel, channel_names(*this)));
  }
  return found->second;
}

std::span<float> Image::plane(std::string_view channel) {
  const std::span<const float> found = std::as_const(*this).plane(channel);
  return {const_cast<float*>(found.data()), found.size()};
}

std::span<float> Image::add_plane(const std::string& channel, float value) {
  return planes.try_emplace(channel, pixel_count(), value).first->second;
}

void require_same_size(const Image& a, const Image& b, std::string_view what) {
  if (a.width == b.width && a.height == b.height) return;
  fail_input(
      fmt::format("{}: image sizes differ, {}x{} against {}x{}", what, a.width, a.height, b.width, b.height));
}

void require_finite(const Image& image, std::string_view channel) {
  const std::span<const float> values = image.plane(channel);
  for (size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    const size_t width = static_cast<size_t>(image.width);
    fail_input(fmt::format("channel '{}' is {} at pixel ({}, {})", channel, values[i], i % width, i / width));
  }
}

}  // namespace umbrameter
