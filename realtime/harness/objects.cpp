// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/objects.h"

#include "realtime/harness/debug_log.h"

#include <vector>

namespace umbrameter {

void destroy_texture(GLuint id) {
  glDeleteTextures(1, &id);
}
void destroy_framebuffer(GLuint id) {
  glDeleteFramebuffers(1, &id);
}
void destroy_buffer(GLuint id) {
  glDeleteBuffers(1, &id);
}
void destroy_sampler(GLuint id) {
  glDeleteSamplers(1, &id);
}
void destroy_vertex_array(GLuint id) {
  glDeleteVertexArrays(1, &id);
}
void destroy_query(GLuint id) {
  glDeleteQueries(1, &id);
}
void destroy_program(GLuint id) {
  glDeleteProgram(id);
}

namespace {

GLint wrap_mode(TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::border:
      return GL_CLAMP_TO_BORDER;
    case TextureWrap::clamp:
      return GL_CLAMP_TO_EDGE;
    case TextureWrap::repeat:
      return GL_REPEAT;
  }
  return GL_NONE;
}

void attach(GLuint framebuffer, GLenum attachment, const Texture& texture, int level, int layer) {
  if (texture.kind() == TextureKind::flat) {
    glNamedFramebufferTexture(framebuffer, attachment, texture.id(), level);
  } else {
    glNamedFramebufferTextureLayer(framebuffer, attachment, texture.id(), level, layer);
  }
}

struct Filters {
  GLint minified, magnified;
};

Filters filters(TextureFilter filter) {
  switch (filter) {
    case TextureFilter::nearest:
      return {GL_NEAREST, GL_NEAREST};
    case TextureFilter::linear:
      return {GL_LINEAR, GL_LINEAR};
    case TextureFilter::mipmap:
      return {GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR};
  }
  return {};
}

}  // namespace

Buffer::Buffer(size_t bytes, const void* data, bool is_updatable) : bytes_(bytes) {
  UMBRAMETER_ASSERT(bytes > 0, "a buffer of {} bytes", bytes);
  GLuint id = 0;
  glCreateBuffers(1, &id);
  handle_ = GlHandle<destroy_buffer>(id);
  const std::vector<char> zeros(data == nullptr ? bytes : 0);
  glNamedBufferStorage(id, static_cast<GLsizeiptr>(bytes), data == nullptr ? zeros.data() : data,
                       is_updatable ? GL_DYNAMIC_STORAGE_BIT : 0);
  require_gl_memory("a buffer", bytes);
}

void Buffer::update(const void* data, size_t bytes, size_t offset) {
  UMBRAMETER_ASSERT(offset + bytes <= bytes_, "{} bytes at {} of {}", bytes, offset, bytes_);
  glNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void bind_uniform_buffer(GLuint binding, const Buffer& buffer) {
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.id());
}

void bind_storage_buffer(GLuint binding, const Buffer& buffer) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.id());
}

Sampler::Sampler(const SamplerSettings& settings) : settings_(settings) {
  GLuint id = 0;
  glCreateSamplers(1, &id);
  handle_ = GlHandle<destroy_sampler>(id);
  const auto set = [id](GLenum name, GLint value) { glSamplerParameteri(id, name, value); };
  set(GL_TEXTURE_MIN_FILTER, filters(settings.filter).minified);
  set(GL_TEXTURE_MAG_FILTER, filters(settings.filter).magnified);
  set(GL_TEXTURE_WRAP_S, wrap_mode(settings.wrap));
  set(GL_TEXTURE_WRAP_T, wrap_mode(settings.wrap));
  set(GL_TEXTURE_WRAP_R, wrap_mode(settings.wrap));
  glSamplerParameterfv(id, GL_TEXTURE_BORDER_COLOR, &settings.border.x);
  if (settings.anisotropy > 1.0)
    glSamplerParameterf(id, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(settings.anisotropy));
  if (!settings.compare) return;
  set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  set(GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
}

void bind_texture(GLuint unit, const Texture& texture, const Sampler& sampler) {
  glBindTextureUnit(unit, texture.id());
  glBindSampler(unit, sampler.id());
}

Framebuffer::Framebuffer(std::span<const Texture* const> colors, const Texture* depth, int level, int layer) {
  UMBRAMETER_ASSERT(!colors.empty() || depth != nullptr, "{} attachments", colors.size());
  const Texture& first = colors.empty() ? *depth : *colors.front();
  width_ = level_side(first.width(), level);
  height_ = level_side(first.height(), level);
  GLuint id = 0;
  glCreateFramebuffers(1, &id);
  handle_ = GlHandle<destroy_framebuffer>(id);
  std::vector<GLenum> draw_buffers;
  for (const Texture* color : colors) {
    UMBRAMETER_ASSERT(color->width() == first.width() && color->height() == first.height(),
                      "{}x{} beside {}x{}", color->width(), color->height(), first.width(), first.height());
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(draw_buffers.size());
    attach(id, attachment, *color, level, layer);
    draw_buffers.push_back(attachment);
  }
  if (draw_buffers.empty()) {
    glNamedFramebufferDrawBuffer(id, GL_NONE);
  } else {
    glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(draw_buffers.size()), draw_buffers.data());
  }
  if (depth != nullptr) {
    const GLenum point = has_stencil(depth->format()) ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
    attach(id, point, *depth, level, layer);
  }
  const GLenum status = glCheckNamedFramebufferStatus(id, GL_DRAW_FRAMEBUFFER);
  UMBRAMETER_ASSERT(status == GL_FRAMEBUFFER_COMPLETE, "framebuffer status 0x{:x}", status);
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, id());
  glViewport(0, 0, width_, height_);
}

void label_object(GLenum kind, GLuint id, std::string_view name) {
  constexpr size_t kMostBytes = 255;  // the least that GL_MAX_LABEL_LENGTH may be is 256, with the end
  const std::string_view shown = name.substr(0, kMostBytes);
  if (!shown.empty()) glObjectLabel(kind, id, static_cast<GLsizei>(shown.size()), shown.data());
}

VertexArray make_empty_vertex_array() {
  GLuint id = 0;
  glCreateVertexArrays(1, &id);
  return VertexArray(id);
}

Query make_query(GLenum target) {
  GLuint id = 0;
  glCreateQueries(target, 1, &id);
  return Query(id);
}

}  // namespace umbrameter
