// SPDX-License-Identifier: Apache-2.0
// Without these, a size or a condition of a manifest could silently mean something else than it says.

#include "realtime/graph/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace umbrameter {
namespace {

double value_of(std::string_view text, const ExpressionVariables& variables = {}) {
  return Expression(text, {"technique.toml", 7, 3}).evaluate(variables);
}

std::string error_of(std::string_view text, const ExpressionVariables& variables = {}) {
  try {
    value_of(text, variables);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), testing::StartsWith("technique.toml:7:3: "));
    return error.what();
  }
  return "no error";
}

TEST(Expression, MultipliesBeforeItAdds) {
  EXPECT_EQ(value_of("2 + 3 * 4"), 14.0);
  EXPECT_EQ(value_of("(2 + 3) * 4"), 20.0);
}

TEST(Expression, SubtractsAndDividesFromTheLeft) {
  EXPECT_EQ(value_of("10 - 4 - 3"), 3.0);
  EXPECT_EQ(value_of("64 / 4 / 2"), 8.0);
}

TEST(Expression, MinusBindsTighterThanTimes) {
  EXPECT_EQ(value_of("-2 * -3"), 6.0);
}

TEST(Expression, ComparesAfterArithmetic) {
  EXPECT_EQ(value_of("1 + 1 == 2"), 1.0);
  EXPECT_EQ(value_of("1 < 2 == 1"), 1.0);
  EXPECT_EQ(value_of("3 <= 2"), 0.0);
  EXPECT_EQ(value_of("3 >= 3"), 1.0);
  EXPECT_EQ(value_of("3 != 3"), 0.0);
}

TEST(Expression, AndBindsTighterThanOr) {
  EXPECT_EQ(value_of("1 || 0 && 0"), 1.0);
  EXPECT_EQ(value_of("(1 || 0) && 0"), 0.0);
  EXPECT_EQ(value_of("!0 && !(2 > 3)"), 1.0);
}

TEST(Expression, TernaryNestsToTheRight) {
  EXPECT_EQ(value_of("0 ? 1 : 0 ? 2 : 3"), 3.0);
  EXPECT_EQ(value_of("1 ? 0 ? 5 : 6 : 7"), 6.0);
}

TEST(Expression, BranchNotTakenIsNotEvaluated) {
  EXPECT_EQ(value_of("n > 0 ? 1 / n : 9", {{"n", 0.0}}), 9.0);
  EXPECT_EQ(value_of("n == 0 || 1 / n > 2", {{"n", 0.0}}), 1.0);
  EXPECT_EQ(value_of("n != 0 && 1 / n > 2", {{"n", 0.0}}), 0.0);
}

TEST(Expression, FunctionsHaveTheirUsualValues) {
  EXPECT_EQ(value_of("min(3, max(1, 2))"), 2.0);
  EXPECT_EQ(value_of("ceil(1.25) + floor(1.75)"), 3.0);
  EXPECT_EQ(value_of("log2(1024)"), 10.0);
  EXPECT_EQ(value_of("pow(2, 12)"), 4096.0);
  EXPECT_EQ(value_of("abs(2 - 5)"), 3.0);
}

TEST(Expression, NamesMayHoldDots) {
  EXPECT_EQ(value_of("ceil(screen.width / 4)", {{"screen.width", 961.0}}), 241.0);
}

TEST(Expression, UnknownNameSuggestsTheNearest) {
  EXPECT_THAT(error_of("map_sise * 2", {{"map_size", 512.0}}),
              testing::AllOf(testing::HasSubstr("unknown name 'map_sise'"), testing::HasSubstr("map_size")));
}

TEST(Expression, UnknownFunctionSuggestsTheNearest) {
  EXPECT_THAT(error_of("flor(2)"),
              testing::AllOf(testing::HasSubstr("unknown function 'flor'"), testing::HasSubstr("floor")));
}

TEST(Expression, DivisionByZeroIsAnError) {
  EXPECT_THAT(error_of("1 / (2 - 2)"), testing::HasSubstr("division by zero"));
}

TEST(Expression, ResultMustBeFinite) {
  EXPECT_THAT(error_of("log2(0)"), testing::HasSubstr("not finite"));
  EXPECT_THAT(error_of("pow(10, 400)"), testing::HasSubstr("not finite"));
  EXPECT_THAT(error_of("1e300 * 1e300"), testing::HasSubstr("not finite"));
}

TEST(Expression, SyntaxErrorsSayWhatAndWhere) {
  EXPECT_THAT(error_of(""), testing::HasSubstr("nothing to evaluate"));
  EXPECT_THAT(error_of("2 +"), testing::HasSubstr("unexpected end"));
  EXPECT_THAT(error_of("(2"), testing::HasSubstr("expected ')' at the end"));
  EXPECT_THAT(error_of("min(1)"), testing::HasSubstr("expected ',' instead of ')'"));
  EXPECT_THAT(error_of("2 3"), testing::HasSubstr("unexpected '3'"));
  EXPECT_THAT(error_of("2x"), testing::HasSubstr("unexpected 'x' after a number"));
  EXPECT_THAT(error_of("1 ? 2"), testing::HasSubstr("expected ':'"));
  EXPECT_THAT(error_of("2 & 3"), testing::HasSubstr("character 3"));
}

TEST(Expression, DeepNestingIsAnErrorNotACrash) {
  EXPECT_THAT(error_of(std::string(100000, '(')), testing::HasSubstr("nested levels"));
  EXPECT_THAT(error_of(std::string(100000, '-')), testing::HasSubstr("nested levels"));
}

TEST(Expression, LongChainsAreAnErrorNotACrash) {
  std::string chain = "1";
  for (int i = 0; i < 100000; ++i) chain += "+1";
  EXPECT_THAT(error_of(chain), testing::HasSubstr("more than 1000 terms"));
}

TEST(Expression, IsReadOnceAndEvaluatedForManyVariables) {
  const Expression area("side * side");
  EXPECT_EQ(area.evaluate({{"side", 3.0}}), 9.0);
  EXPECT_EQ(area.evaluate({{"side", 5.0}}), 25.0);
  EXPECT_FALSE(area.is_empty());
  EXPECT_TRUE(Expression().is_empty());
}

TEST(Expression, NamesAreListedWithoutEvaluating) {
  EXPECT_THAT(Expression("a / 0 + max(b.c, a) + (d ? e : 1)").names(),
              testing::ElementsAre("a", "b.c", "d", "e"));
  EXPECT_THROW(Expression("a +"), Error);
}

// Random strings over the alphabet of the language end in a finite value or in Error{input}, nothing else.
TEST(Expression, RandomTextNeverEscapesAsAnythingElse) {
  constexpr std::string_view kAlphabet = "0123456789.ab +-*/()<>=!&|?:,eminax";
  std::mt19937 random(1);
  int values = 0;
  int errors = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text(1 + random() % 12, ' ');
    for (char& c : text) c = kAlphabet[random() % kAlphabet.size()];
    try {
      EXPECT_TRUE(std::isfinite(value_of(text, {{"a", 2.0}, {"b", 0.0}}))) << text;
      ++values;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input) << text;
      ++errors;
    }
  }
  EXPECT_GT(values, 100);  // the fuzz reaches both outcomes
  EXPECT_GT(errors, 100);
}

}  // namespace
}  // namespace umbrameter
