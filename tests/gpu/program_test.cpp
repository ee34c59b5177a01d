// SPDX-License-Identifier: Apache-2.0
// Without these, a mistake in a user's shader would point at the wrong file, and a block at the wrong bytes.

#include "realtime/harness/program.h"
#include "realtime/harness/frame_uniforms.h"
#include "tests/gpu/gl_test.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <array>
#include <chrono>
#include <fstream>

namespace umbrameter {
namespace {

namespace fs = std::filesystem;
using test::error_of;
using test::GlTest;
using ::testing::AllOf;
using ::testing::HasSubstr;

class ProgramTest : public GlTest {
 protected:
  fs::path write(const std::string& name, const std::string& text) {
    const fs::path file = folder_.path() / name;
    std::ofstream(file) << text;
    return file;
  }

  static std::array<ShaderFile, 2> stages_of(const fs::path& fragment, const std::string& prelude = {}) {
    return {{{ShaderStage::vertex, test::shaders_folder() / "lib/fullscreen.vert", ""},
             {ShaderStage::fragment, fragment, prelude}}};
  }

  Program build(const fs::path& fragment, const std::string& prelude = {}) {
    const auto stages = stages_of(fragment, prelude);
    const std::array<fs::path, 1> search = {test::shaders_folder() / "shared"};
    return Program(stages, search);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(ProgramTest, AMistakeIsReportedAtItsOwnLine) {
  const fs::path file = write("wrong.frag",
                              "layout(location = 0) out float out_v;\n"
                              "void main() {\n"
                              "  out_v = no_such_name;\n"
                              "}\n");
  EXPECT_THAT(error_of(ErrorKind::input, [&] { build(file, "float unused_1;\nfloat unused_2;\n"); }),
              AllOf(HasSubstr(file.string() + ":3"), HasSubstr("no_such_name")));
}

TEST_F(ProgramTest, AMistakeDoesNotFailTheNextCheckOfGl) {
  const fs::path file = write("wrong.frag", "void main() { no_such_function(); }\n");
  error_of(ErrorKind::input, [&] { build(file); });
  EXPECT_NO_THROW(check_gl_errors("the next pass"));
}

TEST_F(ProgramTest, AMistakeAfterAnIncludeIsReportedAtItsOwnLine) {
  write("three_lines.glsl", "float a() { return 1.0; }\n\n\n");
  const fs::path file = write("wrong.frag",
                              "#include \"three_lines.glsl\"\n"
                              "layout(location = 0) out float out_v;\n"
                              "void main() { out_v = a() + no_such_name; }\n");
  EXPECT_THAT(error_of(ErrorKind::input, [&] { build(file); }), HasSubstr(file.string() + ":3"));
}

TEST_F(ProgramTest, AMistakeInAnIncludeIsReportedInTheInclude) {
  const fs::path include = write("broken.glsl", "// fine\nfloat b() { return vec2(1.0); }\n");
  const fs::path file = write("user.frag",
                              "layout(location = 0) out float out_v;\n"
                              "#include \"broken.glsl\"\n"
                              "void main() { out_v = b(); }\n");
  EXPECT_THAT(error_of(ErrorKind::input, [&] { build(file); }), HasSubstr(include.string() + ":2"));
}

TEST_F(ProgramTest, AMistakeInTheGeneratedTextNamesTheFileItIsFor) {
  const fs::path file = write("fine.frag", "void main() {}\n");
  EXPECT_THAT(error_of(ErrorKind::input, [&] { build(file, "float fine;\nfloat 3d;\n"); }),
              HasSubstr("prelude of " + file.string() + ":2"));
}

TEST_F(ProgramTest, StagesThatDoNotFitAreAnInputError) {
  const fs::path file = write("link.frag",
                              "in vec3 never_written;\n"
                              "layout(location = 0) out vec4 out_v;\n"
                              "void main() { out_v = vec4(never_written, 1.0); }\n");
  EXPECT_THAT(error_of(ErrorKind::input, [&] { build(file); }),
              AllOf(HasSubstr(file.string()), HasSubstr("link")));
}

TEST_F(ProgramTest, DependenciesNameEveryFileThatWasRead) {
  const fs::path include = write("part.glsl", "float a() { return 1.0; }\n");
  const fs::path file = write(
      "user.frag", "#include \"part.glsl\"\nlayout(location = 0) out float o;\nvoid main() { o = a(); }\n");
  EXPECT_THAT(build(file).dependencies(), ::testing::IsSupersetOf({file, include}));
}

TEST_F(ProgramTest, TheCacheCompilesAgainOnlyWhenSomeTextChanged) {
  ProgramCache cache({test::shaders_folder() / "lib"});
  write("part.glsl", "float a() { return 1.0; }\n");
  const fs::path file = write(
      "user.frag", "#include \"part.glsl\"\nlayout(location = 0) out float o;\nvoid main() { o = a(); }\n");
  const auto stages = stages_of(file);
  const auto first = cache.get(stages);
  EXPECT_EQ(cache.get(stages), first);
  write("part.glsl", "float a() { return 2.0; }\n");
  EXPECT_NE(cache.get(stages), first);
}

TEST_F(ProgramTest, AnEditIsSeenAfterFilesWereLeftAloneForAWhile) {
  ProgramCache cache({test::shaders_folder() / "lib"});
  const fs::path file = write("user.frag", "layout(location = 0) out float o;\nvoid main() { o = 1.0; }\n");
  for (const fs::path& place : {file, file.parent_path()})
    fs::last_write_time(place, fs::file_time_type::clock::now() - std::chrono::hours(1));
  const auto stages = stages_of(file);
  const auto first = cache.get(stages);
  EXPECT_EQ(cache.get(stages), first);
  write("user.frag", "layout(location = 0) out float o;\nvoid main() { o = 2.0; }\n");
  EXPECT_NE(cache.get(stages), first);
}

TEST_F(ProgramTest, AMistakeIsReportedEachTimeItIsAskedFor) {
  ProgramCache cache({test::shaders_folder() / "lib"});
  const fs::path file = write("wrong.frag", "void main() { no_such_function(); }\n");
  const auto stages = stages_of(file);
  for (int k = 0; k < 2; ++k)
    EXPECT_THAT(error_of(ErrorKind::input, [&] { cache.get(stages); }), HasSubstr("no_such_function"));
}

TEST_F(ProgramTest, MacrosThatAShaderDoesNotNameMakeNoOtherProgram) {
  ProgramCache cache({test::shaders_folder() / "lib"});
  const fs::path file =
      write("user.frag", "layout(location = 0) out float o;\nvoid main() { o = float(TAPS); }\n");
  const auto with = [&](const std::string& prelude) {
    const std::array<ShaderFile, 2> stages = {
        {{ShaderStage::vertex, test::shaders_folder() / "lib/fullscreen.vert", prelude},
         {ShaderStage::fragment, file, prelude}}};
    return cache.get(stages);
  };
  const auto first = with("#define TAPS 4\n#define BILINEAR 0\n");
  EXPECT_EQ(with("#define TAPS 4\n#define BILINEAR 1\n"), first);
  EXPECT_NE(with("#define TAPS 8\n#define BILINEAR 0\n"), first);
}

TEST_F(ProgramTest, TheDriverLaysFrameDataOutAsCppDoes) {
  const fs::path file =
      write("blocks.frag",
            "layout(std140, binding = 3) uniform ViewBlock { LightViewData view; };\n"
            "layout(location = 0) out vec4 o;\n"
            "void main() {\n"
            "  o = frame.clip_from_world * frame.eye_world + vec4(frame.light_type) + frame.light_extent;\n"
            "  o += view.clip_from_light * view.lateral_bounds + view.depth_range;\n"
            "}\n");
  const Program program = build(file, std::string(kFrameBlockGlsl));
  std::map<std::string, int> offsets;
  for (const char* block : {"FrameBlock", "ViewBlock"}) {
    for (const BlockMember& member : uniform_block_members(program, block))
      offsets[member.name] = member.offset_bytes;
  }
  const std::map<std::string, int> expected = {
      {"frame.clip_from_world", offsetof(FrameData, clip_from_world)},
      {"frame.eye_world", offsetof(FrameData, eye_world)},
      {"frame.light_center_world", offsetof(FrameData, light_center_world)},
      {"frame.light_tangent_world", offsetof(FrameData, light_tangent_world)},
      {"frame.light_bitangent_world", offsetof(FrameData, light_bitangent_world)},
      {"frame.light_direction_world", offsetof(FrameData, light_direction_world)},
      {"frame.light_extent", offsetof(FrameData, light_extent)},
      {"frame.light_type", offsetof(FrameData, light_type)},
      {"frame.screen_and_seed", offsetof(FrameData, screen_and_seed)},
      {"frame.receiver_plane_world", offsetof(FrameData, receiver_plane_world)},
      {"view.light_from_world", offsetof(LightViewData, light_from_world)},
      {"view.clip_from_light", offsetof(LightViewData, clip_from_light)},
      {"view.lateral_bounds", offsetof(LightViewData, lateral_bounds)},
      {"view.depth_range", offsetof(LightViewData, depth_range)},
      {"view.slice_world", offsetof(LightViewData, slice_world)}};
  EXPECT_EQ(offsets, expected);
  EXPECT_EQ(uniform_block_bytes(program, "FrameBlock"), static_cast<int>(sizeof(FrameData)));
  EXPECT_EQ(uniform_block_bytes(program, "ViewBlock"), static_cast<int>(sizeof(LightViewData)));
  EXPECT_EQ(uniform_block_bytes(program, "NoSuchBlock"), 0);
}

TEST_F(ProgramTest, OnlyTheSamplersInUseAreActive) {
  const fs::path file = write("samplers.frag",
                              "layout(binding = 0) uniform sampler2D read_me;\n"
                              "layout(binding = 1) uniform sampler2D forgotten;\n"
                              "layout(location = 0) out vec4 o;\n"
                              "void main() { o = texelFetch(read_me, ivec2(0), 0); }\n");
  EXPECT_THAT(active_uniforms(build(file)), ::testing::ElementsAre("read_me"));
}

}  // namespace
}  // namespace umbrameter
