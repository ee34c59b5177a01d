// SPDX-License-Identifier: Apache-2.0
#pragma once
// What other renderers say: a Renderer whose techniques are engines' folders (engines/host/manifest.h).

#include "core/renderer.h"
#include "engines/host/manifest.h"

#include <filesystem>
#include <memory>

namespace umbrameter {

struct EngineSettings {
  EnginePlaces places;
  std::filesystem::path work_folder;  // exists; scenes, pictures and the engines' own files go below it
};

/// RenderRequest::technique is an engine's id or folder. Each adapter is started with its first request and ended with
/// the renderer. A frame has what the engine's files have: visibility, known, maybe position, normal and
/// primitive_id. Errors of an engine never end the renderer: the next request starts it anew.
std::unique_ptr<Renderer> make_engine_renderer(const EngineSettings& settings);

/// Starts the engine's adapter, or looks for the command's program, and returns what it says of itself.
struct EngineCheck {
  std::string version, device;
};
EngineCheck check_engine(const Engine& engine, const std::filesystem::path& work_folder);

}  // namespace umbrameter
