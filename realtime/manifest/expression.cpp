// SPDX-License-Identifier: Apache-2.0
#include "realtime/manifest/expression.h"

#include "core/names.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace umbrameter {
namespace {

constexpr int kMaxDepth = 64;  // nesting a person would write; keeps hostile input off the stack

bool is_name_start(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Recursive descent, one function a precedence level, evaluating while it reads. The branch that is not
/// taken
/// (?:, &&, ||) is read but not evaluated, so that "n > 0 ? 1 / n : 0" is fine. Without variables nothing is
/// evaluated and the names are collected.
class Parser {
 public:
  Parser(std::string_view text, const ExpressionVariables* variables, const FileLocation& where)
      : text_(text), variables_(variables), where_(where), live_(variables != nullptr) {}

  double parse() {
    const double value = conditional();
    if (peek() != '\0') fail(fmt::format("unexpected '{}'", peek()));
    return value;
  }

  const std::set<std::string>& names() const { return names_; }

 private:
  [[noreturn]] void fail(const std::string& message, const std::string& hint = {}) const {
    fail_input(fmt::format("{} in expression '{}', character {}", message, text_, position_ + 1), where_,
               hint);
  }

  char peek() {
    while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\t')) ++position_;
    return position_ < text_.size() ? text_[position_] : '\0';
  }

  bool take(std::string_view token) {
    peek();
    if (text_.substr(position_, token.size()) != token) return false;
    position_ += token.size();
    return true;
  }

  void expect(char token) {
    if (take(std::string_view(&token, 1))) return;
    if (peek() == '\0') fail(fmt::format("expected '{}' at the end", token));
    fail(fmt::format("expected '{}' instead of '{}'", token, peek()));
  }

  double checked(double value) const {
    if (live_ && !std::isfinite(value)) fail("the result is not finite");
    return live_ ? value : 0.0;
  }

  /// Reads with `rule`; evaluates only when `wanted`.
  double branch(bool wanted, double (Parser::*rule)()) {
    const bool outer = live_;
    live_ = outer && wanted;
    const double value = (this->*rule)();
    live_ = outer;
    return value;
  }

  double conditional() {
    if (++depth_ > kMaxDepth) fail(fmt::format("more than {} nested levels", kMaxDepth));
    double value = disjunction();
    if (take("?")) {
      const bool is_true = value != 0.0;
      const double when_true = branch(is_true, &Parser::conditional);
      expect(':');
      const double when_false = branch(!is_true, &Parser::conditional);
      value = is_true ? when_true : when_false;
    }
    --depth_;
    return value;
  }

  double disjunction() {
    double value = conjunction();
    while (take("||")) {
      const double right = branch(value == 0.0, &Parser::conjunction);
      value = value != 0.0 || right != 0.0;
    }
    return value;
  }

  double conjunction() {
    double value = equality();
    while (take("&&")) {
      const double right = branch(value != 0.0, &Parser::equality);
      value = value != 0.0 && right != 0.0;
    }
    return value;
  }

  double equality() {
    double value = relation();
    while (true) {
      if (take("==")) {
        value = value == relation();
      } else if (take("!=")) {
        value = value != relation();
      } else {
        return value;
      }
    }
  }

  double relation() {
    double value = sum();
    while (true) {
      if (take("<=")) {
        value = value <= sum();
      } else if (take(">=")) {
        value = value >= sum();
      } else if (take("<")) {
        value = value < sum();
      } else if (take(">")) {
        value = value > sum();
      } else {
        return value;
      }
    }
  }

  double sum() {
    double value = product();
    while (true) {
      if (take("+")) {
        value = checked(value + product());
      } else if (take("-")) {
        value = checked(value - product());
      } else {
        return value;
      }
    }
  }

  double product() {
    double value = unary();
    while (true) {
      if (take("*")) {
        value = checked(value * unary());
      } else if (take("/")) {
        const double divisor = unary();
        if (live_ && divisor == 0.0) fail("division by zero");
        value = live_ ? checked(value / divisor) : 0.0;
      } else {
        return value;
      }
    }
  }

  double unary() {
    if (++depth_ > kMaxDepth) fail(fmt::format("more than {} nested levels", kMaxDepth));
    double value = 0.0;
    if (take("-")) {
      value = -unary();
    } else if (peek() == '!' && text_.substr(position_, 2) != "!=") {
      take("!");
      value = unary() == 0.0;
    } else {
      value = primary();
    }
    --depth_;
    return value;
  }

  double primary() {
    const char c = peek();
    if (c == '\0') fail(text_.empty() ? "nothing to evaluate" : "unexpected end");
    if (take("(")) {
      const double value = conditional();
      expect(')');
      return value;
    }
    if (is_digit(c) || c == '.') return number();
    if (is_name_start(c)) return name_or_call();
    fail(fmt::format("unexpected '{}'", c));
  }

  double number() {
    double value = 0.0;
    const char* begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) fail("number out of range");
    if (error != std::errc{}) fail("expected a number");
    position_ += static_cast<size_t>(end - begin);
    if (position_ < text_.size() && is_name_start(text_[position_])) {
      fail(fmt::format("unexpected '{}' after a number", text_[position_]));
    }
    return value;
  }

  double name_or_call() {
    const size_t begin = position_;
    while (position_ < text_.size() &&
           (is_name_start(text_[position_]) || is_digit(text_[position_]) || text_[position_] == '.')) {
      ++position_;
    }
    const std::string name(text_.substr(begin, position_ - begin));
    if (take("(")) return call(name);
    names_.insert(name);
    if (!live_) return 0.0;
    const auto found = variables_->find(name);
    if (found == variables_->end()) fail_unknown(name);
    return checked(found->second);
  }

  [[noreturn]] void fail_unknown(const std::string& name) const {
    std::vector<std::string> known;
    for (const auto& [known_name, value] : *variables_) known.push_back(known_name);
    fail(fmt::format("unknown name '{}'", name), suggest_name(name, known));
  }

  double call(const std::string& name) {
    static const std::map<std::string, size_t, std::less<>> argument_counts = {
        {"min", 2}, {"max", 2}, {"pow", 2}, {"ceil", 1}, {"floor", 1}, {"log2", 1}, {"abs", 1}};
    const auto known = argument_counts.find(name);
    if (known == argument_counts.end()) {
      std::vector<std::string> functions;
      for (const auto& [function, count] : argument_counts) functions.push_back(function);
      fail(fmt::format("unknown function '{}'", name), suggest_name(name, functions));
    }
    double arguments[2] = {0.0, 0.0};
    for (size_t k = 0; k < known->second; ++k) {
      if (k > 0) expect(',');
      arguments[k] = conditional();
    }
    expect(')');
    return live_ ? checked(apply(name, arguments[0], arguments[1])) : 0.0;
  }

  static double apply(const std::string& name, double a, double b) {
    if (name == "min") return std::min(a, b);
    if (name == "max") return std::max(a, b);
    if (name == "pow") return std::pow(a, b);
    if (name == "ceil") return std::ceil(a);
    if (name == "floor") return std::floor(a);
    if (name == "log2") return std::log2(a);
    return std::abs(a);
  }

  std::string_view text_;
  const ExpressionVariables* variables_;
  FileLocation where_;
  bool live_;
  size_t position_ = 0;
  int depth_ = 0;
  std::set<std::string> names_;
};

}  // namespace

double evaluate_expression(std::string_view text, const ExpressionVariables& variables,
                           const FileLocation& where) {
  return Parser(text, &variables, where).parse();
}

std::set<std::string> expression_names(std::string_view text, const FileLocation& where) {
  Parser parser(text, nullptr, where);
  parser.parse();
  return parser.names();
}

}  // namespace umbrameter
