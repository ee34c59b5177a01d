// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/context.h"

#include "core/error.h"
#include "realtime/harness/debug_log.h"
#include "realtime/harness/egl_device.h"

#include <epoxy/gl.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>

namespace umbrameter {

struct GlContext::State {
  explicit State(std::unique_ptr<EglContext> context) : egl(std::move(context)) {}
  ~State() { forget_debug_log(&log); }
  std::unique_ptr<EglContext> egl;
  GlDebugLog log;
  GlDevice device;
  GlLimits limits;
};

namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::string gl_text(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

bool is_software(const std::string& renderer) {
  constexpr std::array<std::string_view, 4> kSoftware = {"llvmpipe", "softpipe", "swrast", "swr"};
  const std::string name = lower(renderer);
  return std::any_of(kSoftware.begin(), kSoftware.end(),
                     [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

GLint gl_integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

GlLimits query_limits() {
  return {.max_texture_size = gl_integer(GL_MAX_TEXTURE_SIZE),
          .max_uniform_block_bytes = gl_integer(GL_MAX_UNIFORM_BLOCK_SIZE),
          .subpixel_bits = gl_integer(GL_SUBPIXEL_BITS)};
}

std::optional<size_t> parse_index(const std::string& text) {
  size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

struct OpenedDevice {
  std::unique_ptr<EglContext> egl;  // null when `device.problem` says why
  GlDevice device;
};

/// Leaves the opened context current.
OpenedDevice open_device(const EglCandidate& candidate, size_t index) {
  OpenedDevice opened;
  opened.device.index = static_cast<int>(index);
  try {
    opened.egl = std::make_unique<EglContext>(candidate);
    opened.egl->make_current();
  } catch (const Error& error) {
    opened.egl.reset();
    opened.device.problem = error.what();
    return opened;
  }
  opened.device.renderer = gl_text(GL_RENDERER);
  opened.device.version = gl_text(GL_VERSION);
  opened.device.is_hardware = !is_software(opened.device.renderer);
  return opened;
}

bool fits(const GlDevice& device, const std::string& wanted) {
  if (!device.problem.empty()) return false;
  if (wanted.empty() || parse_index(wanted)) return true;  // an index was chosen before opening
  return lower(device.renderer).find(lower(wanted)) != std::string::npos;
}

[[noreturn]] void fail_no_device(const std::string& wanted, const std::vector<std::string>& tried) {
  const std::string list =
      tried.empty() ? "no device of that index" : fmt::format("{}", fmt::join(tried, "; "));
  if (wanted.empty()) {
    fail_environment("no usable OpenGL 4.5 device; tried " + list,
                     "install the Debian packages libegl1 and libgl1-mesa-dri");
  }
  fail_environment(fmt::format("no usable OpenGL 4.5 device '{}'; tried {}", wanted, list),
                   "umbrameter doctor lists the devices");
}

/// The first hardware device that fits, else the first that fits.
OpenedDevice choose_device(const std::string& wanted) {
  const std::vector<EglCandidate> candidates = list_egl_candidates();
  const std::optional<size_t> wanted_index = parse_index(wanted);
  OpenedDevice best;
  std::vector<std::string> tried;
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (wanted_index && *wanted_index != i) continue;
    OpenedDevice opened = open_device(candidates[i], i);
    tried.push_back(opened.egl ? opened.device.renderer : opened.device.problem);
    if (!fits(opened.device, wanted)) continue;
    if (opened.device.is_hardware) return opened;
    if (best.egl == nullptr) best = std::move(opened);
  }
  if (best.egl == nullptr) fail_no_device(wanted, tried);
  return best;
}

}  // namespace

GlContext::GlContext(const std::string& device) {
  OpenedDevice opened = choose_device(device);
  state_ = std::make_unique<State>(std::move(opened.egl));
  state_->device = std::move(opened.device);
  make_current();
  install_debug_callback(state_->log);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  state_->limits = query_limits();
  check_gl_errors("opening the OpenGL context");
}

GlContext::~GlContext() = default;
GlContext::GlContext(GlContext&&) noexcept = default;
GlContext& GlContext::operator=(GlContext&&) noexcept = default;

void GlContext::make_current() {
  state_->egl->make_current();
  set_current_debug_log(&state_->log);
}

const GlDevice& GlContext::device() const {
  return state_->device;
}
const GlLimits& GlContext::limits() const {
  return state_->limits;
}

std::vector<GlDevice> list_gl_devices() {
  const std::vector<EglCandidate> candidates = list_egl_candidates();
  const CurrentEglContext before;
  std::vector<GlDevice> devices;
  for (size_t i = 0; i < candidates.size(); ++i) devices.push_back(open_device(candidates[i], i).device);
  return devices;
}

}  // namespace umbrameter
