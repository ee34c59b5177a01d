// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a technique says, and what it costs: a Renderer over EGL and OpenGL 4.5.

#include "core/renderer.h"
#include "scenes/light.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace umbrameter {

struct RealtimeSettings {
  std::filesystem::path techniques_folder;  // built-in technique folders
  std::filesystem::path shaders_folder;     // shaders/lib and shaders/shared
  /// Empty = the best device; an index or a part of the renderer string otherwise.
  std::string device;
  /// Keep triangles that cannot reach a map out of it; the pictures are the same without.
  bool cull_casters = true;
  /// Keep textures between untimed frames, so that passes whose inputs are the same are drawn once; the pictures are the
  /// same without.
  bool keep_textures = true;
};

/// One EGL device as seen by `umbrameter doctor`.
struct GlDevice {
  int index = 0;
  std::string renderer;  // GL_RENDERER
  std::string version;   // GL_VERSION
  bool is_hardware = false;
  std::string problem;  // why it cannot be used; empty when it can
};

/// Every EGL device; never throws for a device that does not work. Error{environment} without EGL.
std::vector<GlDevice> list_gl_devices();

/// Opens the device. Error{environment} naming the package to install when there is no usable GL 4.5.
std::unique_ptr<Renderer> make_realtime_renderer(const RealtimeSettings& settings);

}  // namespace umbrameter
