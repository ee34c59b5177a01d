// SPDX-License-Identifier: Apache-2.0
#include "realtime/graph/expression_tree.h"

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
    fail_in_expression(text_, position_, where_, message, hint);
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

}  // namespace

ExpressionTree parse_expression(const std::string& text, const FileLocation& where) {
  return Parser(text, where).parse();
}

void fail_in_expression(const std::string& text, size_t position, const FileLocation& where,
                        const std::string& message, const std::string& hint) {
  fail_input(fmt::format("{} in expression '{}', character {}", message, text, position + 1), where, hint);
}

}  // namespace umbrameter
