// SPDX-License-Identifier: Apache-2.0
// Compute passes: what they store is what later passes find, in every frame again, and nothing is allocated for it then.

#include "realtime/inspect.h"
#include "tests/gpu/tried_technique.h"
#include "tests/support/procedural_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::FloatEq;
using testing::HasSubstr;

constexpr int kSidePx = 20;

Scene lamp_over_floor() {
  Scene scene;
  add_floor(scene, {40, 40});
  scene.camera = camera_above({0, 0, 0}, 2, 20);
  scene.lights.push_back(disk_light_above({0, 4, 0}, 0.05));
  finish_scene(scene);
  return scene;
}

std::string buffer(const std::string& name, const std::string& element, const std::string& count) {
  return "[[resource]]\nname = \"" + name + "\"\nkind = \"buffer\"\nelement = \"" + element +
         "\"\ncount = " + count + "\n";
}

std::string image(const std::string& name, const std::string& rest) {
  return "[[resource]]\nname = \"" + name + "\"\n" + rest + "\n";
}

/// A compute pass of the shader <id>.comp.
std::string compute(const std::string& id, const std::string& rest) {
  return "[[pass]]\nid = \"" + id + "\"\nkind = \"compute\"\ncompute = \"" + id + ".comp\"\n" + rest + "\n";
}

std::string show(const std::string& reads) {
  return "[[pass]]\nid = \"show\"\nkind = \"fullscreen\"\nfragment = \"show.frag\"\nwrites = "
         "[\"visibility\"]\nreads = [" +
         reads + "]\n";
}

class Compute : public TriedTechnique {
 protected:
  Compute() : TriedTechnique(lamp_over_floor(), kSidePx) {}

  void write(const std::string& body, const std::string& head = {}) {
    folder_.write("technique.toml", replaced(manifest_head(), "\"rect\", \"sun\"", "\"disk\"") + head + body);
  }

  std::vector<float> dumped(const std::string& resource, const std::string& channel) {
    SilentProgress progress;
    const Image held = dump_resource(*renderer_, scene_, request(), parse_resource_part(resource), progress);
    const auto plane = held.plane(channel);
    return {plane.begin(), plane.end()};
  }
};

TEST_F(Compute, CountsEveryPixelOnceInEveryFrame) {
  write(buffer("counts", "uvec2", "1") +
        compute("count",
                "groups = [\"ceil(screen.width / 8)\", \"ceil(screen.height / 8)\"]\nreads = "
                "[\"gbuffer.position\"]\nwrites = [\"counts\"]\nclear = [0]") +
        show("\"counts\""));
  shader("count.comp",
         "layout(local_size_x = 8, local_size_y = 8) in;\n"
         "void main() {\n"
         "  if (any(greaterThanEqual(ivec2(gl_GlobalInvocationID.xy), frame.screen_and_seed.xy))) return;\n"
         "  if (texelFetch(gbuffer_position, ivec2(gl_GlobalInvocationID.xy), 0).w == 1.0)\n"
         "    atomicAdd(counts[0].x, 1u);\n"
         "  atomicMax(counts[0].y, gl_GlobalInvocationID.x);\n}");
  shader("show.frag",
         "void main() { out_visibility = counts_count == 1 && counts[0] == uvec2(400u, 19u) ? 0.5 : 0.0; }");
  PreparedRun run = prepare();
  EXPECT_THAT(run.frame.image.plane("visibility"), Each(0.5f));
  EXPECT_THAT(run.passes, ElementsAre("count", "show"));
  EXPECT_EQ(run.frame.memory_bytes, 8u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(run.time_frame().size(), 2u);
  EXPECT_THAT(dumped("counts", "R"), ElementsAre(400.0f));
  EXPECT_THAT(dumped("counts", "G"), ElementsAre(19.0f));
}

TEST_F(Compute, ClearsToWhatEachKindOfElementHolds) {
  const std::string rest = "groups = [1]\nclear = [-2, 3]\nwrites = [\"whole\", \"real\", \"matrix\"]";
  write(buffer("whole", "ivec2", "2") + buffer("real", "float", "2") + buffer("matrix", "mat4", "1") +
        compute("fill", rest) + show("\"whole\", \"real\", \"matrix\""));
  shader("fill.comp", "layout(local_size_x = 1) in; void main() { real[1] = 0.25; }");
  shader("show.frag", "void main() { out_visibility = matrix[0][3][0] == -2.0 ? 0.5 : 0.0; }");
  EXPECT_THAT(visibility(), Each(0.5f));
  EXPECT_THAT(dumped("whole", "G"), ElementsAre(3.0f, 3.0f));
  EXPECT_THAT(dumped("real", "Y"), ElementsAre(-2.0f, 0.25f));
  EXPECT_THAT(dumped("matrix", "R"), Each(-2.0f));
  EXPECT_EQ(dumped("matrix", "A").size(), 4u);  // a pixel per column
}

TEST_F(Compute, StoresImagesOfAnyShapeAndLevel) {
  const std::string pyramid =
      image("pyramid", "format = \"rg32f\"\nwidth = 8\nheight = 8\nlevels = 2\nkind = \"array\"\nlayers = 3");
  write(pyramid + compute("fill", "groups = [1]\noverwrites = true\nwrites = [\"pyramid\"]") +
        compute("halve", "groups = [1]\nreads = [\"pyramid\"]\nwrites = [\"pyramid\"]\nwrite_level = 1") +
        show("\"pyramid\""));
  shader("fill.comp",
         "layout(local_size_x = 8, local_size_y = 8) in;\n"
         "void main() {\n"
         "  for (int layer = 0; layer < 3; ++layer)\n"
         "    imageStore(out_pyramid, ivec3(gl_LocalInvocationID.xy, layer), vec4(gl_LocalInvocationID.x, "
         "layer, 0, 0));\n}");
  shader("halve.comp",
         "layout(local_size_x = 4, local_size_y = 4) in;\n"
         "void main() {\n"
         "  for (int layer = 0; layer < 3; ++layer) {\n"
         "    vec4 sum = vec4(0.0);\n"
         "    for (int i = 0; i < 4; ++i)\n"
         "      sum += texelFetch(pyramid, ivec3(2 * ivec2(gl_LocalInvocationID.xy) + ivec2(i & 1, i >> 1), "
         "layer), 0);\n"
         "    imageStore(out_pyramid, ivec3(gl_LocalInvocationID.xy, layer), 0.25 * sum);\n  }\n}");
  shader("show.frag", "void main() { out_visibility = texelFetch(pyramid, ivec3(3, 0, 2), 1).y * 0.25; }");
  EXPECT_THAT(visibility(), Each(0.5f));
  EXPECT_THAT(dumped("pyramid:2:1", "R"), ElementsAre(0.5f, 2.5f, 4.5f, 6.5f, 0.5f, 2.5f, 4.5f, 6.5f, 0.5f,
                                                      2.5f, 4.5f, 6.5f, 0.5f, 2.5f, 4.5f, 6.5f));
}

TEST_F(Compute, MayAnswerItself) {
  write(compute("answer",
                "groups = [\"screen.width\", \"screen.height\"]\noverwrites = true\nwrites = "
                "[\"visibility\"]"));
  shader("answer.comp",
         "layout(local_size_x = 1) in;\n"
         "void main() { imageStore(out_visibility, ivec2(gl_WorkGroupID.xy), vec4(0.75)); }");
  EXPECT_THAT(visibility(), Each(0.75f));
}

TEST_F(Compute, LoopsSeeWhatTheirLastRoundStored) {
  // Doubling sums: a prefix sum of eight ones, each round over what the one before it left.
  const std::string loop =
      "[[pass]]\nid = \"rounds\"\nkind = \"loop\"\nvariable = \"i\"\ncount = 3\n[[pass.pass]]\nid = "
      "\"sum\"\nkind = \"compute\"\ncompute = \"sum.comp\"\ngroups = [1]\nwrites = [\"sums\"]\ntimer = "
      "\"scan\"\n[[pass.pass]]\nid = \"copy\"\nkind = \"compute\"\ncompute = \"copy.comp\"\ngroups = "
      "[1]\nreads "
      "= [\"sums\"]\nwrites = [\"last\"]\noverwrites = true\ntimer = \"scan\"\n";
  write(buffer("sums", "int", "8") + buffer("last", "int", "8") +
        compute("begin", "groups = [1]\noverwrites = true\nwrites = [\"sums\", \"last\"]\ntimer = \"scan\"") +
        loop + show("\"last\""));
  shader("begin.comp",
         "layout(local_size_x = 8) in;\n"
         "void main() { sums[gl_LocalInvocationIndex] = 1; last[gl_LocalInvocationIndex] = 1; }");
  shader("sum.comp",
         "layout(local_size_x = 8) in;\n"
         "void main() {\n"
         "  int k = int(gl_LocalInvocationIndex);\n"
         "  int below = k >= (1 << i) ? sums[k - (1 << i)] : 0;\n"
         "  barrier();\n"
         "  sums[k] += below;\n}");
  shader("copy.comp",
         "layout(local_size_x = 8) in;\n"
         "void main() { last[gl_LocalInvocationIndex] = sums[gl_LocalInvocationIndex]; }");
  shader("show.frag", "void main() { out_visibility = float(last[7]) * 0.0625; }");
  const PreparedRun run = prepare();
  EXPECT_THAT(run.frame.image.plane("visibility"), Each(0.5f));
  EXPECT_THAT(run.passes, ElementsAre("scan", "show"));
  EXPECT_THAT(dumped("last", "Y"), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
}

TEST_F(Compute, OnceAndConditionsHoldAsForOtherPasses) {
  const std::string off =
      "\n[[parameter]]\nname = \"on\"\ntype = \"boolean\"\ndefault = true\nstage = "
      "\"host\"\ndoc = \"On.\"\n";
  write(off + buffer("table", "float", "4") + buffer("other", "float", "4") +
        compute("fill", "groups = [1]\nonce = true\noverwrites = true\nwrites = [\"table\"]") +
        compute("more",
                "groups = [1]\ncondition = \"on\"\nreads = [\"table\"]\nwrites = [\"other\"]\nclear = [0]") +
        show("\"table\", \"other\""));
  shader("fill.comp",
         "layout(local_size_x = 4) in;\n"
         "void main() { table[gl_LocalInvocationIndex] = 0.125 * float(gl_LocalInvocationIndex); }");
  shader("more.comp", "layout(local_size_x = 1) in;\nvoid main() { other[0] = 2.0 * table[1]; }");
  shader("show.frag", "void main() { out_visibility = table[2] + other[0]; }");
  PreparedRun run = prepare();
  EXPECT_THAT(run.passes, ElementsAre("more", "show"));
  EXPECT_EQ(run.time_frame().size(), 2u);
  EXPECT_THAT(visibility(), Each(0.5f));
  EXPECT_THAT(visibility({{"on", false}}), Each(0.25f));  // zeros until something is stored
}

TEST_F(Compute, HistoryOfABufferIsOfTheFrameBefore) {
  write(buffer("count", "uint", "1") +
            compute("add",
                    "groups = [1]\noverwrites = true\nreads = [\"previous.count\"]\nwrites = [\"count\"]") +
            show("\"count\""),
        "frames_before = 3\n");
  shader("add.comp", "layout(local_size_x = 1) in;\nvoid main() { count[0] = previous_count[0] + 1u; }");
  shader("show.frag", "void main() { out_visibility = 0.125 * float(count[0]); }");
  PreparedRun run = prepare();
  EXPECT_THAT(run.frame.image.plane("visibility"), Each(0.5f));
  run.time_frame();
  EXPECT_THAT(dumped("count", "Y"), ElementsAre(4.0f));
  EXPECT_EQ(run.frame.memory_bytes, 8u);
}

TEST_F(Compute, VertexShadersReadBuffersToo) {
  write(buffer("shift", "vec4", "1") + image("map", "format = \"depth32f\"\nwidth = 8\nheight = 8") +
        compute("fill", "groups = [1]\noverwrites = true\nwrites = [\"shift\"]") +
        "[[pass]]\nid = \"map\"\nkind = \"scene\"\nvertex = \"map.vert\"\nreads = [\"shift\"]\nwrites = "
        "[\"map\"]\nclear = [0]\n" +
        show("\"map\""));
  shader("fill.comp", "layout(local_size_x = 1) in;\nvoid main() { shift[0] = vec4(0.0, 0.0, 0.25, 1.0); }");
  shader("map.vert",
         "layout(location = 0) in vec3 p_world;\n"
         "void main() { gl_Position = vec4(p_world.xz, 0.0, 0.0) + shift[0]; }");
  shader("show.frag", "void main() { out_visibility = texelFetch(map, ivec2(4), 0).r; }");
  EXPECT_THAT(visibility(), Each(FloatEq(0.25f)));
}

TEST_F(Compute, WhatADeviceCannotRunIsAnErrorAtItsLine) {
  const auto body = [](const std::string& groups, const std::string& count) {
    return buffer("counts", "uint", count) +
           compute("count", "groups = [" + groups + "]\nwrites = [\"counts\"]\nclear = [0]") +
           show("\"counts\"");
  };
  shader("count.comp", "layout(local_size_x = 1) in;\nvoid main() { atomicAdd(counts[0], 1u); }");
  shader("show.frag", "void main() { out_visibility = float(counts[0]); }");
  write(body("1, \"4294967296\"", "1"));
  EXPECT_THAT(error_of(),
              AllOf(HasSubstr("technique.toml:"), HasSubstr("groups of pass 'count' along y = '4294967296'"),
                    HasSubstr("it must be from 1 to ")));
  write(body("\"screen.width - 20\"", "1"));
  EXPECT_THAT(error_of(), HasSubstr("groups of pass 'count' along x = 'screen.width - 20' is 0"));
  write(body("\"screen.width / 16\"", "1"));
  EXPECT_THAT(error_of(), HasSubstr("ceil()"));
  write(body("1", "\"1024 * 1024 * 1024 * 1024\""));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("count of buffer 'counts'"), HasSubstr("it must be from 1 to ")));
  write(body("1", "1"));
  shader("count.comp", "layout(local_size_x = 1000000) in;\nvoid main() { atomicAdd(counts[0], 1u); }");
  EXPECT_THAT(error_of(), AllOf(HasSubstr("count.comp"), HasSubstr("local_size_x")));
  shader("count.comp", "void main() { atomicAdd(counts[0], 1u); }");
  EXPECT_THAT(error_of(), AllOf(HasSubstr("count.comp"), HasSubstr("local")));
}

TEST_F(Compute, WhatOverwritesReadsNothingOfIt) {
  write(buffer("counts", "uint", "1") +
        compute("count", "groups = [1]\nwrites = [\"counts\"]\noverwrites = true") + show("\"counts\""));
  shader("count.comp", "layout(local_size_x = 1) in;\nvoid main() { counts[0] = counts[0] + 1u; }");
  shader("show.frag", "void main() { out_visibility = float(counts[0]); }");
  EXPECT_THAT(error_of(), AllOf(HasSubstr("count.comp"), HasSubstr("write-only"), HasSubstr("counts")));
}

TEST_F(Compute, WhoReadsABufferCannotChangeIt) {
  write(buffer("counts", "uint", "1") + compute("count", "groups = [1]\nwrites = [\"counts\"]\nclear = [0]") +
        show("\"counts\""));
  shader("count.comp", "layout(local_size_x = 1) in;\nvoid main() { atomicAdd(counts[0], 1u); }");
  shader("show.frag", "void main() { counts[0] = 2u; out_visibility = 0.0; }");
  EXPECT_THAT(error_of(), AllOf(HasSubstr("show.frag:1"), HasSubstr("counts")));
}

TEST_F(Compute, BuffersHaveNeitherLayersNorLevels) {
  write(buffer("counts", "uint", "1") + compute("count", "groups = [1]\nwrites = [\"counts\"]\nclear = [0]") +
        show("\"counts\""));
  shader("count.comp", "layout(local_size_x = 1) in;\nvoid main() { atomicAdd(counts[0], 1u); }");
  shader("show.frag", "void main() { out_visibility = float(counts[0]); }");
  EXPECT_THAT([&] { dumped("counts:1", "Y"); },
              testing::ThrowsMessage<Error>(HasSubstr("buffer 'counts' has no layer 1")));
}

}  // namespace
}  // namespace umbrameter
