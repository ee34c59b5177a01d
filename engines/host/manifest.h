// SPDX-License-Identifier: Apache-2.0
#pragma once
// A foreign renderer as its folder says: engine.toml beside its adapter. docs/engines.md is the guide.

#include "core/parameters.h"
#include "scenes/light.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbrameter {

/// adapter: one process, a request a line. command: one process a picture. pictures: finished files.
enum class EngineForm : uint8_t { adapter, command, pictures };
/// What the pictures claim (docs/your-engine.md): a factor of N.L, or the light itself, integrated.
enum class EngineQuantity : uint8_t { visibility, irradiance };
std::string_view to_text(EngineForm form);
std::string_view to_text(EngineQuantity quantity);

struct EngineLimits {
  double start_s = 60.0;                      // until an adapter says that it is ready
  double picture_s = 120.0;                   // for one request
  uint64_t memory_bytes = uint64_t{8} << 30;  // resident, of the whole process group
};

struct EnginePreset {
  std::string name;
  std::string doc;
  ParameterValues values;
};

struct Engine {
  std::string id;
  std::string title;
  std::string summary;
  std::vector<std::string> references;
  std::vector<std::string> known_failures;  // what its lights and shadows cannot express
  std::filesystem::path folder;             // absolute
  EngineForm form = EngineForm::adapter;
  EngineQuantity quantity = EngineQuantity::visibility;
  std::vector<std::string> command;  // adapter, command: arguments with placeholders
  /// pictures: what to read, with placeholders, relative to `folder`. "picture", or "lit" and "unlit"; maybe "surfaces".
  std::map<std::string, std::string> files;
  std::map<LightType, std::string> lights;  // supported, and what becomes of each
  std::vector<Parameter> parameters;
  std::vector<EnginePreset> presets;
  std::vector<std::filesystem::path> missing;  // what it needs and this machine lacks
  EngineLimits limits;
  std::string hash;  // of the manifest, its folder, and what it depends on

  bool supports(LightType type) const { return lights.contains(type); }
};

/// Where engines are looked for, and where scripts/install_engines.sh put what they need.
struct EnginePlaces {
  std::filesystem::path engines;    // folders with an engine.toml
  std::filesystem::path installed;  // {installed} in manifests
};

/// Loads `folder`/engine.toml. Error{input} with file, line and hint for unknown keys, placeholders and parameters.
Engine load_engine(const std::filesystem::path& folder, const EnginePlaces& places);

/// Every engine folder directly under `places.engines`, by id.
std::vector<Engine> list_engines(const EnginePlaces& places);

/// The folder of an id under `places.engines`, or of a path to a folder with an engine.toml; empty when there is none.
std::filesystem::path find_engine_folder(const std::string& id_or_path, const EnginePlaces& places);

/// A finished picture as a run: the path of an EXR, HDR or PFM file, in which {name} stands for the scene's name.
bool is_picture_path(const std::string& text);

/// Whether find_engine() has an answer, without reading anything.
bool names_engine(const std::string& text, const EnginePlaces& places);

/// The engine of an id, of a folder, or of finished pictures; absent when `text` names none.
std::optional<Engine> find_engine(const std::string& text, const EnginePlaces& places);

/// Error{environment} naming what is missing and how to install it.
void require_installed(const Engine& engine);

}  // namespace umbrameter
