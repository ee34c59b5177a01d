// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/debug_log.h"

#include "core/error.h"
#include "realtime/harness/context.h"

#include <fmt/ranges.h>

namespace umbrameter {

namespace {

constexpr size_t kMaxFailures = 8;

thread_local GlDebugLog* current_log = nullptr;

void GLAPIENTRY record_message(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length,
                               const GLchar* message, const void* user) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  auto& log = *static_cast<GlDebugLog*>(const_cast<void*>(user));
  if (log.failures.size() >= kMaxFailures) return;
  std::string text = length < 0 ? std::string(message) : std::string(message, static_cast<size_t>(length));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\0')) text.pop_back();
  log.failures.push_back(std::move(text));
}

}  // namespace

void install_debug_callback(GlDebugLog& log) {
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(record_message, &log);
}

void set_current_debug_log(GlDebugLog* log) {
  current_log = log;
}

void forget_debug_log(const GlDebugLog* log) {
  if (current_log == log) current_log = nullptr;
}

std::string gl_error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return fmt::format("GL error 0x{:x}", error);
  }
}

std::string take_gl_errors() {
  std::vector<std::string> found;
  // A lost context may report an error for ever: stop after a few.
  for (size_t i = 0; i < kMaxFailures; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    found.push_back(gl_error_name(error));
  }
  if (current_log != nullptr) {
    found.insert(found.end(), current_log->failures.begin(), current_log->failures.end());
    current_log->failures.clear();
  }
  return fmt::format("{}", fmt::join(found, "; "));
}

void require_gl_memory(std::string_view what, size_t bytes) {
  const std::string found = take_gl_errors();
  if (found.empty()) return;
  if (found.find("GL_OUT_OF_MEMORY") == std::string::npos) {
    throw Error(ErrorKind::internal, fmt::format("making {}: OpenGL reported {}", what, found));
  }
  fail_environment(fmt::format("{} of {} MiB does not fit in the device's memory", what, bytes >> 20),
                   "use a smaller map or resolution");
}

void check_gl_errors(std::string_view doing) {
  const std::string found = take_gl_errors();
  if (found.empty()) return;
  throw Error(ErrorKind::internal, fmt::format("{}: OpenGL reported {}", doing, found));
}

}  // namespace umbrameter
