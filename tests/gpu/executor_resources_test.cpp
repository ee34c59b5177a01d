// SPDX-License-Identifier: Apache-2.0
// Levels, samples, passes that run once, fullscreen depth, clip distances and stage switches: each is visible in a
// picture here, so a manifest cannot promise what GL does not do.

#include "core/files.h"
#include "tests/gpu/tried_technique.h"
#include "tests/support/procedural_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::Each;
using testing::FloatNear;
using testing::HasSubstr;

constexpr int kSidePx = 16;

std::string resource(const std::string& name, const std::string& format, const std::string& rest) {
  return "[[resource]]\nname = \"" + name + "\"\nformat = \"" + format + "\"\n" + rest + "\n";
}

std::string pass(const std::string& id, const std::string& kind, const std::string& rest) {
  return "[[pass]]\nid = \"" + id + "\"\nkind = \"" + kind + "\"\n" + rest + "\n";
}

std::string show(const std::string& read) {
  return pass("show", "fullscreen",
              "fragment = \"show.frag\"\nreads = [\"" + read + "\"]\nwrites = [\"visibility\"]");
}

/// One slanted triangle seen from a rect light above, and a camera that sees all of it.
Scene slanted_triangle() {
  Scene scene;
  scene.positions_world = {{-1, 0, -1}, {1, 0, -0.9f}, {-0.9f, 0, 1}};
  scene.triangles = {{0, 2, 1}};
  scene.camera = camera_above({0, 0, 0}, 3, 20);
  scene.lights.push_back(rect_light_above({0, 4, 0}, {0.2, 0.2}));
  finish_scene(scene);
  return scene;
}

class ExecutorResources : public TriedTechnique {
 protected:
  ExecutorResources() : TriedTechnique(slanted_triangle(), kSidePx) {}

  void write(const std::string& body) { folder_.write("technique.toml", manifest_head() + body); }

  Frame render(const ParameterValues& parameters = {}) override { return prepare(parameters).frame; }
};

constexpr std::string_view kColumns = "void main() { out_chain = floor(gl_FragCoord.x) / 8.0; }";

TEST_F(ExecutorResources, MipmapPassAveragesDownToOneTexel) {
  write(resource("chain", "r32f", "width = 8\nheight = 8\nlevels = 4\nfilter = \"mipmap\"") +
        pass("fill", "fullscreen", "fragment = \"fill.frag\"\nwrites = [\"chain\"]") +
        pass("levels", "mipmap", "writes = [\"chain\"]") + show("chain"));
  shader("fill.frag", std::string(kColumns));
  shader("show.frag", "void main() { out_visibility = texelFetch(chain, ivec2(0), 3).r; }");
  EXPECT_THAT(visibility(), Each(FloatNear(3.5f / 8.0f, 1e-6f)));
  EXPECT_EQ(render().memory_bytes, (64u + 16u + 4u + 1u) * 4u);
}

TEST_F(ExecutorResources, LoopReducesLevelByLevelWithItsOwnRule) {
  write(resource("chain", "r32f", "width = 8\nheight = 8\nlevels = 4") +
        pass("fill", "fullscreen", "fragment = \"fill.frag\"\nwrites = [\"chain\"]") +
        "[[pass]]\nid = \"reduce\"\nkind = \"loop\"\nvariable = \"i\"\ncount = 3\n"
        "[[pass.pass]]\nid = \"halve\"\nkind = \"fullscreen\"\nfragment = \"halve.frag\"\n"
        "reads = [\"chain\"]\nwrites = [\"chain\"]\nwrite_level = \"i + 1\"\n" +
        show("chain"));
  shader("fill.frag", std::string(kColumns));
  shader("halve.frag",
         "void main() {\n  ivec2 p = 2 * ivec2(gl_FragCoord.xy);\n"
         "  out_chain = max(texelFetch(chain, p, 0).r, texelFetch(chain, p + ivec2(1, 0), 0).r);\n}");
  shader("show.frag", "void main() { out_visibility = texelFetch(chain, ivec2(0), 3).r; }");
  EXPECT_THAT(visibility(), Each(7.0f / 8.0f));
}

TEST_F(ExecutorResources, LevelsThatDoNotExistAreSentences) {
  const std::string body = resource("chain", "r32f", "width = 8\nheight = 8\nlevels = 5") +
                           pass("fill", "fullscreen", "fragment = \"fill.frag\"\nwrites = [\"chain\"]") +
                           show("chain");
  write(body);
  shader("fill.frag", std::string(kColumns));
  shader("show.frag", "void main() { out_visibility = texelFetch(chain, ivec2(0), 0).r; }");
  EXPECT_THAT(error_of(), AllOf(HasSubstr("cannot have 5 levels"), HasSubstr("1 to 4")));
  write(replaced(replaced(body, "levels = 5", "levels = 2"), "writes = [\"chain\"]",
                 "writes = [\"chain\"]\nwrite_level = 2"));
  EXPECT_THAT(error_of(), HasSubstr("writes level 2 of 'chain', which has 2"));
}

TEST_F(ExecutorResources, SamplesResolveToTheShareThatIsCovered) {
  const std::string body =
      "[[view]]\nname = \"light\"\nfit = \"scene\"\nsize = 8\n" +
      resource("cover", "r32f", "width = 8\nheight = 8\nsamples = SAMPLES") +
      pass("draw", "scene", "view = \"light\"\nfragment = \"draw.frag\"\nwrites = [\"cover\"]\nclear = [0]") +
      show("cover");
  shader("draw.frag", "void main() { out_cover = 1.0; }");
  shader("show.frag", "void main() { out_visibility = texelFetch(cover, ivec2(gl_FragCoord.xy) / 2, 0).r; }");
  const auto is_between = [](float v) { return v > 0.01f && v < 0.99f; };
  write(replaced(body, "SAMPLES", "1"));
  EXPECT_FALSE(std::ranges::any_of(visibility(), is_between));
  write(replaced(body, "SAMPLES", "4"));
  EXPECT_TRUE(std::ranges::any_of(visibility(), is_between));
  EXPECT_EQ(render().memory_bytes, 64u * 4u * 5u);
  write(replaced(body, "SAMPLES", "63"));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("63 samples"), HasSubstr("this device takes")));
}

TEST_F(ExecutorResources, WhatRunsOnceIsThereAndCostsNoTime) {
  write(resource("table", "r32f", "width = 4\nheight = 1") +
        pass("fill", "fullscreen", "fragment = \"fill.frag\"\nwrites = [\"table\"]\nonce = true") +
        show("table"));
  shader("fill.frag", "void main() { out_table = 0.25 * floor(gl_FragCoord.x); }");
  shader("show.frag", "void main() { out_visibility = texelFetch(table, ivec2(3, 0), 0).r; }");
  EXPECT_THAT(visibility(), Each(0.75f));
  const PreparedRun run = prepare();
  EXPECT_EQ(run.passes, std::vector<std::string>{"show"});
  EXPECT_EQ(run.time_frame().size(), 1u);
}

TEST_F(ExecutorResources, WhatDependsOnTheFrameCannotRunOnce) {
  write(resource("table", "r32f", "width = 4\nheight = 1") +
        pass("fill", "fullscreen",
             "fragment = \"fill.frag\"\nreads = [\"gbuffer.normal\"]\nwrites = [\"table\"]\nonce = true") +
        show("table"));
  shader("fill.frag", "void main() { out_table = texelFetch(gbuffer_normal, ivec2(0), 0).r; }");
  shader("show.frag", "void main() { out_visibility = texelFetch(table, ivec2(3, 0), 0).r; }");
  EXPECT_THAT(error_of(), HasSubstr("runs once but reads 'gbuffer.normal'"));
}

TEST_F(ExecutorResources, FullscreenPassMayFillADepthResource) {
  write(resource("depths", "depth32f", "width = 4\nheight = 4") +
        pass("fill", "fullscreen", "fragment = \"fill.frag\"\nwrites = [\"depths\"]") + show("depths"));
  shader("fill.frag", "void main() { gl_FragDepth = 0.125; }");
  shader("show.frag", "void main() { out_visibility = texelFetch(depths, ivec2(2), 0).r; }");
  EXPECT_THAT(visibility(), Each(0.125f));
}

TEST_F(ExecutorResources, ClipDistancesCutTheScene) {
  write(resource("cover", "r32f", "width = \"screen.width\"\nheight = \"screen.height\"") +
        pass("draw", "scene",
             "vertex = \"draw.vert\"\nfragment = \"draw.frag\"\nwrites = [\"cover\"]\nclear = [0]\n"
             "clip_distances = 1") +
        show("cover"));
  shader("draw.frag", "void main() { out_cover = 1.0; }");
  shader("show.frag", "void main() { out_visibility = texelFetch(cover, ivec2(gl_FragCoord.xy), 0).r; }");
  const auto covered_with = [&](const std::string& distance) {
    shader("draw.vert",
           "layout(location = 0) in vec3 p_world;\nvoid main() {\n"
           "  gl_Position = frame.clip_from_world * vec4(p_world, 1.0);\n  gl_ClipDistance[0] = " +
               distance + ";\n}");
    const auto v = visibility();
    return std::accumulate(v.begin(), v.end(), 0.0f);
  };
  const float whole = covered_with("1.0");
  EXPECT_NEAR(covered_with("-p_world.x") + covered_with("p_world.x"), whole, 1.0f);
  EXPECT_GT(covered_with("-p_world.x"), covered_with("p_world.x")) << "the triangle leans to -x";
  EXPECT_EQ(covered_with("-1.0"), 0.0f);
}

TEST_F(ExecutorResources, StageSwitchChangesNoPixel) {
  write(
      "[[parameter]]\nname = \"taps\"\ntype = \"integer\"\ndefault = 5\nmin = 1\nmax = 9\nstage = "
      "\"define\"\n"
      "doc = \"x\"\n[[parameter]]\nname = \"gain\"\ntype = \"real\"\ndefault = 0.1\nmin = 0\nmax = 1\n"
      "stage = \"uniform\"\ndoc = \"x\"\n" +
      pass("all", "fullscreen", "fragment = \"all.frag\"\nwrites = [\"visibility\"]"));
  shader("all.frag",
         "void main() {\n  float sum = 0.0;\n  for (int i = 0; i < TAPS; ++i) sum += gain;\n"
         "  out_visibility = sum;\n}");
  const ParameterValues dynamic{{"stage.taps", std::string("uniform")}, {"taps", int64_t{7}}};
  EXPECT_EQ(visibility(dynamic), visibility({{"taps", int64_t{7}}}));
  EXPECT_EQ(to_text(render(dynamic).parameters.at("stage.taps")), "uniform");
  EXPECT_THAT(error_of({{"stage.gain", std::string("uniform")}}), HasSubstr("cannot be switched"));
  EXPECT_THAT(error_of({{"stage.tap", std::string("uniform")}}), HasSubstr("'taps'"));
  EXPECT_THAT(error_of({{"stage.taps", std::string("host")}}), HasSubstr("define or uniform"));
}

}  // namespace
}  // namespace umbrameter
