// SPDX-License-Identifier: Apache-2.0
// Without these: a value outside its range, or of the wrong type, could reach a shader.
#include "core/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace umbrameter {
namespace {

Parameter parameter_from(const std::string& text) {
  return read_parameter(parse_toml(text, "m.toml"));
}

const char* const kTaps =
    "name = 'taps'\ntype = 'integer'\ndefault = 16\nmin = 1\nmax = 64\nstage = 'define'\ndoc = 'd'\n";
const char* const kSize =
    "name = 'map_size'\ntype = 'integer'\ndefault = 1024\nmin = 16\nmax = 8192\nscale = 'pow2'\nstage = "
    "'host'\ndoc = 'd'\n";
const char* const kMode =
    "name = 'average'\ntype = 'choice'\nchoices = ['arithmetic', 'harmonic']\ndefault = 'harmonic'\nstage = "
    "'define'\ndoc = 'd'\n";

void expect_input_error(const std::function<void()>& action, const std::string& part) {
  try {
    action();
    ADD_FAILURE() << "no error, wanted: " << part;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(part));
  }
}

TEST(Parameters, ValuesParseByType) {
  EXPECT_EQ(std::get<int64_t>(parse_parameter_value(parameter_from(kTaps), "32")), 32);
  EXPECT_EQ(std::get<std::string>(parse_parameter_value(parameter_from(kMode), "arithmetic")), "arithmetic");
  EXPECT_EQ(numeric_value(parameter_from(kMode), ParameterValue(std::string("harmonic"))), 1.0);
}

TEST(Parameters, BadValuesSayWhatIsWanted) {
  expect_input_error([] { parse_parameter_value(parameter_from(kTaps), "65"); },
                     "'taps' = 65 is outside its range [1, 64]");
  expect_input_error([] { parse_parameter_value(parameter_from(kTaps), "1.5"); },
                     "'taps' wants an integer, not '1.5'");
  expect_input_error([] { parse_parameter_value(parameter_from(kSize), "1000"); },
                     "'map_size' = 1000 is not a power of two");
  expect_input_error([] { parse_parameter_value(parameter_from(kMode), "harmnic"); },
                     "did you mean 'harmonic'?");
}

TEST(Parameters, DeclarationsMustBeConsistent) {
  expect_input_error(
      [] {
        parameter_from(
            "name = 'a'\ntype = 'real'\ndefault = 3\nmin = 0\nmax = 1\nstage = 'uniform'\ndoc = 'd'\n");
      },
      "m.toml:3:11: parameter 'a' = 3 is outside its range [0, 1]");
  expect_input_error(
      [] { parameter_from("name = 'a'\ntype = 'rael'\ndefault = 3\nstage = 'uniform'\ndoc = 'd'\n"); },
      "did you mean 'real'?");
}

const char* const kLength =
    "name = 'bias_world'\ntype = 'real'\ndefault = 0.01\nmin = 0\nmax = 0.5\nunit = 'world'\nrelative_to = "
    "'scene'\nstage = 'uniform'\ndoc = 'd'\n";

TEST(Parameters, LengthsFollowTheScenesSize) {
  const Parameter length = parameter_from(kLength);
  EXPECT_EQ(length.default_value, ParameterValue(std::string("0.01 diagonals")));
  for (const double diagonal_world : {0.01, 1.0, 854.0}) {
    const Parameter here = in_world(length, diagonal_world);
    EXPECT_FALSE(here.is_relative_to_scene);
    EXPECT_DOUBLE_EQ(here.max, 0.5 * diagonal_world);
    EXPECT_DOUBLE_EQ(std::get<double>(here.default_value), 0.01 * diagonal_world);
    const ParameterValues values =
        in_world(std::vector{length}, default_values(std::vector{length}), diagonal_world);
    EXPECT_EQ(values.at("bias_world"), here.default_value);
  }
  const ParameterValue given = parse_parameter_value(length, "2.02");
  EXPECT_EQ(in_world(length, given, 85.0), ParameterValue(2.02));
  EXPECT_EQ(in_world(length, parse_parameter_value(length, "0.25 diagonals"), 8.0), ParameterValue(2.0));
}

TEST(Parameters, LengthsBeyondTheSceneAreErrors) {
  const Parameter length = parameter_from(kLength);
  expect_input_error(
      [&] { in_world(length, 2.02, 1.5); },
      "'bias_world' = 2.02 is outside its range [0, 0.75] in this scene (world units; the scene's "
      "diagonal is 1.5, and 0 to 0.5 of it are allowed)");
  expect_input_error([&] { parse_parameter_value(length, "-1"); },
                     "'bias_world' = -1 is outside its range [0, 0.5] diagonals of the scene");
  expect_input_error([&] { parse_parameter_value(length, "0.6 diagonals"); },
                     "'bias_world' = 0.6 diagonals is outside its range [0, 0.5]");
  expect_input_error([&] { parse_parameter_value(length, "2 m"); },
                     "wants a number of world units or \"<number> diagonals\", not '2 m'");
  expect_input_error([&] { parse_parameter_value(length, "inf"); }, "is outside its range");
}

TEST(Parameters, OnlyLengthsInWorldUnitsFollowTheScene) {
  expect_input_error(
      [] {
        parameter_from(
            "name = 'a'\ntype = 'real'\ndefault = 0\nmin = 0\nmax = 1\nunit = 'texels'\nrelative_to = "
            "'scene'\nstage = 'uniform'\ndoc = 'd'\n");
      },
      "parameter 'a' cannot follow the scene's size");
}

TEST(Parameters, UnknownNamesGetTheNearest) {
  const std::vector<Parameter> parameters = {parameter_from(kTaps), parameter_from(kSize)};
  expect_input_error([&] { find_parameter(parameters, "tap", "pcf"); },
                     "technique 'pcf' has no parameter 'tap' (did you mean 'taps'?)");
}

TEST(Parameters, AssignmentsSplitAtTheFirstEquals) {
  EXPECT_EQ(split_assignment("a=b=c"), (std::pair<std::string, std::string>("a", "b=c")));
  expect_input_error([] { split_assignment("a"); }, "'a' is not of the form name=value");
}

}  // namespace
}  // namespace umbrameter
