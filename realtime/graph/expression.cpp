// SPDX-License-Identifier: Apache-2.0
#include "realtime/graph/expression.h"

#include "core/names.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

constexpr int kMaxDepth = 64;       // nesting a person would write; keeps hostile input off the stack
constexpr size_t kMaxNodes = 1000;  // the same: a long chain is a deep tree

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

struct Function {
  std::string_view name;
  Operation operation;
  size_t arguments;
};

constexpr std::array<Function, 7> kFunctions = {{{"abs", Operation::absolute, 1},
                                                 {"ceil", Operation::ceiling, 1},
                                                 {"floor", Operation::floor, 1},
                                                 {"log2", Operation::logarithm, 1},
                                                 {"max", Operation::maximum, 2},
                                                 {"min", Operation::minimum, 2},
                                                 {"pow", Operation::power, 2}}};

bool is_name_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

[[noreturn]] void fail_at(const std::string& text, size_t position, const FileLocation& where,
                          const std::string& message, const std::string& hint = {}) {
  fail_input(fmt::format("{} in expression '{}', character {}", message, text, position + 1), where, hint);
}

}  // namespace

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

namespace {

using Node = ExpressionTree::Node;

/// Recursive descent, one function a precedence level.
class Parser {
 public:
  Parser(const std::string& text, const FileLocation& where) : text_(text), where_(where) {}

  ExpressionTree parse() {
    conditional();
    if (peek() != '\0') fail(fmt::format("unexpected '{}'", peek()));
    return std::move(tree_);
  }

 private:
  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const {
    fail_at(text_, position_, where_, message, hint);
  }

  size_t add(Operation operation, std::array<size_t, 3> of = {}) {
    if (tree_.nodes.size() == kMaxNodes) fail(fmt::format("more than {} terms", kMaxNodes));
    tree_.nodes.push_back(
        {.operation = operation, .position = position_, .number = 0.0, .name = {}, .of = of});
    return tree_.nodes.size() - 1;
  }

  char peek() {
    while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\t')) ++position_;
    return position_ < text_.size() ? text_[position_] : '\0';
  }

  bool take(std::string_view token) {
    peek();
    if (std::string_view(text_).substr(position_, token.size()) != token) return false;
    position_ += token.size();
    return true;
  }

  void expect(char token) {
    if (take(std::string_view(&token, 1))) return;
    if (peek() == '\0') fail(fmt::format("expected '{}' at the end", token));
    fail(fmt::format("expected '{}' instead of '{}'", token, peek()));
  }

  struct Operator {
    std::string_view token;
    Operation operation;
  };

  /// Operands of `operand` joined from the left by any of `operators`.
  template <size_t n>
  size_t chain(size_t (Parser::*operand)(), const std::array<Operator, n>& operators) {
    size_t left = (this->*operand)();
    while (true) {
      const auto found = std::ranges::find_if(operators, [&](const Operator& op) { return take(op.token); });
      if (found == operators.end()) return left;
      const size_t right = (this->*operand)();
      left = add(found->operation, {left, right});
    }
  }

  size_t conditional() {
    if (++depth_ > kMaxDepth) fail(fmt::format("more than {} nested levels", kMaxDepth));
    size_t value = disjunction();
    if (take("?")) {
      const size_t when_true = conditional();
      expect(':');
      const size_t when_false = conditional();
      value = add(Operation::conditional, {value, when_true, when_false});
    }
    --depth_;
    return value;
  }

  size_t disjunction() { return chain<1>(&Parser::conjunction, {{{"||", Operation::disjunction}}}); }
  size_t conjunction() { return chain<1>(&Parser::equality, {{{"&&", Operation::conjunction}}}); }
  size_t equality() {
    return chain<2>(&Parser::relation, {{{"==", Operation::equal}, {"!=", Operation::unequal}}});
  }
  size_t relation() {
    return chain<4>(&Parser::sum, {{{"<=", Operation::less_or_equal},
                                    {">=", Operation::greater_or_equal},
                                    {"<", Operation::less},
                                    {">", Operation::greater}}});
  }
  size_t sum() { return chain<2>(&Parser::product, {{{"+", Operation::add}, {"-", Operation::subtract}}}); }
  size_t product() {
    return chain<2>(&Parser::unary, {{{"*", Operation::multiply}, {"/", Operation::divide}}});
  }

  size_t unary() {
    if (++depth_ > kMaxDepth) fail(fmt::format("more than {} nested levels", kMaxDepth));
    size_t value = 0;
    if (take("-")) {
      value = add(Operation::negate, {unary()});
    } else if (peek() == '!' && std::string_view(text_).substr(position_, 2) != "!=") {
      take("!");
      value = add(Operation::invert, {unary()});
    } else {
      value = primary();
    }
    --depth_;
    return value;
  }

  size_t primary() {
    const char c = peek();
    if (c == '\0') fail(text_.empty() ? "nothing to evaluate" : "unexpected end");
    if (take("(")) {
      const size_t value = conditional();
      expect(')');
      return value;
    }
    if (is_digit(c) || c == '.') return number();
    if (is_name_start(c)) return name_or_call();
    fail(fmt::format("unexpected '{}'", c));
  }

  size_t number() {
    double value = 0.0;
    const char* begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) fail("number out of range");
    if (error != std::errc{}) fail("expected a number");
    position_ += static_cast<size_t>(end - begin);
    if (position_ < text_.size() && is_name_start(text_[position_])) {
      fail(fmt::format("unexpected '{}' after a number", text_[position_]));
    }
    const size_t node = add(Operation::number);
    tree_.nodes[node].number = value;
    return node;
  }

  size_t name_or_call() {
    const size_t begin = position_;
    while (position_ < text_.size() &&
           (is_name_start(text_[position_]) || is_digit(text_[position_]) || text_[position_] == '.')) {
      ++position_;
    }
    const std::string name(text_.substr(begin, position_ - begin));
    if (take("(")) return call(name);
    const size_t node = add(Operation::name);
    tree_.nodes[node].name = name;
    return node;
  }

  size_t call(const std::string& name) {
    const auto known = std::ranges::find(kFunctions, name, &Function::name);
    if (known == kFunctions.end()) {
      std::vector<std::string> functions;
      for (const Function& function : kFunctions) functions.emplace_back(function.name);
      fail(fmt::format("unknown function '{}'", name), suggest_name(name, functions));
    }
    std::array<size_t, 3> arguments{};
    for (size_t k = 0; k < known->arguments; ++k) {
      if (k > 0) expect(',');
      arguments[k] = conditional();
    }
    expect(')');
    return add(known->operation, arguments);
  }

  const std::string& text_;
  FileLocation where_;
  size_t position_ = 0;
  int depth_ = 0;
  ExpressionTree tree_;
};

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
    fail_at(text_, node.position, where_, message, hint);
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
  tree_ = std::make_shared<const ExpressionTree>(Parser(text_, where_).parse());
  for (const Node& node : tree_->nodes) {
    if (node.operation == Operation::name) names_.insert(node.name);
  }
}

double Expression::evaluate(const ExpressionVariables& variables) const {
  UMBRAMETER_ASSERT(tree_ != nullptr, "{} expression", "no");
  return Evaluator(*tree_, variables, text_, where_).value_of(tree_->nodes.size() - 1);
}

}  // namespace umbrameter
