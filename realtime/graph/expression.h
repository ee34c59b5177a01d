// SPDX-License-Identifier: Apache-2.0
#pragma once
// The small arithmetic of manifests: numbers, names, + - * /, comparisons, && || !, ?:, and
// min max ceil floor log2 pow abs. Nothing else.

#include "core/error.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

namespace umbrameter {

using ExpressionVariables = std::map<std::string, double, std::less<>>;

struct ExpressionTree;  // realtime/graph/expression.cpp

/// An expression of a manifest with its place, read once. A name may contain dots (light.width, screen.height).
class Expression {
 public:
  /// No expression: a key that was left out.
  Expression() = default;
  /// Error{input} at `where` for a syntax error.
  explicit Expression(std::string_view text, const FileLocation& where = {});

  bool is_empty() const { return tree_ == nullptr; }
  const std::string& text() const { return text_; }
  const FileLocation& where() const { return where_; }
  /// Every name in it.
  const std::set<std::string>& names() const { return names_; }
  /// Error{input} for an unknown name (with the nearest known one), division by zero or a result that is not finite.
  /// The branch that is not taken (?:, &&, ||) is not evaluated. Must not be empty.
  double evaluate(const ExpressionVariables& variables) const;

 private:
  std::string text_;
  FileLocation where_;
  std::set<std::string> names_;
  std::shared_ptr<const ExpressionTree> tree_;  // shared by copies
};

}  // namespace umbrameter
