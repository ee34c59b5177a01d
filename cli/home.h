// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the built-in scenes, techniques and shaders live, and how verbs find things by name.

#include "cli/verbs.h"
#include "core/parameters.h"
#include "core/progress.h"
#include "engines/host/manifest.h"
#include "lab/scene_jobs.h"
#include "realtime/manifest/technique.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace umbrameter {

struct Home {
  std::filesystem::path library;
  std::filesystem::path techniques;
  std::filesystem::path shaders;
  EnginePlaces engines;
};

/// As find_data_folder() (core/data_folder.h) says.
Home find_home();

/// The library and the assets folder; Error{input} when the assets folder does not exist.
SceneSearch scene_search(const GlobalOptions& options, const Home& home);

/// "ID[:name=value,...]" (ID may be a folder) plus further "name=value" texts. `preset=NAME` chooses a
/// preset, `preset=FILE.toml` reads one (cli/preset_file.h). Error{input} for unknown techniques, parameters, presets, and values out of range.
/// A preset file with values for single lights gives a run for each of them.
std::vector<TechniqueRun> choose_technique_runs(const std::string& text,
                                                const std::vector<std::string>& assignments,
                                                const Home& home);

/// The same where one run is wanted: of a file with values for single lights that for `light`. Error{input} when it has none.
TechniqueRun choose_technique(const std::string& text, const std::vector<std::string>& assignments,
                              const Home& home, const std::string& light = {});

/// The technique with these values; Error{input} likewise.
TechniqueRun technique_with(const std::string& id_or_path, const ParameterValues& parameters,
                            const Home& home);

/// Every built-in technique at its defaults.
std::vector<TechniqueRun> all_techniques(const Home& home);

/// A technique, or an engine with what runs need of one: title, parameters, presets, lights, hash; an id, or a folder.
Technique find_run(const std::string& id_or_path, const Home& home);

/// `cull_casters`: as in RealtimeSettings; without it no textures are kept, either.
std::unique_ptr<Renderer> open_realtime_renderer(const GlobalOptions& options, const Home& home,
                                                 bool cull_casters = true);

/// Of techniques alone, no engines: what realtime/inspect.h looks into.
std::unique_ptr<Renderer> open_gl_renderer(const GlobalOptions& options, const Home& home,
                                           bool cull_casters = true);

}  // namespace umbrameter
