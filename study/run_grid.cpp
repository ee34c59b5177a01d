// SPDX-License-Identifier: Apache-2.0
#include "study/run_grid.h"

#include "core/names.h"
#include "study/run_sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace umbrameter {
namespace {

constexpr std::string_view kStage = "stage";

/// One parameter with the values it takes in turn.
struct GridAxis {
  std::string name;
  std::vector<TomlNode> values;
  bool is_list = false;
};

std::string text_of(const TomlNode& value) {
  switch (value.type) {
    case TomlNode::Type::boolean:
      return value.boolean ? "true" : "false";
    case TomlNode::Type::integer:
      return std::to_string(value.integer);
    case TomlNode::Type::real:
      return fmt::format("{:g}", value.real);
    default:
      return value.text;
  }
}

void require_scalar(const TomlNode& value, const std::string& name) {
  if (value.type != TomlNode::Type::array && value.type != TomlNode::Type::table) return;
  fail_input(fmt::format("a value of '{}' is {}", name, describe(value.type)), value.where,
             "give a number, a text, true or false");
}

/// A whole number stays one where both ends are whole.
TomlNode number_node(double value, bool ends_are_whole, const FileLocation& where) {
  constexpr double kRounding = 1e-9;
  TomlNode node;
  node.where = where;
  const double rounded = std::round(value);
  const bool is_whole = ends_are_whole && std::abs(value - rounded) <= kRounding * std::max(1.0, rounded);
  node.type = is_whole ? TomlNode::Type::integer : TomlNode::Type::real;
  node.real = is_whole ? rounded : value;
  node.integer = is_whole ? static_cast<int64_t>(rounded) : 0;
  return node;
}

struct Progression {
  double from = 0.0, to = 0.0, third = 0.0;
  bool ends_are_whole = false;
};

Progression read_progression(TomlReader& reader, const std::string& key, const std::string& meaning) {
  const TomlNode& node = reader.require(key);
  const auto is_number = [](const TomlNode& item) {
    return (item.type == TomlNode::Type::integer || item.type == TomlNode::Type::real) &&
           std::isfinite(item.real);
  };
  const bool is_triple = node.type == TomlNode::Type::array && node.items.size() == 3 &&
                         std::ranges::all_of(node.items, is_number);
  if (!is_triple) reader.fail(key, fmt::format("'{}' is not three numbers", key), meaning);
  const bool whole =
      node.items[0].type == TomlNode::Type::integer && node.items[1].type == TomlNode::Type::integer;
  return {node.items[0].real, node.items[1].real, node.items[2].real, whole};
}

std::vector<TomlNode> read_range(TomlReader& reader) {
  const Progression range = read_progression(reader, "range", "[from, to, step]");
  const FileLocation where = reader.where("range");
  if (!(range.third > 0.0) || range.to < range.from)
    reader.fail("range",
                fmt::format("a range from {} to {} by {} has no values", range.from, range.to, range.third),
                "[from, to, step] with from <= to and a positive step");
  constexpr double kRounding = 1e-9;  // so that 0 to 0.3 by 0.1 has its end
  const double steps = std::floor((range.to - range.from) / range.third + kRounding);
  if (steps >= static_cast<double>(kMaxStudyRuns))
    reader.fail("range", fmt::format("a range of {} values is longer than {}", steps + 1.0, kMaxStudyRuns));
  const bool is_whole = range.ends_are_whole && range.third == std::floor(range.third);
  std::vector<TomlNode> values;
  for (int i = 0; i <= static_cast<int>(steps); ++i)
    values.push_back(number_node(range.from + i * range.third, is_whole, where));
  return values;
}

std::vector<TomlNode> read_log(TomlReader& reader) {
  const Progression log = read_progression(reader, "log", "[from, to, count]");
  const FileLocation where = reader.where("log");
  const bool is_count = log.third == std::floor(log.third) && log.third >= 2.0 &&
                        log.third <= static_cast<double>(kMaxStudyRuns);
  if (!(log.from > 0.0) || log.to <= log.from || !is_count)
    reader.fail("log",
                fmt::format("{} values from {} to {} are no logarithmic steps", log.third, log.from, log.to),
                "[from, to, count] with 0 < from < to and a count of 2 or more");
  const int last = static_cast<int>(log.third) - 1;
  std::vector<TomlNode> values;
  for (int i = 0; i <= last; ++i) {
    const double value =
        i == last ? log.to : log.from * std::pow(log.to / log.from, static_cast<double>(i) / last);
    values.push_back(number_node(value, log.ends_are_whole, where));
  }
  return values;
}

GridAxis read_grid_axis(const std::string& name, const TomlNode& node) {
  if (node.type == TomlNode::Type::array) {
    if (node.items.empty()) fail_input(fmt::format("the list of '{}' is empty", name), node.where);
    for (const TomlNode& item : node.items) require_scalar(item, name);
    return {name, node.items, true};
  }
  if (node.type != TomlNode::Type::table) return {name, {node}, false};
  TomlReader reader(node, fmt::format("the values of '{}'", name));
  const bool is_range = reader.has("range");
  if (is_range == reader.has("log"))
    fail_input(fmt::format("the values of '{}' are a table", name), node.where,
               "give { range = [from, to, step] } or { log = [from, to, count] }");
  const std::vector<TomlNode> values = is_range ? read_range(reader) : read_log(reader);
  reader.finish();
  return {name, values, true};
}

/// TOML reads stage.taps = "uniform" as a table in a table.
std::vector<GridAxis> read_axes(const TomlNode& table) {
  std::vector<GridAxis> axes;
  for (const auto& [name, node] : table.entries) {
    if (name != kStage || node.type != TomlNode::Type::table) {
      axes.push_back(read_grid_axis(name, node));
      continue;
    }
    for (const auto& [parameter, stage] : node.entries)
      axes.push_back(read_grid_axis(fmt::format("{}.{}", kStage, parameter), stage));
  }
  return axes;
}

/// Replaces "{name}"; returns the names it found.
std::vector<std::string> fill_label(std::string& label, const StudyRun& run) {
  std::vector<std::string> named;
  std::vector<std::string> known;
  for (const auto& [name, value] : run.values) known.push_back(name);
  size_t from = 0;
  while ((from = label.find('{', from)) != std::string::npos) {
    const size_t to = label.find('}', from);
    if (to == std::string::npos) fail_input(fmt::format("the label '{}' has no '}}'", label), run.where);
    const std::string name = label.substr(from + 1, to - from - 1);
    const auto found = std::ranges::find(run.values, name, &std::pair<std::string, TomlNode>::first);
    if (found == run.values.end())
      fail_input(fmt::format("the label '{}' names '{}', which is not among the run's values", label, name),
                 run.where, suggest_name(name, known));
    const std::string text = text_of(found->second);
    label.replace(from, to - from + 1, text);
    from += text.size();
    named.push_back(name);
  }
  return named;
}

/// Samples run fastest.
StudyRun point(const StudyRun& run, const std::vector<GridAxis>& axes,
               const std::vector<SamplePoint>& samples, size_t index) {
  StudyRun chosen = run;
  const SamplePoint& sample = samples[index % samples.size()];
  index /= samples.size();
  std::vector<size_t> places(axes.size());
  for (size_t k = axes.size(); k-- > 0;) {
    places[k] = index % axes[k].values.size();
    index /= axes[k].values.size();
  }
  for (size_t k = 0; k < axes.size(); ++k)
    chosen.values.emplace_back(axes[k].name, axes[k].values[places[k]]);
  chosen.values.insert(chosen.values.end(), sample.begin(), sample.end());
  const std::vector<std::string> named = fill_label(chosen.label, chosen);
  for (size_t k = 0; k < chosen.values.size(); ++k) {
    const auto& [name, value] = chosen.values[k];
    const bool varies = k >= axes.size() || axes[k].is_list;
    if (varies && std::ranges::find(named, name) == named.end())
      chosen.label += fmt::format(" {}={}", name, text_of(value));
  }
  return chosen;
}

/// One empty point without `[run.sample]`.
std::vector<SamplePoint> read_sample_table(TomlReader& reader, const std::vector<GridAxis>& axes) {
  const TomlNode* table = reader.find("sample");
  if (table == nullptr) return {SamplePoint{}};
  if (table->type != TomlNode::Type::table)
    reader.fail("sample", fmt::format("'sample' is {}, not a table", describe(table->type)));
  std::vector<SamplePoint> samples = read_samples(*table);
  for (const auto& [name, value] : samples.front()) {
    if (std::ranges::find(axes, name, &GridAxis::name) != axes.end())
      fail_input(fmt::format("'{}' is among the values and among the samples", name), value.where);
  }
  return samples;
}

}  // namespace

std::vector<StudyRun> expand_run(const TomlNode& table) {
  TomlReader reader(table, "[[run]]");
  StudyRun run;
  run.where = table.where;
  run.is_picture = reader.has("picture");
  if (run.is_picture && (reader.has("technique") || reader.has("values") || reader.has("preset")))
    reader.fail("picture", "a finished picture has no technique, preset and values");
  run.technique = reader.text(run.is_picture ? "picture" : "technique");
  run.label = reader.text("label", run.technique);
  run.preset = reader.text("preset", "");
  if (run.label.empty()) reader.fail("label", "the label is empty");
  std::vector<GridAxis> axes;
  if (const TomlNode* values = reader.find("values")) {
    if (values->type != TomlNode::Type::table)
      reader.fail("values", fmt::format("'values' is {}, not a table", describe(values->type)));
    axes = read_axes(*values);
  }
  const std::vector<SamplePoint> samples = read_sample_table(reader, axes);
  reader.finish();
  size_t count = samples.size();
  for (const GridAxis& axis : axes) {
    count *= axis.values.size();
    if (count > kMaxStudyRuns)
      fail_input(fmt::format("the grid of run '{}' has more than {} points", run.label, kMaxStudyRuns),
                 run.where);
  }
  std::vector<StudyRun> runs;
  for (size_t i = 0; i < count; ++i) runs.push_back(point(run, axes, samples, i));
  return runs;
}

}  // namespace umbrameter
