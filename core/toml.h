// SPDX-License-Identifier: Apache-2.0
#pragma once
// TOML as plain values that remember their place in the file, and a reader that rejects unknown keys.
// The only user of toml++, which is compiled once, in core/toml.cpp.

#include "core/error.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace umbrameter {

struct TomlEntry;

/// One TOML value. Arrays use `items`, tables use `entries` in file order.
struct TomlNode {
  enum class Type { boolean, integer, real, text, array, table };
  Type type = Type::table;
  bool boolean = false;
  int64_t integer = 0;
  double real = 0.0;  // also set for integers
  std::string text;
  std::vector<TomlNode> items;
  std::vector<TomlEntry> entries;
  FileLocation where;
};

struct TomlEntry {
  std::string name;
  TomlNode value;
};

/// Parses a document; Error{input} with line and column on a syntax error.
TomlNode parse_toml(std::string_view document, const std::string& file);
TomlNode parse_toml_file(const std::filesystem::path& path);

/// A word for messages: "a number", "a table", ...
std::string_view describe(TomlNode::Type type);

/// Reads one table key by key. A wrong type, a missing required key, or a number that is not finite is
/// Error{input} at its place; `finish()` makes every key that nobody asked for an error with a spelling hint.
class TomlReader {
 public:
  /// `table` must outlive the reader; `what` names it in messages ("[camera]").
  TomlReader(const TomlNode& table, std::string what);

  bool has(const std::string& key);
  /// The value, or nullptr when absent. Marks the key as known.
  const TomlNode* find(const std::string& key);
  const TomlNode& require(const std::string& key);

  std::string text(const std::string& key);
  std::string text(const std::string& key, const std::string& fallback);
  double number(const std::string& key);
  double number(const std::string& key, double fallback);
  int64_t integer(const std::string& key);
  int64_t integer(const std::string& key, int64_t fallback);
  bool boolean(const std::string& key, bool fallback);
  glm::dvec2 vec2(const std::string& key);
  glm::dvec2 vec2(const std::string& key, const glm::dvec2& fallback);
  glm::dvec3 vec3(const std::string& key);
  glm::dvec3 vec3(const std::string& key, const glm::dvec3& fallback);
  std::vector<std::string> texts(const std::string& key);
  /// The index of the text value of `key` among `choices`; anything else is an error with a hint.
  size_t choice(const std::string& key, std::span<const std::string> choices);
  size_t choice(const std::string& key, std::span<const std::string> choices, size_t fallback);
  /// `[[key]]`: its tables, none when absent.
  std::vector<const TomlNode*> tables(const std::string& key);

  /// Where `key` stands, or where the table stands when the key is absent.
  FileLocation where(const std::string& key) const;
  FileLocation where() const { return table_.where; }
  /// Throws Error{input} at `key`.
  [[noreturn]] void fail(const std::string& key, const std::string& message,
                         const std::string& hint = {}) const;
  void finish() const;

 private:
  const TomlNode* lookup(const std::string& key) const;
  const TomlNode& typed(const std::string& key, TomlNode::Type type);

  const TomlNode& table_;
  std::string what_;
  std::set<std::string> known_;
};

}  // namespace umbrameter
