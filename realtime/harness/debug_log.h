// SPDX-License-Identifier: Apache-2.0
#pragma once
// What KHR_debug reported, kept until somebody asks. Callbacks must not throw, so they record.

#include <epoxy/gl.h>

#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

struct GlDebugLog {
  std::vector<std::string> failures;  // errors and high-severity messages, the first few
};

/// Reports into `log` from now on, in the current context.
void install_debug_callback(GlDebugLog& log);

/// The log check_gl_errors() looks at on this thread; null = glGetError only.
void set_current_debug_log(GlDebugLog* log);
/// The same with null, if `log` is the one being looked at.
void forget_debug_log(const GlDebugLog* log);

/// Everything reported since the last call, joined by "; "; empty when nothing was.
std::string take_gl_errors();

/// Error{environment} when the allocation just made ran out of memory; `what` names it.
void require_gl_memory(std::string_view what, size_t bytes);

/// GL_INVALID_ENUM -> "GL_INVALID_ENUM".
std::string gl_error_name(GLenum error);

}  // namespace umbrameter
