// SPDX-License-Identifier: Apache-2.0
// Without these, a search could stop beside the optimum, pay twice for a point, or depend on the order of parameters.

#include "study/tune/search/minimise.h"

#include "core/error.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace umbrameter {
namespace {

Parameter axis(const std::string& name, double min, double max, const std::string& unit = "ratio") {
  Parameter parameter;
  parameter.name = name;
  parameter.min = min;
  parameter.max = max;
  parameter.unit = unit;
  parameter.default_value = max;
  return parameter;
}

Parameter choice_axis(const std::string& name, std::vector<std::string> choices) {
  Parameter parameter = axis(name, 0, 0);
  parameter.type = ParameterType::choice;
  parameter.default_value = choices.front();
  parameter.choices = std::move(choices);
  return parameter;
}

double number(const ParameterValues& values, const std::string& name) {
  return std::get<double>(values.at(name));
}

double square(double x) {
  return x * x;
}

SearchResult search(const SearchSpace& space, const ObjectiveFunction& objective, size_t evaluations) {
  const ParameterValues start = default_values(space);
  const SearchBudget budget{evaluations, {}};
  return minimise(space, std::span(&start, 1), start, objective, budget);
}

/// Least over a dense grid of the unit cube.
double grid_least(const SearchSpace& space, const ObjectiveFunction& objective, int steps) {
  double least = std::numeric_limits<double>::infinity();
  const auto count = static_cast<size_t>(std::lround(std::pow(steps, space.size())));
  for (size_t index = 0; index < count; ++index) {
    Point point;
    for (size_t i = 0, rest = index; i < space.size(); ++i, rest /= static_cast<size_t>(steps))
      point.push_back(static_cast<double>(rest % static_cast<size_t>(steps)) / (steps - 1));
    least = std::min(least, objective(values_at(space, point, {})));
  }
  return least;
}

/// Acne below a bias that depends on the other offset, peter-panning that rises with both: a step and a slope.
double step_like(const ParameterValues& values) {
  const double bias = number(values, "bias"), offset = number(values, "offset");
  const double acne = bias + 2.0 * offset < 1.3 ? 1.0 : 0.0;
  return 0.1 + acne + 0.05 * bias + 0.08 * offset;
}

/// A crooked valley, the optimum 1 at x = 0.3, y = 7.
double valley(const ParameterValues& values) {
  const double x = number(values, "x"), y = number(values, "y") / 10.0;
  return 1.0 + 4.0 * square(x - 0.3 + 0.8 * (y - 0.7)) + square(y - 0.7);
}

/// The same with 1 % of repeatable noise.
double noisy_valley(const ParameterValues& values) {
  const double seed = 12.9898 * number(values, "x") + 78.233 * number(values, "y");
  const double noise = std::sin(seed) * 43758.5453;
  return valley(values) * (1.0 + 0.01 * (noise - std::floor(noise)));
}

const SearchSpace kValley = {axis("x", -1, 1), axis("y", 0.1, 20)};

TEST(Minimise, ComesWithinTwoPercentOfADenseGridForFivePercentOfItsPrice) {
  const SearchSpace biases = {axis("bias", 0, 32, "texels"), axis("offset", 0, 32, "texels")};
  const std::vector<std::pair<SearchSpace, ObjectiveFunction>> problems = {
      {biases, step_like}, {kValley, valley}, {kValley, noisy_valley}};
  constexpr int kSteps = 30;
  for (const auto& [space, objective] : problems) {
    const SearchResult found = search(space, objective, kSteps * kSteps / 20);
    EXPECT_LE(found.best.objective, 1.02 * grid_least(space, objective, kSteps));
  }
}

TEST(Minimise, FindsIntegersAndLogScales) {
  Parameter exponent = axis("exponent", 1, 1000);
  exponent.scale = ParameterScale::log;
  Parameter count = axis("count", 0, 20);
  count.type = ParameterType::integer;
  count.default_value = int64_t{0};
  const SearchSpace space = {exponent, count};
  const auto objective = [](const ParameterValues& values) {
    const double n = static_cast<double>(std::get<int64_t>(values.at("count")));
    return 1.0 + square(std::log10(number(values, "exponent")) - 1.6) + 0.1 * square(n - 13.0);
  };
  const SearchResult found = search(space, objective, 60);
  EXPECT_EQ(std::get<int64_t>(found.best.values.at("count")), 13);
  EXPECT_NEAR(std::log10(number(found.best.values, "exponent")), 1.6, 0.05);
}

TEST(Minimise, FindsAChoiceThatNeedsOtherNumbers) {
  // At the best bias of "plane", 0.1, "none" is worse; with 0.7 it is better.
  const SearchSpace space = {choice_axis("receiver", {"plane", "none"}), axis("bias", 0, 1, "none")};
  const auto objective = [](const ParameterValues& values) {
    const bool is_none = values.at("receiver") == ParameterValue(std::string("none"));
    const double bias = number(values, "bias");
    return is_none ? 0.8 + square(bias - 0.7) : 1.0 + square(bias - 0.1);
  };
  const SearchResult found = search(space, objective, 60);
  EXPECT_EQ(found.best.values.at("receiver"), ParameterValue(std::string("none")));
  EXPECT_NEAR(found.best.objective, 0.8, 0.002);
}

// A map that lost its casters is the same with every bias; the other one has acne until a bias mends it.
TEST(Minimise, LeavesAChoiceBesideWhichNoNumberMatters) {
  SearchSpace space = {axis("bias", -1, 1), choice_axis("casters", {"lost", "kept"})};
  space[0].default_value = 0.0;
  const auto objective = [](const ParameterValues& values) {
    if (std::get<std::string>(values.at("casters")) == "lost") return 1.0;
    const double bias = number(values, "bias");
    return bias > -0.1 ? 1.2 : 0.3 - bias;
  };
  const SearchResult result = search(space, objective, 40);
  EXPECT_EQ(result.best.values.at("casters"), ParameterValue(std::string("kept")));
  EXPECT_LT(result.best.objective, 0.45);
}

TEST(Minimise, KeepsOutOfWhatIsForbidden) {
  const auto walled = [](const ParameterValues& values) {
    return number(values, "x") > 0.2 && number(values, "x") < 0.9 ? std::numeric_limits<double>::infinity()
                                                                  : valley(values);
  };
  const SearchResult found = search(kValley, walled, 60);
  EXPECT_LE(found.best.objective, 1.03);  // x = 0.2, y = 7.6: 1 + 4 (-0.1 + 0.05)^2 + 0.06^2 = 1.01
  EXPECT_LE(number(found.best.values, "x"), 0.2);
}

TEST(Minimise, PaysOncePerPointAndNeverMoreThanItsBudget) {
  std::multiset<std::string> asked;
  const auto counted = [&](const ParameterValues& values) {
    asked.insert(key_of(values));
    return valley(values);
  };
  const SearchResult found = search(kValley, counted, 40);
  EXPECT_EQ(asked.size(), found.trials.size());
  EXPECT_LE(asked.size(), 40u);
  EXPECT_EQ(std::set<std::string>(asked.begin(), asked.end()).size(), asked.size());
  const auto least = std::ranges::min_element(found.trials, {}, &TuneTrial::objective);
  EXPECT_EQ(found.best.objective, least->objective);
}

TEST(Minimise, StopsWhenTheTimeIsUp) {
  size_t asked = 0;
  const ObjectiveFunction counted = [&](const ParameterValues& values) {
    ++asked;
    return valley(values);
  };
  const ParameterValues start = default_values(kValley);
  const SearchBudget budget{1000, [&] { return asked >= 7; }};
  const SearchResult found = minimise(kValley, std::span(&start, 1), start, counted, budget);
  EXPECT_EQ(asked, 7u);
  EXPECT_FALSE(found.is_converged);
}

TEST(Minimise, TriesTheSamePointsAgain) {
  const SearchResult once = search(kValley, noisy_valley, 50), again = search(kValley, noisy_valley, 50);
  ASSERT_EQ(once.trials.size(), again.trials.size());
  for (size_t i = 0; i < once.trials.size(); ++i)
    EXPECT_EQ(once.trials[i].values, again.trials[i].values) << i;
}

TEST(Minimise, ParameterOrderDoesNotMoveTheOptimum) {
  const SearchSpace turned = {kValley[1], kValley[0]};
  EXPECT_NEAR(search(kValley, valley, 200).best.objective, search(turned, valley, 200).best.objective, 1e-3);
}

TEST(Minimise, TellsWhichAxisMatters) {
  SearchSpace space = kValley;
  space.push_back(axis("idle", 0, 1));
  const SearchResult found = search(space, valley, 60);
  ASSERT_EQ(found.effects.size(), 3u);
  EXPECT_EQ(found.effects[2].relative_spread, 0.0);
  EXPECT_GT(found.effects[0].relative_spread, 0.5);
}

TEST(Minimise, ScreensEveryAxisBeforeAnyGetsAllItsLevels) {
  SearchSpace space;
  for (int i = 0; i < 8; ++i) space.push_back(axis(fmt::format("p{}", i), 0, 1, "none"));
  const auto objective = [](const ParameterValues& values) {  // the last axis alone matters
    return 1.0 + square(number(values, "p7") - 0.4);
  };
  const SearchResult found = search(space, objective, 1 + 8 * 2);  // the start, and two levels an axis
  for (const AxisEffect& effect : found.effects) EXPECT_EQ(effect.values, 3u) << effect.parameter;
  EXPECT_GT(found.effects[7].relative_spread, 0.1);
  const SearchResult more = search(space, objective, 1 + 8 * 2 + 3);
  EXPECT_EQ(more.effects[6].values, 3u);
  EXPECT_EQ(more.effects[7].values, 5u);
}

TEST(Minimise, WhatDoesNotActIsNeverMoved) {
  SearchSpace space = {choice_axis("curve", {"physical", "squared"}), axis("radius", 0, 1, "none"),
                       axis("x", 0, 1, "none")};
  const IsActive is_active = [](const Parameter& parameter, const ParameterValues& values) {
    return parameter.name != "radius" || values.at("curve") == ParameterValue(std::string("squared"));
  };
  const auto with_curve_worth = [&](double worth) {
    const ObjectiveFunction objective = [worth](const ParameterValues& values) {
      const bool is_squared = values.at("curve") == ParameterValue(std::string("squared"));
      const double curve = is_squared ? worth + square(number(values, "radius") - 0.3) : 0.5;
      return curve + square(number(values, "x") - 0.6);
    };
    const ParameterValues start = default_values(space);
    return minimise(space, std::span(&start, 1), start, objective, {80, {}}, is_active);
  };
  const SearchResult physical = with_curve_worth(1.0);
  EXPECT_FALSE(physical.effects[1].is_active);
  for (const TuneTrial& trial : physical.trials) {
    const bool is_physical = trial.values.at("curve") == ParameterValue(std::string("physical"));
    EXPECT_TRUE(!is_physical || number(trial.values, "radius") == 1.0);
  }
  const SearchResult squared = with_curve_worth(0.0);
  EXPECT_TRUE(squared.effects[1].is_active);
  EXPECT_NEAR(number(squared.best.values, "radius"), 0.3, 0.02);
}

TEST(Minimise, SaysWhenNothingCanBeMeasured) {
  const auto broken = [](const ParameterValues&) { return std::numeric_limits<double>::infinity(); };
  EXPECT_THROW(search(kValley, broken, 10), Error);
}

}  // namespace
}  // namespace umbrameter
