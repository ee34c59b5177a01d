// SPDX-License-Identifier: Apache-2.0
#include "study/run_sample.h"

#include "study/study_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace umbrameter {
namespace {

constexpr const char* kForms = "give [low, high], { log = [low, high] } or { list = [...] }";

/// A parameter's values over a place in [0, 1).
struct SampleAxis {
  std::string name;
  double low = 0.0, high = 0.0;
  bool is_whole = false;
  bool is_log = false;
  std::vector<TomlNode> list;  // instead of the range
  FileLocation where;
};

bool is_number(const TomlNode& node) {
  return (node.type == TomlNode::Type::integer || node.type == TomlNode::Type::real) &&
         std::isfinite(node.real);
}

void read_ends(const TomlNode& node, SampleAxis& axis) {
  const bool is_pair = node.type == TomlNode::Type::array && node.items.size() == 2 &&
                       std::ranges::all_of(node.items, is_number);
  if (!is_pair)
    fail_input(fmt::format("the range of '{}' is not two numbers", axis.name), node.where, kForms);
  axis.low = node.items[0].real;
  axis.high = node.items[1].real;
  axis.is_whole = std::ranges::all_of(
      node.items, [](const TomlNode& item) { return item.type == TomlNode::Type::integer; });
  if (axis.low < axis.high && (!axis.is_log || axis.low > 0.0)) return;
  fail_input(fmt::format("the range of '{}' from {} to {} is empty", axis.name, axis.low, axis.high),
             node.where, axis.is_log ? "0 < low < high" : "low < high");
}

void read_list(const TomlNode& node, SampleAxis& axis) {
  const auto is_scalar = [](const TomlNode& item) {
    return item.type != TomlNode::Type::array && item.type != TomlNode::Type::table;
  };
  if (node.type != TomlNode::Type::array || node.items.empty() || !std::ranges::all_of(node.items, is_scalar))
    fail_input(fmt::format("the list of '{}' is no list of values", axis.name), node.where, kForms);
  axis.list = node.items;
}

SampleAxis read_sample_axis(const std::string& name, const TomlNode& node) {
  SampleAxis axis;
  axis.name = name;
  axis.where = node.where;
  if (node.type != TomlNode::Type::table) {
    read_ends(node, axis);
    return axis;
  }
  TomlReader reader(node, fmt::format("the sample of '{}'", name));
  axis.is_log = reader.has("log");
  if (axis.is_log == reader.has("list"))
    fail_input(fmt::format("the sample of '{}' is a table", name), node.where, kForms);
  if (axis.is_log) {
    read_ends(reader.require("log"), axis);
  } else {
    read_list(reader.require("list"), axis);
  }
  reader.finish();
  return axis;
}

/// Every whole number of a linear range has an equal share of [0, 1).
TomlNode value_at(const SampleAxis& axis, double place) {
  if (!axis.list.empty())
    return axis.list[static_cast<size_t>(place * static_cast<double>(axis.list.size()))];
  TomlNode node;
  node.where = axis.where;
  if (axis.is_whole && !axis.is_log) {
    node.real = axis.low + std::floor(place * (axis.high - axis.low + 1.0));
  } else if (axis.is_log) {
    node.real = axis.low * std::pow(axis.high / axis.low, place);
  } else {
    node.real = axis.low + place * (axis.high - axis.low);
  }
  if (axis.is_whole) node.real = std::round(node.real);
  node.type = axis.is_whole ? TomlNode::Type::integer : TomlNode::Type::real;
  if (axis.is_whole) node.integer = static_cast<int64_t>(node.real);
  return node;
}

/// In [0, 1); the standard's distributions differ between libraries.
double uniform(std::mt19937_64& random) {
  constexpr int kSpareBits = 64 - 53;  // const: a double holds 53
  return std::ldexp(static_cast<double>(random() >> kSpareBits), -53);
}

/// Which piece each point meets.
std::vector<size_t> shuffled(size_t count, std::mt19937_64& random) {
  std::vector<size_t> order(count);
  for (size_t i = 0; i < count; ++i) order[i] = i;
  for (size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<size_t>(uniform(random) * static_cast<double>(i))]);
  return order;
}

bool is_same(const SamplePoint& a, const SamplePoint& b) {
  return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
    const TomlNode &x = one.second, &y = other.second;
    return x.type == y.type && x.boolean == y.boolean && x.real == y.real && x.text == y.text;
  });
}

}  // namespace

std::vector<SamplePoint> read_samples(const TomlNode& table) {
  TomlReader reader(table, "[run.sample]");
  const int64_t count = reader.integer("count");
  if (count < 1 || count > static_cast<int64_t>(kMaxStudyRuns))
    reader.fail("count", fmt::format("'count' is {}, not in 1 to {}", count, kMaxStudyRuns));
  const int64_t seed = reader.integer("seed", 1);
  if (seed < 0) reader.fail("seed", fmt::format("'seed' is {}, not 0 or more", seed));
  std::mt19937_64 random(static_cast<uint64_t>(seed));
  std::vector<SamplePoint> points(static_cast<size_t>(count));
  for (const auto& [name, node] : table.entries) {
    if (name == "count" || name == "seed") continue;
    const SampleAxis axis = read_sample_axis(name, node);
    const std::vector<size_t> pieces = shuffled(points.size(), random);
    for (size_t i = 0; i < points.size(); ++i) {
      const double place = (static_cast<double>(pieces[i]) + uniform(random)) / static_cast<double>(count);
      points[i].emplace_back(name, value_at(axis, place));
    }
  }
  if (points.front().empty()) reader.fail("count", "the sample has no parameters", kForms);
  std::vector<SamplePoint> different;
  for (SamplePoint& point : points) {
    const bool is_new =
        std::ranges::none_of(different, [&](const SamplePoint& other) { return is_same(point, other); });
    if (is_new) different.push_back(std::move(point));
  }
  return different;
}

}  // namespace umbrameter
