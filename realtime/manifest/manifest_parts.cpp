// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/manifest_parts.h"

#include "core/names.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace umbrameter {
namespace {

/// Words that GLSL keeps for itself and a person might choose.
const std::set<std::string, std::less<>> kReservedWords = {
    "active", "buffer",  "common",    "const",   "discard", "filter", "fixed",     "flat",
    "float",  "frame",   "half",      "in",      "input",   "int",    "invariant", "main",
    "out",    "output",  "partition", "patch",   "precise", "sample", "shared",    "smooth",
    "switch", "texture", "uniform",   "varying", "void",    "preset"};

bool is_identifier(std::string_view name) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && std::ranges::all_of(name, allowed) && (name[0] < '0' || name[0] > '9') &&
         name.find("__") == std::string_view::npos && !name.starts_with("gl_");
}

}  // namespace

std::string read_name(TomlReader& reader, const std::string& key) {
  const std::string name = reader.text(key);
  if (!is_identifier(name)) {
    reader.fail(key, fmt::format("'{}' cannot be a name here", name),
                "lower-case letters, digits and single underscores");
  }
  if (kReservedWords.contains(name)) reader.fail(key, fmt::format("'{}' is a reserved word", name));
  return name;
}

void check_expression(Manifest& manifest, const Expression& expression, const Names& scope) {
  for (const std::string& name : expression.names()) {
    if (std::ranges::find(scope, name) == scope.end()) {
      fail_input(fmt::format("unknown name '{}' in expression '{}'", name, expression.text()),
                 expression.where(), suggest_name(name, scope));
    }
    manifest.expression_names.insert(name);
  }
}

namespace {

Expression expression_of(Manifest& manifest, const TomlNode& node, const std::string& key,
                         const Names& scope) {
  const bool is_integer = node.type == TomlNode::Type::integer;
  if (!is_integer && node.type != TomlNode::Type::text) {
    fail_input(fmt::format("'{}' must be an expression or an integer, not {}", key, describe(node.type)),
               node.where);
  }
  Expression expression(is_integer ? fmt::format("{}", node.integer) : node.text, node.where);
  check_expression(manifest, expression, scope);
  return expression;
}

}  // namespace

Expression read_expression(Manifest& manifest, TomlReader& reader, const std::string& key,
                           const Names& scope) {
  const TomlNode* node = reader.find(key);
  return node == nullptr ? Expression() : expression_of(manifest, *node, key, scope);
}

std::vector<Expression> read_expressions(Manifest& manifest, TomlReader& reader, const std::string& key,
                                         const Names& scope) {
  const TomlNode& list = reader.require(key);
  if (list.type != TomlNode::Type::array)
    reader.fail(key, fmt::format("'{}' must be a list of expressions", key));
  std::vector<Expression> expressions;
  for (const TomlNode& item : list.items) expressions.push_back(expression_of(manifest, item, key, scope));
  return expressions;
}

std::array<Expression, 2> read_expression_pair(Manifest& manifest, TomlReader& reader, const std::string& key,
                                               const Names& scope) {
  const std::vector<Expression> both = read_expressions(manifest, reader, key, scope);
  if (both.size() != 2) reader.fail(key, fmt::format("'{}' must be a list of two expressions", key));
  return {both.at(0), both.at(1)};
}

Expression require_expression(Manifest& manifest, TomlReader& reader, const std::string& key,
                              const Names& scope) {
  reader.require(key);
  return read_expression(manifest, reader, key, scope);
}

std::vector<double> read_numbers(TomlReader& reader, const std::string& key) {
  const TomlNode& node = reader.require(key);
  std::vector<double> numbers;
  for (const TomlNode& item : node.items) {
    const bool is_number = item.type == TomlNode::Type::real || item.type == TomlNode::Type::integer;
    if (!is_number || !(std::abs(item.real) < 1e30))
      reader.fail(key, fmt::format("'{}' must hold finite numbers", key));
    numbers.push_back(item.real);
  }
  if (numbers.empty() || numbers.size() > 4)
    reader.fail(key, fmt::format("'{}' must hold 1 to 4 numbers", key));
  return numbers;
}

}  // namespace umbrameter
