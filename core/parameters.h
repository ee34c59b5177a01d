// SPDX-License-Identifier: Apache-2.0
#pragma once
// A technique parameter is declared once, as a Parameter in its manifest. Command-line values, shader
// defines and uniforms, sweeps, docs and the report's legend all derive from that declaration.

#include "core/error.h"
#include "core/toml.h"

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace umbrameter {

enum class ParameterType { boolean, integer, real, choice };
enum class ParameterScale { linear, log, pow2 };
/// Where a value acts: a #define (recompile), a uniform, or the host (sizes, counts, state).
enum class ParameterStage { define, uniform, host };

/// A choice is its text; so is a length relative to the scene ("0.01 diagonals") until in_world() makes it a number.
using ParameterValue = std::variant<bool, int64_t, double, std::string>;
using ParameterValues = std::map<std::string, ParameterValue, std::less<>>;

struct Parameter {
  std::string name;
  ParameterType type = ParameterType::real;
  ParameterValue default_value;
  double min = 0.0;  // integer and real only; in diagonals of the scene where it is relative to that
  double max = 0.0;
  double step = 0.0;  // 0 = continuous
  ParameterScale scale = ParameterScale::linear;
  ParameterStage stage = ParameterStage::uniform;
  std::string unit;  // taps, texels, world, rad, deg, ratio, count, none
  std::string group;
  std::string doc;
  std::vector<std::string> choices;   // choice only; the shader sees the index
  bool tune = true;                   // whether a tuner may change it
  bool is_relative_to_scene = false;  // a length: its range and default follow the scene's size
  std::string
      when;  // an expression over the other parameters and light.*; where it is 0 this one acts on nothing
  FileLocation where;
};

/// Reads one `[[parameter]]` table of a manifest. Error{input} for anything inconsistent (default outside the
/// range, choice without choices, pow2 default that is none, ...). `when` is read as text and not checked.
Parameter read_parameter(const TomlNode& table);

/// Parses `text` as a value of `parameter`; Error{input} at `where` when it is not one or out of range. A length relative
/// to the scene may be a number of world units, whose range in_world() checks, or "<number> diagonals".
ParameterValue parse_parameter_value(const Parameter& parameter, std::string_view text,
                                     const FileLocation& where = {});
/// The same from a TOML value (presets, studies).
ParameterValue read_parameter_value(const Parameter& parameter, const TomlNode& node);

/// The parameter in a scene whose bounds have this diagonal: range and default of a length relative to the scene in world
/// units. Any other parameter, and one that is in world units already, as it is.
Parameter in_world(Parameter parameter, double diagonal_world);
/// `value` (of the parameter as declared) in world units; Error{input} when it is outside its range in such a scene.
ParameterValue in_world(const Parameter& parameter, const ParameterValue& value, double diagonal_world);
/// Every value of `values` that has a parameter.
ParameterValues in_world(std::span<const Parameter> parameters, ParameterValues values,
                         double diagonal_world);

/// `number`, in the parameter's own range, as one of its values: integer, real or diagonals.
ParameterValue value_of_number(const Parameter& parameter, double number);

/// Every parameter at its default.
ParameterValues default_values(std::span<const Parameter> parameters);

/// The parameter of that name; Error{input} with the nearest name otherwise.
const Parameter& find_parameter(std::span<const Parameter> parameters, std::string_view name,
                                std::string_view technique);

/// One "name=value" of the command line, split; Error{input} without '='.
std::pair<std::string, std::string> split_assignment(std::string_view assignment);

/// The value as a number: booleans 0/1, choices their index, diagonals their count.
double numeric_value(const Parameter& parameter, const ParameterValue& value);
/// The value as written in a command line, a table or a file.
std::string to_text(const ParameterValue& value);

std::string_view to_text(ParameterType type);
std::string_view to_text(ParameterScale scale);
std::string_view to_text(ParameterStage stage);

}  // namespace umbrameter
