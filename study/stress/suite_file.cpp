// SPDX-License-Identifier: Apache-2.0
#include "study/stress/suite_file.h"

#include "core/toml.h"
#include "study/stress/axes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace umbrameter {
namespace {

constexpr int64_t kSuiteSchema = 1;

int count(TomlReader& reader, const std::string& key, int fallback, int most) {
  const int64_t value = reader.integer(key, fallback);
  if (value < 1 || value > most)
    reader.fail(key, fmt::format("'{}' is {}, not between 1 and {}", key, value, most));
  return static_cast<int>(value);
}

std::vector<StressValue> read_values(TomlReader& reader) {
  const TomlNode& node = reader.require("values");
  if (node.type != TomlNode::Type::array || node.items.empty())
    reader.fail("values", "'values' is no list of numbers or words");
  std::vector<StressValue> values;
  for (const TomlNode& item : node.items) {
    switch (item.type) {
      case TomlNode::Type::text:
        values.push_back({item.text, 0.0});
        break;
      case TomlNode::Type::integer:
      case TomlNode::Type::real:
        values.push_back(numbers({item.real}).front());
        break;
      default:
        fail_input(fmt::format("'values' holds {}", describe(item.type)), item.where, "numbers or words");
    }
  }
  return values;
}

std::vector<std::string> texts_of(const std::vector<StressValue>& values) {
  std::vector<std::string> texts;
  for (const StressValue& value : values) texts.push_back(value.text);
  return texts;
}

/// The axis with these values, which must hold the nominal one; words must be its own.
void choose_values(TomlReader& reader, StressAxis& axis) {
  const std::vector<StressValue> chosen = read_values(reader);
  const std::vector<std::string> known = texts_of(axis.values), texts = texts_of(chosen);
  const bool has_words =
      std::ranges::all_of(axis.values, [](const StressValue& value) { return value.number == 0.0; });
  for (const std::string& text : texts) {
    if (has_words && std::ranges::find(known, text) == known.end())
      reader.fail("values", fmt::format("axis '{}' has no value '{}'", axis.name, text),
                  fmt::format("it has {}", fmt::join(known, ", ")));
  }
  const auto nominal = std::ranges::find(texts, known[axis.nominal]);
  if (nominal == texts.end())
    reader.fail("values", fmt::format("'values' lack {}", known[axis.nominal]),
                "it is the nominal one, which the others are judged by");
  axis.nominal = static_cast<size_t>(nominal - texts.begin());
  axis.values = chosen;
}

StressAxis read_axis(const TomlNode& table) {
  TomlReader reader(table, "[[axis]]");
  if (reader.has("parameter") == reader.has("name"))
    reader.fail("name", "an axis needs either 'name' or 'parameter'",
                "parameter = \"bias_world\" walks any parameter of techniques");
  if (reader.has("parameter")) {
    StressAxis axis = parameter_axis(reader.text("parameter"), read_values(reader));
    reader.finish();
    return axis;
  }
  StressAxis axis;
  const std::string name = reader.text("name");
  try {
    axis = find_stress_axis(name);
  } catch (const Error& error) {
    reader.fail("name", error.what());
  }
  if (reader.has("values")) choose_values(reader, axis);
  reader.finish();
  return axis;
}

StressPlan read_suite(const TomlNode& root) {
  TomlReader reader(root, "the suite");
  StressPlan plan;
  if (const int64_t schema = reader.integer("schema"); schema != kSuiteSchema)
    reader.fail("schema", fmt::format("'schema' is {}, not {}", schema, kSuiteSchema));
  plan.title = reader.text("title", "");
  plan.picture.width_px = count(reader, "width_px", plan.picture.width_px, 16384);
  plan.picture.height_px = count(reader, "height_px", plan.picture.height_px, 16384);
  plan.picture.samples_per_pixel =
      count(reader, "samples_per_pixel", plan.picture.samples_per_pixel, 1 << 20);
  plan.picture.seed = static_cast<uint64_t>(count(reader, "seed", 1, 1 << 30));
  plan.timeout_s = count(reader, "timeout_s", plan.timeout_s, 86400);
  if (reader.has("techniques")) plan.techniques = reader.texts("techniques");
  for (const TomlNode* table : reader.tables("axis")) plan.axes.push_back(read_axis(*table));
  if (plan.axes.empty()) plan.axes = stress_axes();
  reader.finish();
  return plan;
}

}  // namespace

StressPlan parse_stress_suite(std::string_view document, const std::string& file) {
  return read_suite(parse_toml(document, file));
}

StressPlan load_stress_suite(const std::filesystem::path& path) {
  return read_suite(parse_toml_file(path));
}

StressPlan full_stress_plan() {
  StressPlan plan;
  plan.title = "Every axis";
  plan.axes = stress_axes();
  return plan;
}

}  // namespace umbrameter
