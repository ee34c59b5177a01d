// SPDX-License-Identifier: Apache-2.0
#include "realtime/graph/expression.h"

#include "core/names.h"
#include "realtime/graph/expression_tree.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

using Node = ExpressionTree::Node;

class Evaluator {
 public:
  Evaluator(const ExpressionTree& tree, const ExpressionVariables& variables, const std::string& text,
            const FileLocation& where)
      : tree_(tree), variables_(variables), text_(text), where_(where) {}

  double value_of(size_t index) const {
    const Node& node = tree_.nodes[index];
    const double value = compute(node);
    if (!std::isfinite(value)) fail(node, "the result is not finite");
    return value;
  }

 private:
  [[noreturn]] void fail(const Node& node, const std::string& message, const std::string& hint = {}) const {
    fail_in_expression(text_, node.position, where_, message, hint);
  }

  double compute(const Node& node) const {
    const auto of = [&](size_t k) { return value_of(node.of[k]); };
    switch (node.operation) {
      case Operation::number:
        return node.number;
      case Operation::name:
        return variable(node);
      case Operation::negate:
        return -of(0);
      case Operation::invert:
        return of(0) == 0.0;
      case Operation::add:
        return of(0) + of(1);
      case Operation::subtract:
        return of(0) - of(1);
      case Operation::multiply:
        return of(0) * of(1);
      case Operation::divide:
        return quotient(node, of(0), of(1));
      case Operation::equal:
        return of(0) == of(1);
      case Operation::unequal:
        return of(0) != of(1);
      case Operation::less:
        return of(0) < of(1);
      case Operation::less_or_equal:
        return of(0) <= of(1);
      case Operation::greater:
        return of(0) > of(1);
      case Operation::greater_or_equal:
        return of(0) >= of(1);
      case Operation::conjunction:
        return of(0) != 0.0 && of(1) != 0.0;
      case Operation::disjunction:
        return of(0) != 0.0 || of(1) != 0.0;
      case Operation::conditional:
        return of(0) != 0.0 ? of(1) : of(2);
      case Operation::minimum:
        return std::min(of(0), of(1));
      case Operation::maximum:
        return std::max(of(0), of(1));
      case Operation::power:
        return std::pow(of(0), of(1));
      case Operation::ceiling:
        return std::ceil(of(0));
      case Operation::floor:
        return std::floor(of(0));
      case Operation::logarithm:
        return std::log2(of(0));
      case Operation::absolute:
        return std::abs(of(0));
    }
    return 0.0;
  }

  double quotient(const Node& node, double dividend, double divisor) const {
    if (divisor == 0.0) fail(node, "division by zero");
    return dividend / divisor;
  }

  double variable(const Node& node) const {
    const auto found = variables_.find(node.name);
    if (found != variables_.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [name, value] : variables_) known.push_back(name);
    fail(node, fmt::format("unknown name '{}'", node.name), suggest_name(node.name, known));
  }

  const ExpressionTree& tree_;
  const ExpressionVariables& variables_;
  const std::string& text_;
  const FileLocation& where_;
};

}  // namespace

Expression::Expression(std::string_view text, const FileLocation& where) : text_(text), where_(where) {
  tree_ = std::make_shared<const ExpressionTree>(parse_expression(text_, where_));
  for (const Node& node : tree_->nodes) {
    if (node.operation == Operation::name) names_.insert(node.name);
  }
}

double Expression::evaluate(const ExpressionVariables& variables) const {
  UMBRAMETER_ASSERT(tree_ != nullptr, "{} expression", "no");
  return Evaluator(*tree_, variables, text_, where_).value_of(tree_->nodes.size() - 1);
}

}  // namespace umbrameter
