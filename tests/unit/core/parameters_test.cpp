// SPDX-License-Identifier: Apache-2.0
// Without these: a value outside its range, or of the wrong type, could reach a shader.
#include "core/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
