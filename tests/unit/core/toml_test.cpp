// SPDX-License-Identifier: Apache-2.0
// Without these: a misspelt key could silently measure the default, or a message could lose its place.
#include "core/toml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace umbrameter {
namespace {

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}

TEST(Toml, SyntaxErrorsNameLineAndColumn) {
  EXPECT_THAT(message_of([] { parse_toml("a = 1\nb = = 2\n", "x.toml"); }),
              testing::StartsWith("x.toml:2:5: "));
}

TEST(Toml, MalformedHeadersAreErrorsInEveryBuild) {
  for (const char* document : {"[!]", "[\n", "[[a]\n"}) {
    EXPECT_THAT(message_of([&] { parse_toml(document, "x.toml"); }), testing::StartsWith("x.toml:1:"));
  }
}

TEST(Toml, OtherLettersBelongInStringsAndComments) {
  const TomlNode document =
      parse_toml("a = \"\xC9\x93 \\\" \xC9\x93\" # \xC9\x93\nb = '''\n\xC9\x93'''", "a.toml");
  EXPECT_EQ(document.entries[0].value.text, "\xC9\x93 \" \xC9\x93");
  EXPECT_THAT([] { parse_toml("a = 1\n  \xC9\x93 = 1", "a.toml"); },
              ::testing::ThrowsMessage<Error>(::testing::HasSubstr("a.toml:2:3: a letter outside ASCII")));
  EXPECT_THROW(parse_toml("a = \xC9\x93", "a.toml"), Error);
}

TEST(Toml, MessagesAreOneLine) {
  EXPECT_THAT([] { parse_toml("a = [0, f\n]", "a.toml"); },
              ::testing::ThrowsMessage<Error>(::testing::Not(::testing::HasSubstr("\n"))));
  EXPECT_THAT([] { fail_input("unknown 'a\nb\x1b[2J'\n\n"); },
              ::testing::ThrowsMessage<Error>(::testing::StrEq("unknown 'a; b\\x1b[2J'")));
}

TEST(Toml, UnknownKeyNamesPlaceAndNearestKey) {
  const TomlNode table = parse_toml("radius_world = 1.0\nradius_wrold = 2.0\n", "x.toml");
  TomlReader reader(table, "[light]");
  EXPECT_EQ(reader.number("radius_world"), 1.0);
  EXPECT_EQ(message_of([&] { reader.finish(); }),
            "x.toml:2:16: [light] has an unknown key 'radius_wrold' (did you mean 'radius_world'?)");
}

TEST(Toml, MisspeltRequiredKeyIsNamed) {
  const TomlNode table = parse_toml("tpye = \"rect\"\n", "x.toml");
  TomlReader reader(table, "[light]");
  EXPECT_EQ(message_of([&] { reader.text("type"); }),
            "x.toml:1:8: [light] has no key 'type', found 'tpye' (did you mean 'type'?)");
}

TEST(Toml, WrongTypeAndNonFiniteNumbersAreErrors) {
  const TomlNode table = parse_toml("a = \"x\"\nb = nan\nc = [1, inf, 3]\nd = [1, 2]\n", "x.toml");
  TomlReader reader(table, "[t]");
  EXPECT_EQ(message_of([&] { reader.number("a"); }), "x.toml:1:5: [t]: 'a' must be a number, not a text");
  EXPECT_EQ(message_of([&] { reader.number("b"); }),
            "x.toml:2:5: [t]: 'b' is nan, which is not a finite number");
  EXPECT_THAT(message_of([&] { reader.vec3("c"); }), testing::HasSubstr("x.toml:3:9: 'c' holds inf"));
  EXPECT_THAT(message_of([&] { reader.vec3("d"); }), testing::HasSubstr("must hold 3 numbers, not 2"));
}

TEST(Toml, IntegersServeAsNumbersAndTablesKeepTheFilesOrder) {
  const TomlNode document = parse_toml("z = 2\na = 1\n[[m]]\nk = 1\n[[m]]\nk = 2\n", "x.toml");
  EXPECT_EQ(document.entries[0].name, "z");
  TomlReader reader(document, "document");
  EXPECT_EQ(reader.number("z"), 2.0);
  EXPECT_EQ(reader.tables("m").size(), 2u);
}

}  // namespace
}  // namespace umbrameter
