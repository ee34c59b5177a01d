#include "core/names.h"
#include "realtime/harness/debug_log.h"
#include "realtime/harness/objects.h"

#include <algorithm>
#include <array>
#include <vector>

namespace umbrameter {

namespace {

constexpr std::array<TextureFormat, 10> kFormats = {{
    {"depth32f", GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1, 4, true, false},
    {"r8", GL_R8, GL_RED, GL_FLOAT, 1, 1, false, false},
    {"r16f", GL_R16F, GL_RED, GL_FLOAT, 1, 2, false, false},
    {"r32f", GL_R32F, GL_RED, GL_FLOAT, 1, 4, false, false},
    {"rg16f", GL_RG16F, GL_RG, GL_FLOAT, 2, 4, false, false},
    {"rg32f", GL_RG32F, GL_RG, GL_FLOAT, 2, 8, false, false},
    {"rgba8", GL_RGBA8, GL_RGBA, GL_FLOAT, 4, 4, false, false},
    {"rgba16f", GL_RGBA16F, GL_RGBA, GL_FLOAT, 4, 8, false, false},
    {"rgba32f", GL_RGBA32F, GL_RGBA, GL_FLOAT, 4, 16, false, false},
    {"r32ui", GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1, 4, false, true},
}};

void require_size(int width, int height, const std::string& name, const FileLocation& where) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (width >= 1 && height >= 1 && width <= limit && height <= limit) return;
  const std::string what = name.empty() ? "a texture" : fmt::format("texture '{}'", name);
  fail_input(fmt::format("{} of {} x {} is not possible", what, width, height), where,
             fmt::format("this device takes 1 to {} a side", limit));
}

}  // namespace

std::span<const TextureFormat> texture_formats() {
  return kFormats;
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
                 const FileLocation& where)
    : format_(&format), width_(width), height_(height) {
  require_size(width, height, name, where);
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  handle_ = GlHandle<destroy_texture>(id);
  glTextureStorage2D(id, 1, format.internal_format, width, height);
  require_gl_memory(name.empty() ? "a texture" : fmt::format("texture '{}'", name), bytes());
}

size_t Texture::bytes() const {
  if (format_ == nullptr) return 0;
  return static_cast<size_t>(width_) * static_cast<size_t>(height_) *
         static_cast<size_t>(format_->bytes_per_texel);
}

void clear_texture(const Texture& texture, std::span<const double> value) {
  UMBRAMETER_ASSERT(!value.empty(), "{} values to clear with", value.size());
  const auto at = [&](size_t i) { return value[std::min(i, value.size() - 1)]; };
  const TextureFormat& format = texture.format();
  if (format.is_integer) {
    const auto texel = static_cast<GLuint>(at(0));
    glClearTexImage(texture.id(), 0, format.format, format.type, &texel);
    return;
  }
  const std::array<float, 4> texel = {static_cast<float>(at(0)), static_cast<float>(at(1)),
                                      static_cast<float>(at(2)), static_cast<float>(at(3))};
  glClearTexImage(texture.id(), 0, format.format, format.type, texel.data());
}

}  // namespace umbrameter
