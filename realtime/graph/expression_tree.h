// SPDX-License-Identifier: Apache-2.0
#pragma once
// What an expression is read into. Internal to realtime/graph.

#include "core/error.h"

#include <array>
#include <string>
#include <vector>

namespace umbrameter {

enum class Operation {
  number,
  name,
  negate,
  invert,
  add,
  subtract,
  multiply,
  divide,
  equal,
  unequal,
  less,
  less_or_equal,
  greater,
  greater_or_equal,
  conjunction,
  disjunction,
  conditional,
  minimum,
  maximum,
  power,
  ceiling,
  floor,
  logarithm,
  absolute
};

/// Nodes after those they are made of; the last one is the whole.
struct ExpressionTree {
  struct Node {
    Operation operation = Operation::number;
    size_t position = 0;  // in the text, for messages
    double number = 0.0;
    std::string name;
    std::array<size_t, 3> of{};  // operands
  };
  std::vector<Node> nodes;
};

/// Error{input} at `where`, if the expression is not one.
ExpressionTree parse_expression(const std::string& text, const FileLocation& where);

/// Error{input} that names a place in an expression's text.
[[noreturn]] void fail_in_expression(const std::string& text, size_t position, const FileLocation& where,
                                     const std::string& message, const std::string& hint = {});

}  // namespace umbrameter
