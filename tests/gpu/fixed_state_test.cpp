// SPDX-License-Identifier: Apache-2.0
// Fixed-function state of passes, and draws whose vertices pull their triangles: what each key does to the texels.

#include "tests/gpu/tried_technique.h"
#include "tests/support/procedural_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::Each;
using testing::FloatNear;
using testing::HasSubstr;

constexpr int kSidePx = 8;

/// A floor at y = 0 and a smaller one at y = 1 over all that the camera sees, from a sun overhead.
Scene two_floors() {
  Scene scene;
  add_floor(scene, {8, 8});
  add_floor(scene, {6, 6}, 1.0);
  scene.camera = camera_above({0, 0, 0}, 2, 20);
  scene.lights.push_back(sun_light({0, 1, 0}, 0.01));
  finish_scene(scene);
  return scene;
}

std::string resource(const std::string& name, const std::string& format, const std::string& more = {}) {
  return "[[resource]]\nname = \"" + name + "\"\nformat = \"" + format + "\"\n" +
         (more.empty() ? "width = \"screen.width\"\nheight = \"screen.height\"\n" : more);
}

std::string full(const std::string& id, const std::string& reads, const std::string& writes,
                 const std::string& more = {}) {
  return "[[pass]]\nid = \"" + id + "\"\nkind = \"fullscreen\"\nfragment = \"" + id + ".frag\"\nreads = [" +
         reads + "]\nwrites = [" + writes + "]\n" + more;
}

class FixedState : public TriedTechnique {
 protected:
  FixedState() : TriedTechnique(two_floors(), kSidePx) {}

  void SetUp() override {
    TriedTechnique::SetUp();
    shader("one.frag", "void main() { out_visibility = 1.0; }");
    shader("half.frag", "void main() { out_visibility = 0.5; }");
    shader("zero.frag", "void main() { out_visibility = 0.0; }");
    shader("camera.vert",
           "layout(location = 0) in vec3 p_world;\n"
           "void main() { gl_Position = frame.clip_from_world * vec4(p_world, 1.0); }");
    shader("depth.frag",
           "void main() { gl_FragDepth = texelFetch(gbuffer_depth, ivec2(gl_FragCoord.xy), 0).r; }");
  }

  void write(const std::string& body) {
    folder_.write("technique.toml", replaced(manifest_head(), "\"rect\", \"sun\"", "\"sun\"") + body);
  }
};

/// Draws all triangles from the camera into `count`'s stencil, under its depth.
std::string count_pass(const std::string& more) {
  return "[[pass]]\nid = \"count\"\nkind = \"scene\"\nvertex = \"camera.vert\"\nwrites = [\"count\"]\n" +
         more;
}

TEST_F(FixedState, StencilsCountWhatPassesAndWhatFails) {
  const auto lit_where = [&](const std::string& stencil, int count) {
    write(resource("count", "depth32f_stencil8") +
          full("depth", "\"gbuffer.depth\"", "\"count\"", "clear_stencil = 3\n") +
          count_pass("depth_write = false\ndepth_test = \"greater_or_equal\"\n[pass.stencil]\n" + stencil) +
          full("zero", "", "\"visibility\"") +
          full("one", "", "\"visibility\", \"count\"",
               "depth_write = false\n[pass.stencil]\ntest = \"equal\"\nreference = " + std::to_string(count) +
                   "\n"));
    return visibility();
  };
  // Two layers: the upper one is what the camera sees, the lower one fails.
  EXPECT_THAT(lit_where("front = [\"keep\", \"keep\", \"increment\"]\n", 4), Each(1.0f));
  EXPECT_THAT(lit_where("front = [\"keep\", \"increment\", \"keep\"]\n", 4), Each(1.0f));
  EXPECT_THAT(lit_where("front = [\"keep\", \"decrement\", \"decrement\"]\n", 1), Each(1.0f));
  EXPECT_THAT(lit_where("front = [\"keep\", \"decrement\", \"decrement\"]\n", 3), Each(0.0f));
  // Both floors face the camera: nothing is seen from behind.
  EXPECT_THAT(lit_where("front = [\"keep\", \"keep\", \"keep\"]\nback = [\"keep\", \"zero\", \"zero\"]\n", 3),
              Each(1.0f));
  EXPECT_THAT(lit_where("test = \"less\"\nreference = 9\nfront = [\"zero\", \"keep\", \"keep\"]\n", 0),
              Each(1.0f));
  EXPECT_THAT(lit_where("mask = 12\nfront = [\"keep\", \"invert\", \"invert\"]\n", 3), Each(1.0f));
  EXPECT_THAT(lit_where("mask = 12\nfront = [\"keep\", \"keep\", \"invert\"]\n", 15), Each(1.0f));
}

TEST_F(FixedState, TestsOfDepthChooseTheLayer) {
  const auto height_seen = [&](const std::string& test, const std::string& clear) {
    write(resource("map", "depth32f", "width = 16\nheight = 16\n") +
          "[[view]]\nname = \"light\"\nfit = \"scene\"\nsize = 16\n"
          "[[pass]]\nid = \"map\"\nkind = \"scene\"\nview = \"light\"\nwrites = [\"map\"]\ndepth_test = \"" +
          test + "\"\nclear = [" + clear + "]\n" +
          full("show", "\"map\"", "\"visibility\"", "views = [\"light\"]\n"));
    shader("show.frag",
           "#include \"spaces.glsl\"\nvoid main() {\n"
           "  float near = distance_of_depth(view_light, texelFetch(map, ivec2(8), 0).r);\n"
           "  out_visibility = view_light.depth_range.y - near > 0.5 ? 1.0 : 0.25;\n}");
    return visibility();
  };
  EXPECT_THAT(height_seen("greater", "0.0"), Each(1.0f));  // the nearest: the upper floor
  EXPECT_THAT(height_seen("less", "1.0"), Each(0.25f));    // the farthest
}

TEST_F(FixedState, FactorsMultiplyAndChannelsStay) {
  write(full("half", "", "\"visibility\"") +
        replaced(full("half", "", "\"visibility\"",
                      "blend = \"add\"\nblend_factors = [\"zero\", \"source_color\"]\n"),
                 "id = \"half\"", "id = \"times\""));
  shader("times.frag", "void main() { out_visibility = 0.5; }");
  EXPECT_THAT(visibility(), Each(0.25f));
  write(full("half", "", "\"visibility\"") +
        full("one", "", "\"visibility\"",
             "blend = \"add\"\nblend_factors = [\"one_minus_target_color\", \"one\"]\n"));
  EXPECT_THAT(visibility(), Each(1.0f));
  write(resource("mixed", "rgba8") + full("fill", "", "\"mixed\"") +
        full("over", "", "\"mixed\"", "write_channels = \"gb\"\n") +
        full("show", "\"mixed\"", "\"visibility\""));
  shader("fill.frag", "void main() { out_mixed = vec4(1.0, 0.0, 0.0, 1.0); }");
  shader("over.frag", "void main() { out_mixed = vec4(0.0, 1.0, 0.0, 0.0); }");
  shader("show.frag",
         "void main() { out_visibility = texelFetch(mixed, ivec2(0), 0) == vec4(1.0, 1.0, 0.0, 1.0) ? 1.0 : "
         "0.0; }");
  EXPECT_THAT(visibility(), Each(1.0f));
}

// A slope's depth covers the same part of its range a texel everywhere: a factor of 2 pushes it by 2 texels' worth.
TEST_F(FixedState, PolygonOffsetsPushSlopes) {
  scene_.lights = {sun_light({1, 1, 0}, 0.01)};
  finish_scene(scene_);
  const auto body = [](const std::string& factor) {
    return resource("plain", "depth32f", "width = 64\nheight = 64\n") +
           resource("pushed", "depth32f", "width = 64\nheight = 64\n") +
           "[[view]]\nname = \"light\"\nfit = \"scene\"\nsize = 64\n"
           "[[pass]]\nid = \"plain\"\nkind = \"scene\"\nview = \"light\"\nwrites = [\"plain\"]\nclear = [0]\n"
           "[[pass]]\nid = \"pushed\"\nkind = \"scene\"\nview = \"light\"\nwrites = [\"pushed\"]\nclear = "
           "[0]\n"
           "polygon_offset = [" +
           factor + ", 0]\n" + full("show", "\"plain\", \"pushed\"", "\"visibility\"");
  };
  shader("show.frag",
         "void main() {\n"
         "  float at = texelFetch(plain, ivec2(32), 0).r;\n"
         "  vec2 next = vec2(texelFetch(plain, ivec2(33, 32), 0).r, texelFetch(plain, ivec2(32, 33), 0).r);\n"
         "  vec2 step = abs(next - at);\n"
         "  out_visibility = 0.1 * (at - texelFetch(pushed, ivec2(32), 0).r) / max(step.x, step.y);\n}");
  write(body("-2"));
  EXPECT_THAT(visibility(), Each(FloatNear(0.2f, 2e-3f)));
  write(body("\"-2 - 3\""));
  EXPECT_THAT(visibility(), Each(FloatNear(0.5f, 5e-3f)));
}

TEST_F(FixedState, VerticesPullTheTriangleTheyBelongTo) {
  write(resource("map", "depth32f", "width = 32\nheight = 32\n") +
        resource("pulled", "depth32f", "width = 32\nheight = 32\n") +
        "[[view]]\nname = \"light\"\nfit = \"scene\"\nsize = 32\n"
        "[[pass]]\nid = \"map\"\nkind = \"scene\"\nview = \"light\"\nwrites = [\"map\"]\nclear = [0]\n"
        "[[pass]]\nid = \"pulled\"\nkind = \"scene\"\nview = \"light\"\nvertex = \"pulled.vert\"\nvertices = "
        "6\n"
        "writes = [\"pulled\"]\nclear = [0]\n" +
        full("show", "\"map\", \"pulled\"", "\"visibility\""));
  // Twice each triangle, the second time below all others.
  shader("pulled.vert",
         "#include \"pulled_triangle.glsl\"\nvoid main() {\n"
         "  PulledTriangle t = pulled_triangle();\n"
         "  vec3 corners[3] = vec3[](t.a_world, t.b_world, t.c_world);\n"
         "  vec3 p = corners[pulled_vertex() % 3] - vec3(0.0, pulled_vertex() < 3 ? 0.0 : 0.25, 0.0);\n"
         "  gl_Position = VIEW.clip_from_light * (VIEW.light_from_world * vec4(p, 1.0));\n}");
  shader(
      "show.frag",
      "void main() {\n"
      "  int equal = 0;\n"
      "  for (int i = 0; i < 1024; ++i) {\n"
      "    ivec2 texel = ivec2(i % 32, i / 32);\n"
      "    equal += abs(texelFetch(map, texel, 0).r - texelFetch(pulled, texel, 0).r) < 1e-6 ? 1 : 0;\n  }\n"
      "  out_visibility = float(equal) / 1024.0;\n}");
  EXPECT_THAT(visibility(), Each(1.0f));
}

TEST_F(FixedState, WhatDoesNotGoTogetherIsSaid) {
  const auto error_with = [&](const std::string& more, const std::string& format = "depth32f") {
    write(resource("count", format) + full("depth", "\"gbuffer.depth\"", "\"count\"") + count_pass(more) +
          full("zero", "\"count\"", "\"visibility\""));
    return error_of();
  };
  EXPECT_THAT(error_with("[pass.stencil]\ntest = \"equal\"\n"),
              AllOf(HasSubstr("writes no format that has one"), HasSubstr("depth32f_stencil8")));
  EXPECT_THAT(error_with("[pass.stencil]\ntest = \"equall\"\n", "depth24_stencil8"), HasSubstr("'equal'"));
  EXPECT_THAT(error_with("[pass.stencil]\nfront = [\"keep\"]\n", "depth24_stencil8"),
              HasSubstr("has 1 entries"));
  EXPECT_THAT(error_with("[pass.stencil]\nreference = 256\n", "depth24_stencil8"), HasSubstr("0 to 255"));
  EXPECT_THAT(error_with("write_channels = \"rx\"\n"), HasSubstr("'x' is no channel"));
  EXPECT_THAT(error_with("blend_factors = [\"one\", \"zero\"]\n"), HasSubstr("only blend = \"add\" takes"));
  EXPECT_THAT(error_with("vertices = 0\n"), HasSubstr("it must be from 1"));
  write(full("zero", "", "\"visibility\"") + full("one", "", "\"visibility\"", "depth_test = \"equal\"\n"));
  EXPECT_THAT(error_of(), HasSubstr("says how depth is tested, but writes none"));
  write(full("zero", "", "\"visibility\"", "depth_test = \"equal\"\n"));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("before anything is in it"), HasSubstr("'clear'")));
  write(full("zero", "", "\"visibility\"", "polygon_offset = [1, 1]\n"));
  EXPECT_THAT(error_of(), HasSubstr("only scene passes"));
}

}  // namespace
}  // namespace umbrameter
