// SPDX-License-Identifier: Apache-2.0
#pragma once
// GL objects as move-only values (direct state access). A context must be current whenever one is made or
// dies.

#include "core/error.h"
#include "realtime/graph/texture.h"

#include <epoxy/gl.h>
#include <glm/vec4.hpp>

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace umbrameter {

/// A GL name with its deleter; 0 = empty.
template <void (*destroy)(GLuint)>
class GlHandle {
 public:
  GlHandle() = default;
  explicit GlHandle(GLuint id) : id_(id) {}
  ~GlHandle() { reset(); }
  GlHandle(GlHandle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    if (this == &other) return *this;
    reset();
    id_ = std::exchange(other.id_, 0);
    return *this;
  }
  GLuint id() const { return id_; }

 private:
  void reset() {
    if (id_ != 0) destroy(id_);
    id_ = 0;
  }
  GLuint id_ = 0;
};

void destroy_texture(GLuint id);
void destroy_framebuffer(GLuint id);
void destroy_buffer(GLuint id);
void destroy_sampler(GLuint id);
void destroy_vertex_array(GLuint id);
void destroy_query(GLuint id);
void destroy_program(GLuint id);

/// One row of the format table: the names manifests use.
struct TextureFormat {
  std::string_view name;
  GLenum internal_format;
  GLenum format;  // of one texel on the CPU side
  GLenum type;
  int components;
  int bytes_per_texel;  // on the GPU
  bool is_depth;
  bool is_integer;
};

std::span<const TextureFormat> texture_formats();
/// Whether a depth format holds a stencil too.
bool has_stencil(const TextureFormat& format);
/// Error{input} at `where` with a spelling hint when there is no such format.
const TextureFormat& find_texture_format(std::string_view name, const FileLocation& where = {});

/// What a texture may have beyond its size.
struct TextureShape {
  int levels = 1;
  int samples = 1;  // above 1: multisampled, not to be read by shaders
  TextureKind kind = TextureKind::flat;
  int layers = 1;  // of an array; 6 of a cube
};

/// A texture, contents undefined until written.
class Texture {
 public:
  Texture() = default;
  /// Error{input} at `where`, naming `name`, when a side is below 1 or above GL_MAX_TEXTURE_SIZE;
  /// Error{environment} when the GPU is out of memory.
  Texture(const TextureFormat& format, int width, int height, const std::string& name = {},
          const FileLocation& where = {}, const TextureShape& shape = {});
  /// As the constructor, but without memory: what it is may be asked, and nothing else before allocated().
  static Texture declared(const TextureFormat& format, int width, int height, const std::string& name,
                          const FileLocation& where, const TextureShape& shape);
  /// One like this, with memory.
  Texture allocated(const std::string& name) const;
  /// One level of `texture`, all its layers, as a texture of its own; shares its memory and must not outlive it.
  static Texture view_of_level(const Texture& texture, int level);

  GLuint id() const { return handle_.id(); }
  const TextureFormat& format() const { return *format_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int levels() const { return shape_.levels; }
  int samples() const { return shape_.samples; }
  TextureKind kind() const { return shape_.kind; }
  int layers() const { return shape_.layers; }
  /// Of all levels, layers and samples.
  size_t bytes() const;

 private:
  GlHandle<destroy_texture> handle_;
  const TextureFormat* format_ = nullptr;
  int width_ = 0;
  int height_ = 0;
  TextureShape shape_;
};

/// A side of level `level` of a texture whose level 0 has `side` texels.
int level_side(int side, int level);
/// Levels of a full chain down to one texel.
int full_chain_levels(int width, int height);

/// Sets every texel of a level, all its layers; values beyond `value.size()` repeat its last one.
void clear_level(const Texture& texture, int level, std::span<const double> value);
/// The same of all levels.
void clear_texture(const Texture& texture, std::span<const double> value);

struct SamplerSettings {
  TextureFilter filter = TextureFilter::nearest;
  double anisotropy = 1.0;  // samples along the longer axis, at most
  TextureWrap wrap = TextureWrap::border;
  glm::vec4 border{0.0f};
  bool compare = false;  // GL_GEQUAL: receiver depth >= stored depth (reversed) gives 1
};

class Sampler {
 public:
  Sampler() = default;
  explicit Sampler(const SamplerSettings& settings);
  GLuint id() const { return handle_.id(); }
  const SamplerSettings& settings() const { return settings_; }

 private:
  GlHandle<destroy_sampler> handle_;
  SamplerSettings settings_;
};

/// Binds texture and sampler to a unit.
void bind_texture(GLuint unit, const Texture& texture, const Sampler& sampler);

class Buffer {
 public:
  Buffer() = default;
  /// Immutable storage of `bytes` >= 1, zeroed when `data` is null; `update` needs `is_updatable`.
  Buffer(size_t bytes, const void* data, bool is_updatable = false);
  template <class T>
  static Buffer of(std::span<const T> items) {
    return Buffer(items.size_bytes(), items.data());
  }

  void update(const void* data, size_t bytes, size_t offset = 0);
  GLuint id() const { return handle_.id(); }
  size_t bytes() const { return bytes_; }

 private:
  GlHandle<destroy_buffer> handle_;
  size_t bytes_ = 0;
};

void bind_uniform_buffer(GLuint binding, const Buffer& buffer);
void bind_storage_buffer(GLuint binding, const Buffer& buffer);

class Framebuffer {
 public:
  Framebuffer() = default;
  /// Colour attachment k = colors[k]; `depth` may be null. All of one size. Error{internal} when incomplete.
  /// Draws into `level` of each, and `layer` of those that have layers.
  Framebuffer(std::span<const Texture* const> colors, const Texture* depth, int level = 0, int layer = 0);
  /// Binds it for drawing and sets the viewport to its size.
  void bind() const;
  GLuint id() const { return handle_.id(); }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  GlHandle<destroy_framebuffer> handle_;
  int width_ = 0;
  int height_ = 0;
};

using VertexArray = GlHandle<destroy_vertex_array>;
using Query = GlHandle<destroy_query>;

/// A vertex array without attributes, for shaders that pull or make up their vertices.
/// What graphics debuggers show an object as; GL cuts long names.
void label_object(GLenum kind, GLuint id, std::string_view name);

VertexArray make_empty_vertex_array();
Query make_query(GLenum target);

}  // namespace umbrameter
