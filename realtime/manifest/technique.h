// SPDX-License-Identifier: Apache-2.0
#pragma once
// A technique as its folder says: manifest + GLSL. Pure data, no GL. docs/adding-a-technique.md is the guide.

#include "core/parameters.h"
#include "realtime/graph/buffer.h"
#include "realtime/graph/pass.h"
#include "realtime/graph/resource.h"
#include "realtime/graph/view.h"
#include "scenes/light.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// `[[value]]`: a number that expressions may use by its name.
struct ValueDeclaration {
  std::string name;
  Expression value;
  FileLocation where;
};

struct Preset {
  std::string name;
  std::string doc;
  ParameterValues values;
  FileLocation where;
};

struct Technique {
  std::string id;
  std::string title;
  std::string summary;
  std::string family;
  std::vector<std::string> references;
  std::vector<std::string> known_failures;
  std::vector<LightType> lights;  // supported
  std::filesystem::path folder;
  std::vector<Parameter> parameters;  // those of the included files, then own ones
  std::vector<Expression> constraints;
  Expression compares_per_pixel;         // see below; empty: not told
  std::vector<ValueDeclaration> values;  // each may use those before it
  /// Frames drawn before the one that counts, of a technique that reads what earlier frames left; empty: it reads none.
  Expression frames_before;
  std::vector<ViewDeclaration> views;
  std::vector<ResourceDeclaration> resources;
  std::vector<BufferDeclaration> buffers;
  std::vector<PassDeclaration> passes;
  std::vector<Preset> presets;
  std::string hash;  // of the manifest, every file in the folder, included manifests and shaders

  bool supports(LightType type) const;
  bool has_history() const { return !frames_before.is_empty(); }
};

/// Loads `folder`/technique.toml. `shared_folder` holds what manifests include (`<name>.toml`),
/// `shaders_folder` the shader library (empty: ../../shaders beside `shared_folder`, as in realtime/).
/// Error{input} with file, line and hint for unknown keys, unread parameters, inputs nobody wrote, bad
/// expressions, missing shader files.
Technique load_technique(const std::filesystem::path& folder, const std::filesystem::path& shared_folder,
                         const std::filesystem::path& shaders_folder = {});

/// Every technique folder directly under `techniques_folder`, by id; its folder `shared` is none.
std::vector<Technique> list_techniques(const std::filesystem::path& techniques_folder,
                                       const std::filesystem::path& shaders_folder = {});

/// An id under `techniques_folder`, or a path to a folder; Error{input} with the nearest id otherwise.
Technique find_technique(const std::string& id_or_path, const std::filesystem::path& techniques_folder,
                         const std::filesystem::path& shaders_folder = {});

/// Defaults, then the preset named by the pseudo-parameter "preset" if given, then `overrides`; checks names,
/// ranges and constraints. The pseudo-parameters "stage.<parameter>" stay in the result.
ParameterValues resolve_parameters(const Technique& technique, const ParameterValues& overrides);

/// How often a pixel compares its receiver with what it reads of the light's maps, at most: search and filter together, a
/// sampler's comparison, blend or gather once. Means over pixels where not all of them do. Absent when the manifest does
/// not tell.
std::optional<double> compares_per_pixel(const Technique& technique, const ParameterValues& values);

/// The technique with every define parameter that `values` names in "stage.<parameter>" = "uniform" made a uniform: the
/// same shader with bounds known at compile time or not. Error{input} for parameters that cannot be switched.
Technique with_stages(Technique technique, const ParameterValues& values);
/// Whether `values` switch the parameter to a uniform.
bool is_switched_to_uniform(const ParameterValues& values, const std::string& parameter);

}  // namespace umbrameter
