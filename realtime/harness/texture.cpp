// SPDX-License-Identifier: Apache-2.0
#include "core/names.h"
#include "realtime/harness/debug_log.h"
#include "realtime/harness/objects.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

namespace umbrameter {

namespace {

constexpr std::array<TextureFormat, 19> kFormats = {{
    {"depth32f", GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 4, true, false},
    {"depth24", GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 4, true, false},
    {"depth16", GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 2, true, false},
    {"depth24_stencil8", GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 4, true, false},
    {"depth32f_stencil8", GL_DEPTH32F_STENCIL8, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 8, true, false},
    {"r8", GL_R8, GL_RED, GL_FLOAT, 1, 1, false, false},
    {"r16", GL_R16, GL_RED, GL_FLOAT, 1, 2, false, false},
    {"r16f", GL_R16F, GL_RED, GL_FLOAT, 1, 2, false, false},
    {"r32f", GL_R32F, GL_RED, GL_FLOAT, 1, 4, false, false},
    {"rg8", GL_RG8, GL_RG, GL_FLOAT, 2, 2, false, false},
    {"rg16", GL_RG16, GL_RG, GL_FLOAT, 2, 4, false, false},
    {"rg16f", GL_RG16F, GL_RG, GL_FLOAT, 2, 4, false, false},
    {"rg32f", GL_RG32F, GL_RG, GL_FLOAT, 2, 8, false, false},
    {"rgba8", GL_RGBA8, GL_RGBA, GL_FLOAT, 4, 4, false, false},
    {"rgba16", GL_RGBA16, GL_RGBA, GL_FLOAT, 4, 8, false, false},
    {"rgba16f", GL_RGBA16F, GL_RGBA, GL_FLOAT, 4, 8, false, false},
    {"rgba32f", GL_RGBA32F, GL_RGBA, GL_FLOAT, 4, 16, false, false},
    {"r32ui", GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1, 4, false, true},
    {"rg32ui", GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 2, 8, false, true},
}};

void require_size(int width, int height, const std::string& name, const FileLocation& where) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (width >= 1 && height >= 1 && width <= limit && height <= limit) return;
  const std::string what = name.empty() ? "a texture" : fmt::format("texture '{}'", name);
  fail_input(fmt::format("{} of {} x {} is not possible", what, width, height), where,
             fmt::format("this device takes 1 to {} a side", limit));
}

GLenum target_of(const TextureShape& shape) {
  switch (shape.kind) {
    case TextureKind::flat:
      return shape.samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    case TextureKind::array:
      return GL_TEXTURE_2D_ARRAY;
    case TextureKind::cube:
      return GL_TEXTURE_CUBE_MAP;
  }
  return GL_NONE;
}

void require_shape(int width, int height, const TextureShape& shape, const std::string& name,
                   const FileLocation& where) {
  GLint max_samples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
  if (shape.samples < 1 || shape.samples > max_samples) {
    fail_input(fmt::format("texture '{}' with {} samples per texel is not possible", name, shape.samples),
               where, fmt::format("this device takes 1 to {}", max_samples));
  }
  GLint max_layers = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &max_layers);
  if (shape.layers < 1 || shape.layers > max_layers) {
    fail_input(fmt::format("texture '{}' of {} layers is not possible", name, shape.layers), where,
               fmt::format("this device takes 1 to {}", max_layers));
  }
  if (shape.kind == TextureKind::cube && width != height)
    fail_input(fmt::format("texture '{}' is a cube of {} x {} texels", name, width, height), where,
               "its faces must be square");
  if (shape.kind != TextureKind::flat && shape.samples > 1)
    fail_input(fmt::format("texture '{}' has layers and {} samples per texel", name, shape.samples), where,
               "only kind = \"2d\" can have samples");
  const int most = shape.samples > 1 ? 1 : full_chain_levels(width, height);
  if (shape.levels >= 1 && shape.levels <= most) return;
  fail_input(fmt::format("texture '{}' of {} x {} texels and {} samples cannot have {} levels", name, width,
                         height, shape.samples, shape.levels),
             where, fmt::format("1 to {}", most));
}

}  // namespace

int level_side(int side, int level) {
  return std::max(side >> level, 1);
}

int full_chain_levels(int width, int height) {
  return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(width, height))));
}

std::span<const TextureFormat> texture_formats() {
  return kFormats;
}

bool has_stencil(const TextureFormat& format) {
  return format.internal_format == GL_DEPTH24_STENCIL8 || format.internal_format == GL_DEPTH32F_STENCIL8;
}

const TextureFormat& find_texture_format(std::string_view name, const FileLocation& where) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const TextureFormat& format) { return format.name == name; });
  if (found != kFormats.end()) return *found;
  std::vector<std::string> names;
  for (const TextureFormat& format : kFormats) names.emplace_back(format.name);
  fail_input(fmt::format("unknown texture format '{}'", name), where, suggest_name(name, names));
}

Texture::Texture(const TextureFormat& format, int width, int height, const std::string& name,
                 const FileLocation& where, const TextureShape& shape)
    : Texture(declared(format, width, height, name, where, shape).allocated(name)) {}

Texture Texture::declared(const TextureFormat& format, int width, int height, const std::string& name,
                          const FileLocation& where, const TextureShape& shape) {
  require_size(width, height, name, where);
  require_shape(width, height, shape, name, where);
  Texture texture;
  texture.format_ = &format;
  texture.width_ = width;
  texture.height_ = height;
  texture.shape_ = shape;
  return texture;
}

Texture Texture::allocated(const std::string& name) const {
  Texture texture;
  texture.format_ = format_;
  texture.width_ = width_;
  texture.height_ = height_;
  texture.shape_ = shape_;
  GLuint id = 0;
  glCreateTextures(target_of(shape_), 1, &id);
  texture.handle_ = GlHandle<destroy_texture>(id);
  const GLenum format = format_->internal_format;
  if (shape_.samples > 1) {
    glTextureStorage2DMultisample(id, shape_.samples, format, width_, height_, GL_TRUE);
  } else if (shape_.kind == TextureKind::array) {
    glTextureStorage3D(id, shape_.levels, format, width_, height_, shape_.layers);
  } else {
    glTextureStorage2D(id, shape_.levels, format, width_, height_);
  }
  label_object(GL_TEXTURE, id, name);
  require_gl_memory(name.empty() ? "a texture" : fmt::format("texture '{}'", name), bytes());
  return texture;
}

size_t Texture::bytes() const {
  if (format_ == nullptr) return 0;
  size_t texels = 0;
  for (int level = 0; level < shape_.levels; ++level) {
    texels +=
        static_cast<size_t>(level_side(width_, level)) * static_cast<size_t>(level_side(height_, level));
  }
  return texels * static_cast<size_t>(shape_.layers) * static_cast<size_t>(shape_.samples) *
         static_cast<size_t>(format_->bytes_per_texel);
}

Texture Texture::view_of_level(const Texture& texture, int level) {
  UMBRAMETER_ASSERT(level >= 0 && level < texture.levels(), "level {} of {}", level, texture.levels());
  Texture view;
  GLuint id = 0;
  glGenTextures(1, &id);  // a view takes a name that no target has claimed
  view.handle_ = GlHandle<destroy_texture>(id);
  glTextureView(id, target_of(texture.shape_), texture.id(), texture.format().internal_format,
                static_cast<GLuint>(level), 1, 0, static_cast<GLuint>(texture.layers()));
  view.format_ = &texture.format();
  view.width_ = level_side(texture.width(), level);
  view.height_ = level_side(texture.height(), level);
  view.shape_.kind = texture.kind();
  view.shape_.layers = texture.layers();
  return view;
}

void clear_level(const Texture& texture, int level, std::span<const double> value) {
  UMBRAMETER_ASSERT(!value.empty(), "{} values to clear with", value.size());
  const auto at = [&](size_t i) { return value[std::min(i, value.size() - 1)]; };
  const TextureFormat& format = texture.format();
  const std::array<GLuint, 2> integers = {static_cast<GLuint>(at(0)), static_cast<GLuint>(at(1))};
  const std::array<float, 4> floats = {static_cast<float>(at(0)), static_cast<float>(at(1)),
                                       static_cast<float>(at(2)), static_cast<float>(at(3))};
  const void* texel = floats.data();
  if (format.is_integer) texel = integers.data();
  glClearTexImage(texture.id(), level, format.format, format.type, texel);
}

void clear_texture(const Texture& texture, std::span<const double> value) {
  for (int level = 0; level < texture.levels(); ++level) clear_level(texture, level, value);
}

}  // namespace umbrameter
