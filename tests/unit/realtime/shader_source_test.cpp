// SPDX-License-Identifier: Apache-2.0
// Without these, an #include could be read twice, in a circle, or from the wrong folder, and a driver's log
// be attributed to a line that is not the user's.

#include "realtime/harness/shader_source.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class ShaderSourceTest : public ::testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) {
    const fs::path file = folder_.path() / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  ShaderSource load(const fs::path& file, const std::string& prelude = {}) {
    const std::vector<fs::path> search = {folder_.path() / "lib", folder_.path() / "shared"};
    return load_shader_source(file, prelude, search);
  }
  std::string error_of(const fs::path& file) {
    try {
      load(file);
    } catch (const Error& error) {
      EXPECT_EQ(static_cast<int>(error.kind()), static_cast<int>(ErrorKind::input));
      return error.what();
    }
    ADD_FAILURE() << "nothing was thrown";
    return {};
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(ShaderSourceTest, PutsVersionThenPreludeThenFileWithSourceNumbers) {
  const fs::path file = write("a.frag", "void main() {}\n");
  const ShaderSource source = load(file, "#define N 3\n");
  EXPECT_EQ(source.text, "#version 450 core\n#line 1 0\n#define N 3\n#line 1 1\nvoid main() {}\n");
  EXPECT_THAT(source.files, ::testing::ElementsAre("prelude of " + file.string(), file.string()));
  EXPECT_THAT(source.dependencies, ::testing::ElementsAre(file));
}

TEST_F(ShaderSourceTest, AnIncludeStandsInPlaceAndTheLineCountGoesOn) {
  write("part.glsl", "part");
  const fs::path file = write("a.frag", "one\n  #  include \"part.glsl\"\nthree\n");
  EXPECT_THAT(load(file).text, HasSubstr("#line 1 1\none\n#line 1 2\npart\n#line 3 1\nthree\n"));
}

TEST_F(ShaderSourceTest, TheFolderOfTheIncludingFileComesFirstThenTheSearchFoldersInOrder) {
  write("lib/x.glsl", "from lib");
  write("shared/x.glsl", "from shared");
  write("shared/y.glsl", "from shared");
  const fs::path plain = write("user/a.frag", "#include \"x.glsl\"\n#include \"y.glsl\"\n");
  EXPECT_THAT(load(plain).text, AllOf(HasSubstr("from lib"), HasSubstr("from shared")));
  write("user/x.glsl", "from user");
  EXPECT_THAT(load(plain).text, AllOf(HasSubstr("from user"), Not(HasSubstr("from lib"))));
}

TEST_F(ShaderSourceTest, AFileIsIncludedOnceEvenByAnotherSpelling) {
  write("lib/x.glsl", "only_once\n");
  const std::string text =
      load(write("a.frag", "#include \"x.glsl\"\n#include \"lib/../lib/x.glsl\"\n")).text;
  EXPECT_EQ(text.find("only_once"), text.rfind("only_once"));
}

TEST_F(ShaderSourceTest, ThePreludeMayIncludeFromTheSearchFolders) {
  write("shared/data.h", "struct Data { float x; };\n");
  EXPECT_THAT(load(write("a.frag", ""), "#include \"data.h\"\n").text, HasSubstr("struct Data"));
}

TEST_F(ShaderSourceTest, CppOnlyLinesOfSharedHeadersAreLeftBlank) {
  write("shared/data.h", "#pragma once\n#include <glm/vec4.hpp>\nvec4 x;\n");
  const ShaderSource source = load(write("a.frag", "#include \"data.h\"\n"));
  EXPECT_THAT(source.text, HasSubstr("#line 1 2\n\n\nvec4 x;\n"));
}

TEST_F(ShaderSourceTest, CommentedIncludesAreNotFollowed) {
  const fs::path file = write(
      "a.frag", "// #include \"none.glsl\"\n/* a\n#include \"none.glsl\"\n*/ // /*\n#include \"x.glsl\"\n");
  write("x.glsl", "reached");
  EXPECT_THAT(load(file).text, HasSubstr("reached"));
}

TEST_F(ShaderSourceTest, WindowsLineEndingsCountAsOneLine) {
  write("x.glsl", "x\r\n");
  EXPECT_THAT(load(write("a.frag", "one\r\n#include \"x.glsl\"\r\nthree")).text,
              HasSubstr("one\n#line 1 2\nx\n#line 3 1\nthree\n"));
}

TEST_F(ShaderSourceTest, ACircleIsAnErrorThatNamesTheChain) {
  write("b.glsl", "#include \"c.glsl\"\n");
  const fs::path c = write("c.glsl", "\n#include \"b.glsl\"\n");
  EXPECT_THAT(error_of(write("a.frag", "#include \"b.glsl\"\n")),
              AllOf(HasSubstr(c.string() + ":2"), HasSubstr("a.frag > b.glsl > c.glsl > b.glsl")));
}

TEST_F(ShaderSourceTest, TooDeepAnIncludeIsAnError) {
  for (int i = 0; i < 20; ++i) {
    write("d" + std::to_string(i) + ".glsl", "#include \"d" + std::to_string(i + 1) + ".glsl\"\n");
  }
  EXPECT_THAT(error_of(write("a.frag", "#include \"d0.glsl\"\n")), HasSubstr("deeper than 16"));
}

TEST_F(ShaderSourceTest, AMissingFileIsAnErrorAtTheIncludeThatNamesTheFolders) {
  const fs::path file = write("a.frag", "\n\n#include \"none.glsl\"\n");
  EXPECT_THAT(error_of(file), AllOf(HasSubstr(file.string() + ":3"), HasSubstr("none.glsl"),
                                    HasSubstr(file.parent_path().string()), HasSubstr("lib")));
}

TEST_F(ShaderSourceTest, MalformedIncludesAndVersionLinesAreErrorsAtTheirLine) {
  for (const char* text : {"#include none", "#include \"open", "#include \"\"", "#include", "#version 330"}) {
    const fs::path file = write("a.frag", std::string("\n") + text + "\n");
    EXPECT_THAT(error_of(file), HasSubstr(file.string() + ":2")) << text;
  }
}

ShaderSource two_files() {
  ShaderSource source;
  source.files = {"prelude of a.frag", "a.frag", "lib.glsl"};
  return source;
}

TEST(ShaderLog, MesaNvidiaAndGlslangMessagesFindTheirFile) {
  const auto messages = parse_shader_log(
      "0:12(3): error: `x' undeclared\n"
      "2:7(1): preprocessor error: bad #if\n"
      "1(40) : error C1503: undefined variable \"y\"\n"
      "2(8) : warning C7050: \"z\" might be used before being initialized\n"
      "ERROR: 1:9: 'w' : undeclared identifier\n",
      two_files());
  ASSERT_EQ(messages.size(), 5u);
  EXPECT_EQ(to_string(messages[0].where), "prelude of a.frag:12:3");
  EXPECT_EQ(messages[0].text, "`x' undeclared");
  EXPECT_EQ(to_string(messages[1].where), "lib.glsl:7:1");
  EXPECT_EQ(to_string(messages[2].where), "a.frag:40");
  EXPECT_EQ(messages[2].text, "undefined variable \"y\"");
  EXPECT_EQ(to_string(messages[3].where), "lib.glsl:8");
  EXPECT_EQ(to_string(messages[4].where), "a.frag:9");
  for (size_t i = 0; i < 5; ++i) EXPECT_EQ(messages[i].is_error, i != 3) << i;
}

TEST(ShaderLog, AMissingReadIsNamedAsManifestsNameIt) {
  EXPECT_EQ(missing_read_hint("`noise_blue' undeclared"), "list 'noise.blue' in the pass's 'reads'");
  EXPECT_EQ(missing_read_hint("undefined variable \"scene_bvh\""), "list 'scene.bvh' in the pass's 'reads'");
  EXPECT_EQ(missing_read_hint("'previous_gbuffer_shading_normal' : undeclared identifier"),
            "list 'previous.gbuffer.shading_normal' in the pass's 'reads'");
  EXPECT_EQ(missing_read_hint("`x' undeclared"), "");
  EXPECT_EQ(missing_read_hint("`noise_blue' redeclared"), "");
}

TEST(ShaderLog, WhatIsNotUnderstoodIsKeptWithoutAPlace) {
  const auto messages = parse_shader_log("\nout of registers\n99:1(1): error: z\n", two_files());
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[0].text, "out of registers");
  EXPECT_TRUE(messages[0].where.file.empty());
  EXPECT_TRUE(messages[1].is_error);
  EXPECT_TRUE(messages[1].where.file.empty()) << "there is no source 99";
}

}  // namespace
}  // namespace umbrameter
