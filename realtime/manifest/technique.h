// SPDX-License-Identifier: Apache-2.0
#pragma once
// A technique as its folder says: manifest + GLSL. Pure data, no GL. docs/adding-a-technique.md is the guide.

#include "core/parameters.h"
#include "scenes/light.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// An expression over parameters, light and screen constants and loop variables
/// (realtime/manifest/expression.h), kept as text with its place so that errors point into the manifest.
struct ExpressionText {
  std::string text;
  FileLocation where;
};

struct ResourceDeclaration {
  std::string name;
  std::string
      format;  // depth32f, depth24, depth16, r8, rg8, r16f, r32f, rg16f, rg32f, rgba8, rgba16f, rgba32f, r32ui
  ExpressionText width, height;
  ExpressionText levels, samples, anisotropy;  // 1 when empty
  std::string filter = "nearest";              // nearest | linear | mipmap
  std::string wrap = "border";                 // border | clamp | repeat
  std::vector<double> border{0.0};
  bool compare = false;  // depth comparison sampler (sampler2DShadow, GEQUAL: reversed depth)
  std::string condition;
  FileLocation where;
};

struct ViewDeclaration {
  std::string name;
  std::string from = "light.center";  // light.center | light.sample(<expression>)
  ExpressionText sample;              // the expression of light.sample, empty for light.center
  std::string fit = "visible";        // a name of light_fits(), or a choice parameter of such names
  std::string snap;                   // expression: not 0 moves the map in whole texels only
  std::string size;                   // expression: texels a side, for the texel size
  FileLocation where;
};

/// Fixed-function state of a pass.
struct PassState {
  std::string cull = "none";                 // none | back | front
  std::string blend = "none";                // none | add | min | max
  std::optional<std::vector<double>> clear;  // clear every written target first
  bool depth_clamp = true;
  int clip_distances = 0;  // gl_ClipDistance[0 .. n-1] that the vertex shader writes
};

struct PassDeclaration {
  std::string id;
  std::string kind;              // scene | fullscreen | mipmap | loop
  std::string view;              // scene: view to render from
  std::string vertex, fragment;  // files in the folder or in shaders/; scene passes may leave fragment empty
  std::vector<std::string> reads;   // resource names or built-ins (gbuffer.position, ...)
  std::vector<std::string> writes;  // resource names, or "visibility"
  std::vector<std::string> views;   // views whose block the shaders see
  PassState state;
  ExpressionText write_level;  // level of the written resources; 0 when empty
  bool once = false;           // drawn in the first frame of a run only: depends on parameters alone
  std::string condition;       // run only when this expression is not 0
  std::string timer;           // label that timings are summed under; the id when empty
  std::string loop_variable;
  ExpressionText loop_count;
  std::vector<PassDeclaration> body;  // loop only
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
  std::vector<std::string> constraints;
  std::vector<ViewDeclaration> views;
  std::vector<ResourceDeclaration> resources;
  std::vector<PassDeclaration> passes;
  std::vector<Preset> presets;
  std::string hash;  // of the manifest, every file in the folder, included manifests and shaders

  bool supports(LightType type) const;
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

/// The technique with every define parameter that `values` names in "stage.<parameter>" = "uniform" made a uniform: the
/// same shader with bounds known at compile time or not. Error{input} for parameters that cannot be switched.
Technique with_stages(Technique technique, const ParameterValues& values);
/// Whether `values` switch the parameter to a uniform.
bool is_switched_to_uniform(const ParameterValues& values, const std::string& parameter);

}  // namespace umbrameter
