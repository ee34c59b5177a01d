// SPDX-License-Identifier: Apache-2.0
#include "core/toml.h"

#include "core/files.h"
#include "core/names.h"

#define TOML_EXCEPTIONS 1
// toml++ 3.3 asserts on some malformed input ("[!]") before it would report the error; the report is what we
// want.
#define TOML_ASSERT(condition) static_assert(true)
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

namespace umbrameter {

namespace {

TomlNode convert(const toml::node& node, const std::string& file) {
  TomlNode result;
  const toml::source_position place = node.source().begin;
  result.where = {file, static_cast<int>(place.line), static_cast<int>(place.column)};
  if (const auto* boolean = node.as_boolean()) {
    result.type = TomlNode::Type::boolean;
    result.boolean = boolean->get();
  } else if (const auto* integer = node.as_integer()) {
    result.type = TomlNode::Type::integer;
    result.integer = integer->get();
    result.real = static_cast<double>(integer->get());
  } else if (const auto* real = node.as_floating_point()) {
    result.type = TomlNode::Type::real;
    result.real = real->get();
  } else if (const auto* text = node.as_string()) {
    result.type = TomlNode::Type::text;
    result.text = text->get();
  } else if (const auto* array = node.as_array()) {
    result.type = TomlNode::Type::array;
    for (const toml::node& item : *array) result.items.push_back(convert(item, file));
  } else if (const auto* table = node.as_table()) {
    result.type = TomlNode::Type::table;
    for (const auto& [key, value] : *table)
      result.entries.push_back({std::string(key.str()), convert(value, file)});
    // toml++ sorts keys; the file's order is what presets and docs want.
    std::ranges::stable_sort(result.entries, [](const auto& a, const auto& b) {
      return std::pair(a.value.where.line, a.value.where.column) <
             std::pair(b.value.where.line, b.value.where.column);
    });
  } else {
    fail_input("dates and times are not used here", result.where);
  }
  return result;
}

/// The end of the string that opens at `i`, one past its quotes; the document's without one.
size_t skip_string(std::string_view document, size_t i) {
  const char quote = document[i];
  const std::string triple(3, quote);
  const bool is_long = document.substr(i, 3) == triple;
  for (size_t k = i + (is_long ? 3 : 1); k < document.size(); ++k) {
    if (quote == '"' && document[k] == '\\') {
      ++k;
      continue;
    }
    if (is_long ? document.substr(k, 3) == triple : document[k] == quote) return k + (is_long ? 3 : 1);
    if (!is_long && document[k] == '\n') return k;
  }
  return document.size();
}

// TOML has other letters in strings and comments only. Elsewhere toml++ 3.3 runs into code that it calls unreachable.
void check_plain_ascii(std::string_view document, const std::string& file) {
  for (size_t i = document.starts_with("\xEF\xBB\xBF") ? 3 : 0; i < document.size();) {
    const char c = document[i];
    if (c == '"' || c == '\'') {
      i = skip_string(document, i);
    } else if (c == '#') {
      i = std::min(document.find('\n', i), document.size());
    } else if (static_cast<unsigned char>(c) < 0x80) {
      ++i;
    } else {
      const std::string_view before = document.substr(0, i);
      const size_t start_of_line = before.rfind('\n') + 1;  // npos + 1 = 0
      fail_input("a letter outside ASCII that stands in no string",
                 {file, static_cast<int>(std::ranges::count(before, '\n')) + 1,
                  static_cast<int>(i - start_of_line) + 1},
                 "put it in quotes");
    }
  }
}

}  // namespace

TomlNode parse_toml(std::string_view document, const std::string& file) {
  check_plain_ascii(document, file);
  try {
    return convert(toml::parse(document), file);
  } catch (const toml::parse_error& error) {
    const toml::source_position place = error.source().begin;
    fail_input(std::string(error.description()),
               {file, static_cast<int>(place.line), static_cast<int>(place.column)});
  }
}

TomlNode parse_toml_file(const std::filesystem::path& path) {
  return parse_toml(read_file(path), path.string());
}

std::string_view describe(TomlNode::Type type) {
  switch (type) {
    case TomlNode::Type::boolean:
      return "true/false";
    case TomlNode::Type::integer:
      return "an integer";
    case TomlNode::Type::real:
      return "a number";
    case TomlNode::Type::text:
      return "a text";
    case TomlNode::Type::array:
      return "an array";
    case TomlNode::Type::table:
      return "a table";
  }
  return "a value";
}

TomlReader::TomlReader(const TomlNode& table, std::string what) : table_(table), what_(std::move(what)) {
  if (table.type == TomlNode::Type::table) return;
  fail_input(fmt::format("{} must be a table, not {}", what_, describe(table.type)), table.where);
}

const TomlNode* TomlReader::lookup(const std::string& key) const {
  for (const auto& [name, value] : table_.entries) {
    if (name == key) return &value;
  }
  return nullptr;
}

bool TomlReader::has(const std::string& key) {
  return find(key) != nullptr;
}

const TomlNode* TomlReader::find(const std::string& key) {
  known_.insert(key);
  return lookup(key);
}

const TomlNode& TomlReader::require(const std::string& key) {
  const TomlNode* node = find(key);
  if (node != nullptr) return *node;
  // A misspelt key is reported as such, not as a missing one.
  for (const auto& [name, value] : table_.entries) {
    if (known_.contains(name) || nearest_name(name, std::span(&key, 1)).empty()) continue;
    fail_input(fmt::format("{} has no key '{}', found '{}'", what_, key, name), value.where,
               fmt::format("did you mean '{}'?", key));
  }
  fail_input(fmt::format("{} needs the key '{}'", what_, key), table_.where);
}

const TomlNode& TomlReader::typed(const std::string& key, TomlNode::Type type) {
  const TomlNode& node = require(key);
  const bool integer_as_real = type == TomlNode::Type::real && node.type == TomlNode::Type::integer;
  if (node.type != type && !integer_as_real) {
    fail(key, fmt::format("'{}' must be {}, not {}", key, describe(type), describe(node.type)));
  }
  if (type == TomlNode::Type::real && !std::isfinite(node.real)) {
    fail(key, fmt::format("'{}' is {}, which is not a finite number", key, node.real));
  }
  return node;
}

std::string TomlReader::text(const std::string& key) {
  return typed(key, TomlNode::Type::text).text;
}

std::string TomlReader::text(const std::string& key, const std::string& fallback) {
  return has(key) ? text(key) : fallback;
}

double TomlReader::number(const std::string& key) {
  return typed(key, TomlNode::Type::real).real;
}

double TomlReader::number(const std::string& key, double fallback) {
  return has(key) ? number(key) : fallback;
}

int64_t TomlReader::integer(const std::string& key) {
  return typed(key, TomlNode::Type::integer).integer;
}

int64_t TomlReader::integer(const std::string& key, int64_t fallback) {
  return has(key) ? integer(key) : fallback;
}

bool TomlReader::boolean(const std::string& key, bool fallback) {
  return has(key) ? typed(key, TomlNode::Type::boolean).boolean : fallback;
}

namespace {

template <int N>
glm::vec<N, double> read_vector(const TomlReader& reader, const std::string& key, const TomlNode& node) {
  if (node.items.size() != N) {
    reader.fail(key, fmt::format("'{}' must hold {} numbers, not {}", key, N, node.items.size()));
  }
  glm::vec<N, double> result;
  for (int i = 0; i < N; ++i) {
    const TomlNode& item = node.items[static_cast<size_t>(i)];
    const bool number = item.type == TomlNode::Type::real || item.type == TomlNode::Type::integer;
    if (!number)
      fail_input(fmt::format("'{}' must hold numbers, not {}", key, describe(item.type)), item.where);
    if (!std::isfinite(item.real)) {
      fail_input(fmt::format("'{}' holds {}, which is not a finite number", key, item.real), item.where);
    }
    result[i] = item.real;
  }
  return result;
}

}  // namespace

glm::dvec2 TomlReader::vec2(const std::string& key) {
  return read_vector<2>(*this, key, typed(key, TomlNode::Type::array));
}

glm::dvec2 TomlReader::vec2(const std::string& key, const glm::dvec2& fallback) {
  return has(key) ? vec2(key) : fallback;
}

glm::dvec3 TomlReader::vec3(const std::string& key) {
  return read_vector<3>(*this, key, typed(key, TomlNode::Type::array));
}

glm::dvec3 TomlReader::vec3(const std::string& key, const glm::dvec3& fallback) {
  return has(key) ? vec3(key) : fallback;
}

std::vector<std::string> TomlReader::texts(const std::string& key) {
  std::vector<std::string> result;
  if (!has(key)) return result;
  for (const TomlNode& item : typed(key, TomlNode::Type::array).items) {
    if (item.type != TomlNode::Type::text) {
      fail_input(fmt::format("'{}' must hold texts, not {}", key, describe(item.type)), item.where);
    }
    result.push_back(item.text);
  }
  return result;
}

size_t TomlReader::choice(const std::string& key, std::span<const std::string> choices) {
  const std::string value = text(key);
  const auto found = std::ranges::find(choices, value);
  if (found == choices.end()) {
    fail(key, fmt::format("'{}' = '{}' is not known here", key, value), suggest_name(value, choices));
  }
  return static_cast<size_t>(found - choices.begin());
}

size_t TomlReader::choice(const std::string& key, std::span<const std::string> choices, size_t fallback) {
  return has(key) ? choice(key, choices) : fallback;
}

std::vector<const TomlNode*> TomlReader::tables(const std::string& key) {
  std::vector<const TomlNode*> result;
  if (!has(key)) return result;
  for (const TomlNode& item : typed(key, TomlNode::Type::array).items) {
    if (item.type != TomlNode::Type::table) {
      fail(key, fmt::format("'{}' must be written as [[{}]] tables", key, key));
    }
    result.push_back(&item);
  }
  return result;
}

FileLocation TomlReader::where(const std::string& key) const {
  const TomlNode* node = lookup(key);
  return node != nullptr ? node->where : table_.where;
}

void TomlReader::fail(const std::string& key, const std::string& message, const std::string& hint) const {
  fail_input(fmt::format("{}: {}", what_, message), where(key), hint);
}

void TomlReader::finish() const {
  const std::vector<std::string> known(known_.begin(), known_.end());
  for (const auto& [name, value] : table_.entries) {
    if (known_.contains(name)) continue;
    fail_input(fmt::format("{} has an unknown key '{}'", what_, name), value.where,
               suggest_name(name, known));
  }
}

}  // namespace umbrameter
