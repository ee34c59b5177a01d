// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/readback.h"

#include "scenes/instances.h"

#include <algorithm>
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
    values[i] = integers[i] == 0xffffffffu ? -1.0f : static_cast<float>(shown_id(integers[i]));
  return values;
}

/// All texels of a layer and level, row by row from the bottom.
std::vector<float> read_layer_floats(const Texture& texture, int layer, int level) {
  const int width = level_side(texture.width(), level), height = level_side(texture.height(), level);
  const TextureFormat& format = texture.format();
  std::vector<float> values(static_cast<size_t>(width) * static_cast<size_t>(height) *
                            static_cast<size_t>(format.components));
  const auto read = [&](GLenum type, size_t bytes, void* to) {
    glGetTextureSubImage(texture.id(), level, 0, 0, layer, width, height, 1, format.format, type,
                         static_cast<GLsizei>(bytes), to);
  };
  if (!format.is_integer) {
    read(GL_FLOAT, values.size() * sizeof(float), values.data());
    return values;
  }
  std::vector<GLuint> integers(values.size());
  read(GL_UNSIGNED_INT, integers.size() * sizeof(GLuint), integers.data());
  std::ranges::transform(integers, values.begin(), [](GLuint value) { return static_cast<float>(value); });
  return values;
}

}  // namespace

Image read_layer(const Texture& texture, int layer, int level) {
  const int width = level_side(texture.width(), level), height = level_side(texture.height(), level);
  const auto components = static_cast<size_t>(texture.format().components);
  const std::vector<float> values = read_layer_floats(texture, layer, level);
  const auto columns = static_cast<size_t>(width), rows = static_cast<size_t>(height);
  Image image(width, height);
  for (size_t component = 0; component < components; ++component) {
    const std::span<float> plane = image.add_plane(components == 1 ? "Y" : std::string(1, "RGBA"[component]));
    for (size_t i = 0; i < plane.size(); ++i)
      plane[i] = values[((rows - 1 - i / columns) * columns + i % columns) * components + component];
  }
  return image;
}

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
