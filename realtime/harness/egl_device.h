// SPDX-License-Identifier: Apache-2.0
#pragma once
// EGL displays that need no window system, and contexts on them. Private to context.cpp and its tests.

#include "realtime/realtime.h"

#include <epoxy/egl.h>

#include <memory>
#include <string>
#include <vector>

namespace umbrameter {

/// A place a context may be opened on: an EGL device, or Mesa's surfaceless platform.
struct EglCandidate {
  EGLenum platform = 0;
  void* native = nullptr;  // EGLDeviceEXT, or EGL_DEFAULT_DISPLAY
  std::string name;        // for messages
};

/// Devices in EGL's order, then the surfaceless platform when there are no devices. Error{environment} naming
/// the package when there is no libEGL or it offers neither.
std::vector<EglCandidate> list_egl_candidates();

/// A GL 4.5 core context. The display is never terminated: other contexts of the process may live on it.
class EglContext {
 public:
  /// Error{environment} saying which step failed.
  explicit EglContext(const EglCandidate& candidate);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() const;

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;  // only where surfaceless contexts are missing
};

/// Remembers what is current on this thread and binds it again when it goes out of scope.
class CurrentEglContext {
 public:
  CurrentEglContext();
  ~CurrentEglContext();
  CurrentEglContext(const CurrentEglContext&) = delete;
  CurrentEglContext& operator=(const CurrentEglContext&) = delete;

 private:
  EGLDisplay display_;
  EGLContext context_;
  EGLSurface draw_surface_;
  EGLSurface read_surface_;
};

}  // namespace umbrameter
