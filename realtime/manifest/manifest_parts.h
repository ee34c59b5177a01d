// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pieces of a manifest that several of its tables are made of. Private to realtime/manifest.

#include "core/toml.h"
#include "realtime/manifest/read_manifest.h"

#include <array>
#include <string>
#include <vector>

namespace umbrameter {

using Names = std::vector<std::string>;

/// A name that becomes an identifier in GLSL.
std::string read_name(TomlReader& reader, const std::string& key);

/// Error{input} unless `expression` uses names of `scope` only; notes the names as used.
void check_expression(Manifest& manifest, const Expression& expression, const Names& scope);

/// An expression, or a plain integer; empty when absent.
Expression read_expression(Manifest& manifest, TomlReader& reader, const std::string& key,
                           const Names& scope);
Expression require_expression(Manifest& manifest, TomlReader& reader, const std::string& key,
                              const Names& scope);

/// As many of them as a list has.
std::vector<Expression> read_expressions(Manifest& manifest, TomlReader& reader, const std::string& key,
                                         const Names& scope);

/// Two of them, written as a list.
std::array<Expression, 2> read_expression_pair(Manifest& manifest, TomlReader& reader, const std::string& key,
                                               const Names& scope);

/// The enumerator that `key` names, the first one when it is absent.
template <class Enum, size_t n>
Enum read_enum(TomlReader& reader, const std::string& key, const std::array<std::string, n>& names) {
  return static_cast<Enum>(reader.choice(key, names, 0));
}

/// One to four finite numbers.
std::vector<double> read_numbers(TomlReader& reader, const std::string& key);

// The tables. `scope` holds the names that expressions may use.
/// Whether a [[resource]] is a buffer; the kinds of textures are read_resource()'s.
bool is_buffer(const TomlNode& table);
BufferDeclaration read_buffer(Manifest& manifest, const TomlNode& table, const Names& scope);
ResourceDeclaration read_resource(Manifest& manifest, const TomlNode& table, const Names& scope);
/// `family_scope`: those of a family of views, which belongs to no loop.
ViewDeclaration read_view(Manifest& manifest, const TomlNode& table, const Names& scope,
                          const Names& family_scope);
PassDeclaration read_pass(Manifest& manifest, const TomlNode& table, const Names& scope, int loop_depth);

/// Of a pass that draws; `is_scene`: triangles, which offsets move.
PassState read_state(Manifest& manifest, TomlReader& reader, bool is_scene, const Names& scope);

/// The variables of all loops, and their counts.
void collect_loop_variables(const std::vector<PassDeclaration>& passes, Names& names);

}  // namespace umbrameter
