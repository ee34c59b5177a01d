// SPDX-License-Identifier: Apache-2.0
#pragma once
// An OpenGL 4.5 core context without a display or a window. GL is called from one thread at a time: the one
// that last called make_current().

#include "realtime/realtime.h"

#include <memory>
#include <string>
#include <string_view>

namespace umbrameter {

struct GlLimits {
  int max_texture_size = 0;
  int max_uniform_block_bytes = 0;
  int subpixel_bits = 0;  // vertices snap to 1 / 2^bits px
};

/// Owns the EGL display, context and (if the driver needs one) a 1x1 pbuffer. Created current, with KHR_debug
/// on and glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE).
class GlContext {
 public:
  /// `device`: empty = the best (hardware first), an index of list_gl_devices(), or a part of the renderer
  /// string, ignoring case. Error{environment} when none fits, naming the devices that were tried.
  explicit GlContext(const std::string& device = {});
  ~GlContext();
  GlContext(GlContext&&) noexcept;
  GlContext& operator=(GlContext&&) noexcept;

  /// Binds the context to the calling thread.
  void make_current();
  const GlDevice& device() const;
  const GlLimits& limits() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Throws Error{internal} with the driver's words if GL reported an error or a high-severity message since
/// the last call. `doing` names the batch in the message ("pass 'blocker_search'").
void check_gl_errors(std::string_view doing);

}  // namespace umbrameter
