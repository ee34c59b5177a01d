// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/readback.h"

#include <vector>

namespace umbrameter {

namespace {

std::vector<float> read_floats(const Texture& texture) {
  const size_t count = static_cast<size_t>(texture.width()) * static_cast<size_t>(texture.height()) *
                       static_cast<size_t>(texture.format().components);
  std::vector<float> values(count);
  if (!texture.format().is_integer) {
    glGetTextureImage(texture.id(), 0, texture.format().format, GL_FLOAT,
                      static_cast<GLsizei>(count * sizeof(float)), values.data());
    return values;
  }
  std::vector<GLuint> integers(count);
  glGetTextureImage(texture.id(), 0, texture.format().format, GL_UNSIGNED_INT,
                    static_cast<GLsizei>(count * sizeof(GLuint)), integers.data());
  for (size_t i = 0; i < count; ++i)
    values[i] = integers[i] == 0xffffffffu ? -1.0f : static_cast<float>(integers[i]);
  return values;
}

}  // namespace

void read_texture(const Texture& texture, std::span<const std::string> channels, Image& image) {
  const auto width = static_cast<size_t>(texture.width());
  const auto height = static_cast<size_t>(texture.height());
  const auto components = static_cast<size_t>(texture.format().components);
  UMBRAMETER_ASSERT(image.width == texture.width() && image.height == texture.height(), "{}x{} into {}x{}",
                    width, height, image.width, image.height);
  UMBRAMETER_ASSERT(channels.size() <= components, "{} channels of {}", channels.size(), components);
  const std::vector<float> values = read_floats(texture);
  for (size_t component = 0; component < channels.size(); ++component) {
    if (channels[component].empty()) continue;
    const std::span<float> plane = image.add_plane(channels[component]);
    for (size_t y = 0; y < height; ++y) {
      const float* row = values.data() + (height - 1 - y) * width * components + component;
      for (size_t x = 0; x < width; ++x) plane[y * width + x] = row[x * components];
    }
  }
}

}  // namespace umbrameter
