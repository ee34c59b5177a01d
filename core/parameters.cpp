// SPDX-License-Identifier: Apache-2.0
#include "core/parameters.h"

#include "core/names.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace umbrameter {

namespace {

const std::array<std::string, 4> kTypes = {"boolean", "integer", "real", "choice"};
const std::array<std::string, 3> kScales = {"linear", "log", "pow2"};
const std::array<std::string, 3> kStages = {"define", "uniform", "host"};
const std::array<std::string, 2> kRelations = {"nothing", "scene"};
constexpr std::string_view kDiagonals = " diagonals";

bool is_number(const Parameter& parameter) {
  return parameter.type == ParameterType::integer || parameter.type == ParameterType::real;
}

bool is_power_of_two(double value) {
  return value >= 1 && std::exp2(std::round(std::log2(value))) == value;
}

template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "<number> diagonals".
std::optional<double> parse_diagonals(std::string_view text) {
  if (!text.ends_with(kDiagonals)) return std::nullopt;
  return parse_number<double>(text.substr(0, text.size() - kDiagonals.size()));
}

/// World units of a length relative to the scene: what can be said of them before the scene is known.
void require_possible(const Parameter& parameter, double number, const FileLocation& where) {
  const bool has_possible_sign =
      (number >= 0.0 || parameter.min < 0.0) && (number <= 0.0 || parameter.max > 0.0);
  if (std::isfinite(number) && has_possible_sign) return;
  fail_input(fmt::format("parameter '{}' = {} is outside its range [{}, {}] diagonals of the scene",
                         parameter.name, number, parameter.min, parameter.max),
             where);
}

/// Error{input} unless `value` may be given to `parameter`.
void require_allowed(const Parameter& parameter, const ParameterValue& value, const FileLocation& where) {
  if (parameter.type == ParameterType::choice) {
    const std::string& text = std::get<std::string>(value);
    if (std::ranges::find(parameter.choices, text) != parameter.choices.end()) return;
    fail_input(fmt::format("'{}' is not a choice of parameter '{}'", text, parameter.name), where,
               suggest_name(text, parameter.choices));
  }
  if (!is_number(parameter)) return;
  const double number = numeric_value(parameter, value);
  if (parameter.is_relative_to_scene && std::holds_alternative<double>(value))
    return require_possible(parameter, number, where);
  if (!std::isfinite(number) || number < parameter.min || number > parameter.max) {
    fail_input(fmt::format("parameter '{}' = {} is outside its range [{}, {}]", parameter.name,
                           to_text(value), parameter.min, parameter.max),
               where);
  }
  if (parameter.scale == ParameterScale::pow2 && !is_power_of_two(number)) {
    fail_input(fmt::format("parameter '{}' = {} is not a power of two", parameter.name, to_text(value)),
               where);
  }
}

std::string_view expected_word(const Parameter& parameter) {
  if (parameter.is_relative_to_scene) return "a number of world units or \"<number> diagonals\"";
  switch (parameter.type) {
    case ParameterType::boolean:
      return "true or false";
    case ParameterType::integer:
      return "an integer";
    case ParameterType::real:
      return "a number";
    case ParameterType::choice:
      return "one of its choices";
  }
  return "a value";
}

[[noreturn]] void fail_type(const Parameter& parameter, std::string_view given, const FileLocation& where) {
  fail_input(
      fmt::format("parameter '{}' wants {}, not '{}'", parameter.name, expected_word(parameter), given),
      where);
}

void check_range(const Parameter& parameter, TomlReader& reader) {
  if (!(parameter.min <= parameter.max)) {
    reader.fail("min", fmt::format("parameter '{}': min {} is above max {}", parameter.name, parameter.min,
                                   parameter.max));
  }
  if (parameter.scale == ParameterScale::log && parameter.min <= 0.0) {
    reader.fail("min", fmt::format("parameter '{}': a log scale needs min > 0", parameter.name));
  }
  if (parameter.step < 0.0)
    reader.fail("step", fmt::format("parameter '{}': step is negative", parameter.name));
}

/// The default of a length relative to the scene stands as a number of diagonals, like its range.
ParameterValue read_default(const Parameter& parameter, TomlReader& reader) {
  if (!parameter.is_relative_to_scene) return read_parameter_value(parameter, reader.require("default"));
  const ParameterValue value = value_of_number(parameter, reader.number("default"));
  require_allowed(parameter, value, reader.where("default"));
  return value;
}

void check_relation(const Parameter& parameter, TomlReader& reader) {
  if (!parameter.is_relative_to_scene) return;
  if (parameter.type == ParameterType::real && parameter.unit == "world") return;
  reader.fail("relative_to", fmt::format("parameter '{}' cannot follow the scene's size", parameter.name),
              "only type = \"real\" with unit = \"world\" can");
}

}  // namespace

Parameter read_parameter(const TomlNode& table) {
  TomlReader reader(table, "[[parameter]]");
  Parameter parameter;
  parameter.where = table.where;
  parameter.name = reader.text("name");
  parameter.type = static_cast<ParameterType>(reader.choice("type", kTypes));
  parameter.scale = static_cast<ParameterScale>(reader.choice("scale", kScales, 0));
  parameter.stage = static_cast<ParameterStage>(reader.choice("stage", kStages));
  parameter.unit = reader.text("unit", "none");
  parameter.group = reader.text("group", "");
  parameter.doc = reader.text("doc");
  parameter.tune = reader.boolean("tune", true);
  parameter.is_relative_to_scene = reader.choice("relative_to", kRelations, 0) == 1;
  parameter.when = reader.text("when", "");
  check_relation(parameter, reader);
  if (is_number(parameter)) {
    parameter.min = reader.number("min");
    parameter.max = reader.number("max");
    parameter.step = reader.number("step", 0.0);
    check_range(parameter, reader);
  }
  if (parameter.type == ParameterType::choice) parameter.choices = reader.texts("choices");
  parameter.default_value = read_default(parameter, reader);
  reader.finish();
  return parameter;
}

ParameterValue parse_parameter_value(const Parameter& parameter, std::string_view text,
                                     const FileLocation& where) {
  ParameterValue value;
  switch (parameter.type) {
    case ParameterType::boolean:
      if (text != "true" && text != "false") fail_type(parameter, text, where);
      value = text == "true";
      break;
    case ParameterType::integer: {
      const auto number = parse_number<int64_t>(text);
      if (!number) fail_type(parameter, text, where);
      value = *number;
      break;
    }
    case ParameterType::real: {
      if (parameter.is_relative_to_scene && parse_diagonals(text)) {
        value = std::string(text);
        break;
      }
      const auto number = parse_number<double>(text);
      if (!number) fail_type(parameter, text, where);
      value = *number;
      break;
    }
    case ParameterType::choice:
      value = std::string(text);
      break;
  }
  require_allowed(parameter, value, where);
  return value;
}

ParameterValue read_parameter_value(const Parameter& parameter, const TomlNode& node) {
  using Type = TomlNode::Type;
  ParameterValue value;
  if (parameter.type == ParameterType::boolean && node.type == Type::boolean) {
    value = node.boolean;
  } else if (parameter.type == ParameterType::integer && node.type == Type::integer) {
    value = node.integer;
  } else if (parameter.type == ParameterType::real &&
             (node.type == Type::real || node.type == Type::integer)) {
    value = node.real;
  } else if (node.type == Type::text && (parameter.type == ParameterType::choice ||
                                         (parameter.is_relative_to_scene && parse_diagonals(node.text)))) {
    value = node.text;
  } else {
    fail_type(parameter, describe(node.type), node.where);
  }
  require_allowed(parameter, value, node.where);
  return value;
}

ParameterValue value_of_number(const Parameter& parameter, double number) {
  if (parameter.type == ParameterType::integer) return static_cast<int64_t>(number);
  if (parameter.is_relative_to_scene) return fmt::format("{}{}", number, kDiagonals);
  return number;
}

ParameterValues default_values(std::span<const Parameter> parameters) {
  ParameterValues values;
  for (const Parameter& parameter : parameters) values[parameter.name] = parameter.default_value;
  return values;
}

const Parameter& find_parameter(std::span<const Parameter> parameters, std::string_view name,
                                std::string_view technique) {
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  if (found != parameters.end()) return *found;
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  fail_input(fmt::format("technique '{}' has no parameter '{}'", technique, name), {},
             suggest_name(name, names));
}

std::pair<std::string, std::string> split_assignment(std::string_view assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    fail_input(fmt::format("'{}' is not of the form name=value", assignment));
  }
  return {std::string(assignment.substr(0, equals)), std::string(assignment.substr(equals + 1))};
}

double numeric_value(const Parameter& parameter, const ParameterValue& value) {
  if (const bool* boolean = std::get_if<bool>(&value)) return *boolean ? 1.0 : 0.0;
  if (const int64_t* integer = std::get_if<int64_t>(&value)) return static_cast<double>(*integer);
  if (const double* real = std::get_if<double>(&value)) return *real;
  if (const auto diagonals = parse_diagonals(std::get<std::string>(value));
      diagonals && parameter.is_relative_to_scene)
    return *diagonals;
  const auto found = std::ranges::find(parameter.choices, std::get<std::string>(value));
  UMBRAMETER_ASSERT(found != parameter.choices.end(), "choice '{}' of '{}'", std::get<std::string>(value),
                    parameter.name);
  return static_cast<double>(found - parameter.choices.begin());
}

std::string to_text(const ParameterValue& value) {
  if (const bool* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
  if (const int64_t* integer = std::get_if<int64_t>(&value)) return fmt::format("{}", *integer);
  if (const double* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  return std::get<std::string>(value);
}

std::string_view to_text(ParameterType type) {
  return kTypes[static_cast<size_t>(type)];
}

std::string_view to_text(ParameterScale scale) {
  return kScales[static_cast<size_t>(scale)];
}

std::string_view to_text(ParameterStage stage) {
  return kStages[static_cast<size_t>(stage)];
}

}  // namespace umbrameter
