// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/egl_device.h"

#include "core/error.h"

#include <array>
#include <string_view>

namespace umbrameter {

namespace {

constexpr const char* kInstallHint = "install the Debian packages libegl1 and libgl1-mesa-dri";

bool has_word(const char* words, std::string_view wanted) {
  const std::string_view all = words == nullptr ? "" : words;
  for (size_t at = all.find(wanted); at != std::string_view::npos; at = all.find(wanted, at + 1)) {
    const bool starts = at == 0 || all[at - 1] == ' ';
    const size_t end = at + wanted.size();
    if (starts && (end == all.size() || all[end] == ' ')) return true;
  }
  return false;
}

[[noreturn]] void fail_step(const EglCandidate& candidate, std::string_view step) {
  fail_environment(fmt::format("{}: {} failed (EGL error 0x{:x})", candidate.name, step, eglGetError()),
                   kInstallHint);
}

EGLDisplay open_display(const EglCandidate& candidate) {
  // The EGL 1.5 name is not resolvable through epoxy before a display is initialised; the EXT name is.
  const EGLDisplay display = eglGetPlatformDisplayEXT(candidate.platform, candidate.native, nullptr);
  if (display == EGL_NO_DISPLAY) fail_step(candidate, "eglGetPlatformDisplayEXT");
  EGLint major = 0, minor = 0;
  if (eglInitialize(display, &major, &minor) == EGL_FALSE) fail_step(candidate, "eglInitialize");
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail_step(candidate, "eglBindAPI(EGL_OPENGL_API)");
  return display;
}

EGLConfig choose_config(const EglCandidate& candidate, EGLDisplay display, bool needs_pbuffer) {
  const std::array<EGLint, 5> attributes = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                            needs_pbuffer ? EGL_PBUFFER_BIT : 0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, attributes.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
    fail_step(candidate, "eglChooseConfig for OpenGL");
  }
  return config;
}

}  // namespace

std::vector<EglCandidate> list_egl_candidates() {
  if (!epoxy_has_egl())
    fail_environment("there is no libEGL on this machine", "install the Debian package libegl1");
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<EglCandidate> candidates;
  const bool can_enumerate =
      (has_word(extensions, "EGL_EXT_device_enumeration") || has_word(extensions, "EGL_EXT_device_base")) &&
      has_word(extensions, "EGL_EXT_platform_device");
  if (can_enumerate) {
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE)
      count = 0;
    for (EGLint i = 0; i < count; ++i) {
      candidates.push_back(
          {EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(i)], fmt::format("EGL device {}", i)});
    }
  }
  if (candidates.empty() && has_word(extensions, "EGL_MESA_platform_surfaceless")) {
    candidates.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "Mesa surfaceless platform"});
  }
  if (candidates.empty()) fail_environment("EGL offers no device to draw on without a display", kInstallHint);
  return candidates;
}

EglContext::EglContext(const EglCandidate& candidate) : display_(open_display(candidate)) {
  const char* extensions = eglQueryString(display_, EGL_EXTENSIONS);
  const bool is_surfaceless = has_word(extensions, "EGL_KHR_surfaceless_context");
  const EGLConfig config = choose_config(candidate, display_, !is_surfaceless);
  const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            5,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
  if (!is_surfaceless) {
    const std::array<EGLint, 5> size = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_, config, size.data());
    if (surface_ == EGL_NO_SURFACE) fail_step(candidate, "eglCreatePbufferSurface");
  }
  context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, attributes.data());
  if (context_ == EGL_NO_CONTEXT) {
    const EGLint error = eglGetError();
    if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
    fail_environment(fmt::format("{}: no OpenGL 4.5 core context (EGL error 0x{:x})", candidate.name, error),
                     kInstallHint);
  }
}

EglContext::~EglContext() {
  if (eglGetCurrentContext() == context_) {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(display_, context_);
  if (surface_ != EGL_NO_SURFACE) eglDestroySurface(display_, surface_);
}

void EglContext::make_current() const {
  if (eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE) return;
  fail_environment(fmt::format("the OpenGL context cannot be made current (EGL error 0x{:x})", eglGetError()),
                   "is another thread still using it?");
}

CurrentEglContext::CurrentEglContext()
    : display_(eglGetCurrentDisplay()),
      context_(eglGetCurrentContext()),
      draw_surface_(eglGetCurrentSurface(EGL_DRAW)),
      read_surface_(eglGetCurrentSurface(EGL_READ)) {}

CurrentEglContext::~CurrentEglContext() {
  if (context_ != EGL_NO_CONTEXT) eglMakeCurrent(display_, draw_surface_, read_surface_, context_);
}

}  // namespace umbrameter
