// SPDX-License-Identifier: Apache-2.0
// Without these, a tuner could search where no value is, miss the small values of a length, or spend its time on costs.

#include "study/tune/search/search_space.h"

#include "core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace umbrameter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Parameter real(const std::string& name, double min, double max, const std::string& unit,
               ParameterScale scale = ParameterScale::linear) {
  Parameter parameter;
  parameter.name = name;
  parameter.min = min;
  parameter.max = max;
  parameter.unit = unit;
  parameter.scale = scale;
  parameter.default_value = min;
  return parameter;
}

Parameter integer(const std::string& name, double min, double max, const std::string& unit,
                  ParameterScale scale = ParameterScale::linear) {
  Parameter parameter = real(name, min, max, unit, scale);
  parameter.type = ParameterType::integer;
  parameter.default_value = static_cast<int64_t>(min);
  return parameter;
}

Parameter choice(const std::string& name, std::vector<std::string> choices) {
  Parameter parameter;
  parameter.name = name;
  parameter.type = ParameterType::choice;
  parameter.unit = "none";
  parameter.default_value = choices.front();
  parameter.choices = std::move(choices);
  return parameter;
}

TEST(SearchSpace, ALengthFromZeroIsSearchedByItsCubeRoot) {
  const Parameter bias = real("bias_texels", 0, 32, "texels");
  EXPECT_EQ(value_at(bias, 0.5), ParameterValue(4.0));  // 32 / 8
  EXPECT_EQ(value_at(bias, 1.0), ParameterValue(32.0));
  EXPECT_EQ(value_at(bias, 0.01), ParameterValue(0.0));
  EXPECT_DOUBLE_EQ(position_of(bias, 4.0), 0.5);
}

TEST(SearchSpace, ASharesRangeMattersEverywhereAlike) {
  EXPECT_EQ(value_at(real("bleed_reduction", 0, 0.95, "none"), 0.5), ParameterValue(0.475));
}

TEST(SearchSpace, LogScalesHalveTheExponent) {
  const Parameter exponent = real("exponent", 1, 100, "none", ParameterScale::log);
  EXPECT_EQ(value_at(exponent, 0.5), ParameterValue(10.0));
  EXPECT_EQ(value_at(integer("search_shrink", 1, 256, "none", ParameterScale::log), 0.5),
            ParameterValue(int64_t{16}));
}

TEST(SearchSpace, ValuesAreAllowedOnes) {
  EXPECT_EQ(value_at(integer("n", 0, 4, "none"), 0.6), ParameterValue(int64_t{2}));
  EXPECT_EQ(value_at(integer("n", 1, 8, "none", ParameterScale::pow2), 0.4), ParameterValue(int64_t{2}));
  EXPECT_EQ(value_at(real("x", 0, 1, "none"), 0.123456), ParameterValue(0.123));
  Parameter stepped = real("y", 1, 3, "none");
  stepped.step = 0.5;
  EXPECT_EQ(value_at(stepped, 0.7), ParameterValue(2.5));
  const Parameter three = choice("kind", {"a", "b", "c"});
  EXPECT_EQ(value_at(three, 0.5), ParameterValue(std::string("b")));
  EXPECT_EQ(value_at(three, 1.0), ParameterValue(std::string("c")));
}

TEST(SearchSpace, EveryLevelComesBack) {
  Parameter flag = choice("flag", {"unused"});
  flag.type = ParameterType::boolean;
  flag.default_value = false;
  const std::array axes = {integer("n", 0, 4, "none"), integer("p", 1, 8, "none", ParameterScale::pow2),
                           choice("kind", {"a", "b", "c"}), flag};
  const std::array levels = {5, 4, 3, 2};
  for (size_t i = 0; i < axes.size(); ++i) {
    ASSERT_EQ(level_count(axes[i]), levels[i]);
    for (int level = 0; level < levels[i]; ++level) {
      const ParameterValue value = value_at(axes[i], (level + 0.5) / levels[i]);
      EXPECT_EQ(value_at(axes[i], position_of(axes[i], value)), value) << axes[i].name << " " << level;
    }
  }
}

TEST(SearchSpace, CostsAreTunedOnlyWhenNamed) {
  Parameter size = integer("map_size", 16, 8192, "texels", ParameterScale::pow2);
  size.tune = false;
  const std::array all = {size, integer("taps", 1, 64, "taps"), real("bias", 0, 1, "world")};
  const SearchSpace by_itself = choose_search_space(all, {}, "hard");
  ASSERT_EQ(by_itself.size(), 1u);
  EXPECT_EQ(by_itself.front().name, "bias");
  const std::array<std::string, 2> names = {"taps", "map_size"};
  EXPECT_EQ(choose_search_space(all, names, "hard").size(), 2u);
}

TEST(SearchSpace, NamesAreChecked) {
  const std::array all = {integer("taps", 1, 64, "taps")};
  const auto message = [&](std::vector<std::string> names) {
    try {
      choose_search_space(all, names, "hard");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message({"tap"}), HasSubstr("did you mean 'taps'?"));
  EXPECT_THAT(message({"taps", "taps"}), HasSubstr("'taps' is named twice"));
  EXPECT_THAT(message({}), HasSubstr("no parameter to tune but its costs"));
}

TEST(SearchSpace, NeighboursStopAtTheEnds) {
  const Parameter number = integer("n", 0, 4, "none");
  EXPECT_EQ(neighbour(number, int64_t{3}, 1), ParameterValue(int64_t{4}));
  EXPECT_EQ(neighbour(number, int64_t{4}, 1), std::nullopt);
  EXPECT_EQ(neighbour(choice("kind", {"a", "b"}), std::string("a"), 1), std::nullopt);
}

}  // namespace
}  // namespace umbrameter
