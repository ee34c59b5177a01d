// SPDX-License-Identifier: Apache-2.0
// Arrays, cubes and families of views: each layer holds what its pass drew, and samplers of every kind find it there.

#include "core/files.h"
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

/// A floor under a lamp at (0, 1, 0), and a camera above it.
Scene lamp_over_floor() {
  Scene scene;
  add_floor(scene, {4, 4});
  scene.camera = camera_above({0, 0, 0}, 2, 20);
  scene.lights.push_back(sphere_light({0, 1, 0}, 0.05));
  finish_scene(scene);
  return scene;
}

std::string resource(const std::string& name, const std::string& rest) {
  return "[[resource]]\nname = \"" + name + "\"\n" + rest + "\n";
}

std::string show(const std::string& rest) {
  return "[[pass]]\nid = \"show\"\nkind = \"fullscreen\"\nfragment = \"show.frag\"\nwrites = "
         "[\"visibility\"]\n" +
         rest;
}

/// Writes every layer of `name` in a loop over `i`.
std::string fill(const std::string& name, int count) {
  return "[[pass]]\nid = \"layers\"\nkind = \"loop\"\nvariable = \"i\"\ncount = " + std::to_string(count) +
         "\n[[pass.pass]]\nid = \"fill\"\nkind = \"fullscreen\"\nfragment = \"fill.frag\"\nwrites = [\"" +
         name + "\"]\nwrite_layer = \"i\"\n";
}

class ExecutorLayers : public TriedTechnique {
 protected:
  ExecutorLayers() : TriedTechnique(lamp_over_floor(), kSidePx) {}

  void write(const std::string& body, const std::string& lights = "\"sphere\"") {
    folder_.write("technique.toml", replaced(manifest_head(), "\"rect\", \"sun\"", lights) + body);
  }
};

TEST_F(ExecutorLayers, LayersOfAnArrayHoldWhatWasWrittenToEach) {
  const std::string body =
      resource("stack", "kind = \"array\"\nformat = \"r32f\"\nwidth = 4\nheight = 2\nlayers = 3") +
      fill("stack", 3) + show("reads = [\"stack\"]");
  write(body);
  shader("fill.frag", "void main() { out_stack = 0.25 * float(i + 1); }");
  shader(
      "show.frag",
      "void main() {\n"
      "  vec3 of = vec3(texelFetch(stack, ivec3(0, 0, 0), 0).r, texelFetch(stack, ivec3(3, 1, 1), 0).r,\n"
      "                 texelFetch(stack, ivec3(1, 1, 2), 0).r);\n"
      "  bool right = of == vec3(0.25, 0.5, 0.75) && stack_layers == 3 && stack_size.xy == vec2(4.0, 2.0);\n"
      "  out_visibility = right ? 1.0 : 0.0;\n}");
  EXPECT_THAT(visibility(), Each(1.0f));
  EXPECT_EQ(render().memory_bytes, 4u * 2u * 3u * 4u);
  write(replaced(body, "layers = 3", "layers = 2"));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("writes layer 2 of 'stack', which has 2"), HasSubstr("from 0")));
  write(replaced(body, "layers = 3", "layers = 3\nsamples = 4"));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("has layers and 4 samples"), HasSubstr("2d")));
}

TEST_F(ExecutorLayers, LevelsOfEveryLayerAreReducedFromTheOneBelow) {
  write(
      resource("stack",
               "kind = \"array\"\nformat = \"r32f\"\nwidth = 2\nheight = 2\nlayers = 2\nlevels = 2") +
      fill("stack", 2) +
      "[[pass]]\nid = \"reduce\"\nkind = \"loop\"\nvariable = \"k\"\ncount = 2\n"
      "[[pass.pass]]\nid = \"halve\"\nkind = \"fullscreen\"\nfragment = \"halve.frag\"\nreads = [\"stack\"]\n"
      "writes = [\"stack\"]\nwrite_level = 1\nwrite_layer = \"k\"\n" +
      show("reads = [\"stack\"]"));
  shader("fill.frag", "void main() { out_stack = floor(gl_FragCoord.x) + 0.25 * float(i); }");
  shader("halve.frag", "void main() { out_stack = 0.5 * texelFetch(stack, ivec3(1, 0, k), 0).r; }");
  shader("show.frag", "void main() { out_visibility = texelFetch(stack, ivec3(0, 0, 1), 1).r; }");
  EXPECT_THAT(visibility(), Each(0.625f));
}

TEST_F(ExecutorLayers, FacesOfACubeLieWhereDirectionsFindThem) {
  const std::string body = resource("box", "kind = \"cube\"\nformat = \"r32f\"\nwidth = 4\nheight = 4") +
                           fill("box", 6) + show("reads = [\"box\"]");
  write(body);
  shader("fill.frag", "void main() { out_box = float(i + 1) / 8.0; }");
  shader("show.frag",
         "void main() {\n"
         "  vec3 towards[6] = vec3[](vec3(1, 0.3, 0.2), vec3(-1, 0.2, -0.5), vec3(0.1, 1, 0.4), vec3(0.3, "
         "-1, 0.1),\n"
         "                           vec3(0.2, 0.2, 1), vec3(-0.4, 0.1, -1));\n"
         "  int right = 0;\n"
         "  for (int f = 0; f < 6; ++f) right += textureLod(box, towards[f], 0.0).r == float(f + 1) / 8.0 ? "
         "1 : 0;\n"
         "  out_visibility = float(right) / 6.0;\n}");
  EXPECT_THAT(visibility(), Each(1.0f));
  EXPECT_EQ(render().memory_bytes, 6u * 16u * 4u);
  write(replaced(body, "height = 4", "height = 8"));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("'box' is a cube of 4 x 8 texels"), HasSubstr("square")));
}

constexpr std::string_view kFaceViews =
    "[[view]]\nname = \"cube\"\ncount = 6\nvariable = \"face\"\nfrom = \"light.face(face)\"\nsize = 64\n";
constexpr std::string_view kDrawFaces =
    "[[pass]]\nid = \"faces\"\nkind = \"loop\"\nvariable = \"side\"\ncount = 6\n"
    "[[pass.pass]]\nid = \"map\"\nkind = \"scene\"\nview = \"cube\"\nview_index = \"side\"\n"
    "writes = [\"map\"]\nwrite_layer = \"side\"\nclear = [0]\n";

// The floor lies 1 below the lamp: seen at (x, -1, z) its distance along the -y face's axis is 1 everywhere.
TEST_F(ExecutorLayers, ACubeDrawnFaceByFaceHoldsTheSceneAroundTheLight) {
  write(std::string(kFaceViews) +
        resource("map", "kind = \"cube\"\nformat = \"depth32f\"\nwidth = 64\nheight = 64") +
        std::string(kDrawFaces) + show("views = [\"cube\"]\nreads = [\"map\", \"gbuffer.position\"]"));
  shader("show.frag",
         "#include \"spaces.glsl\"\nvoid main() {\n"
         "  vec3 p = texelFetch(gbuffer_position, ivec2(gl_FragCoord.xy), 0).xyz - "
         "frame.light_center_world.xyz;\n"
         "  float down = distance_of_depth(view_cube[3], textureLod(map, p, 0.0).r);\n"
         "  float up = textureLod(map, vec3(p.x, 1.0, p.z), 0.0).r;\n"
         "  out_visibility = up == 0.0 && view_cube_count == 6 ? 0.5 * down : 0.0;\n}");
  EXPECT_THAT(visibility(), Each(FloatNear(0.5f, 1e-4f)));
}

TEST_F(ExecutorLayers, ComparisonSamplersReadArraysAndCubes) {
  write(std::string(kFaceViews) +
        resource("map",
                 "kind = \"cube\"\nformat = \"depth32f\"\nwidth = 64\nheight = 64\ncompare = true\n"
                 "filter = \"linear\"") +
        std::string(kDrawFaces) + show("views = [\"cube\"]\nreads = [\"map\"]"));
  shader("show.frag",
         "#include \"spaces.glsl\"\nvoid main() {\n"
         "  float before = texture(map, vec4(0.1, -1.0, 0.2, depth_of_distance(view_cube[3], 0.9)));\n"
         "  float behind = texture(map, vec4(0.1, -1.0, 0.2, depth_of_distance(view_cube[3], 1.1)));\n"
         "  out_visibility = before - behind;\n}");
  EXPECT_THAT(visibility(), Each(1.0f));
  write(resource("stack",
                 "kind = \"array\"\nformat = \"depth32f\"\nwidth = 4\nheight = 4\nlayers = 2\n"
                 "compare = true") +
        fill("stack", 2) + show("reads = [\"stack\"]"));
  shader("fill.frag", "void main() { gl_FragDepth = 0.25 + 0.5 * float(i); }");
  shader("show.frag",
         "void main() { out_visibility = texture(stack, vec4(0.5, 0.5, 0.0, 0.5)) -\n"
         "                               texture(stack, vec4(0.5, 0.5, 1.0, 0.5)); }");
  EXPECT_THAT(visibility(), Each(1.0f));
}

TEST_F(ExecutorLayers, SlicesOfTheFrustumAreWhatTheManifestComputes) {
  scene_.lights = {sun_light({0.3, 1, 0.2}, 0.01)};
  const std::string body =
      "[[value]]\nname = \"reach\"\nvalue = \"camera.far - camera.near\"\n"
      "[[view]]\nname = \"part\"\ncount = 2\nvariable = \"k\"\nslice_world = [\"camera.near + reach * k / "
      "2\", "
      "\"camera.near + reach * (k + 1) / 2\"]\nfit = \"full\"\nsize = 16\n" +
      show("views = [\"part\"]");
  write(body, "\"sun\"");
  // The camera stands 20 above the floor and looks down: the scene's box ends there.
  shader("show.frag",
         "void main() {\n"
         "  vec4 ends = vec4(view_part[0].slice_world.xy, view_part[1].slice_world.xy);\n"
         "  bool right = ends.y == ends.z && abs(ends.w - 20.0) < 0.01 && abs(2.0 * ends.y - ends.x - "
         "ends.w) < 1e-4;\n"
         "  out_visibility = right ? 1.0 : 0.0;\n}");
  EXPECT_THAT(visibility(), Each(1.0f));
  write(replaced(body, "\"camera.near + reach * (k + 1) / 2\"", "\"camera.near\""), "\"sun\"");
  EXPECT_THAT(error_of(), AllOf(HasSubstr("view 'part' covers a slice from"), HasSubstr("end after that")));
}

TEST_F(ExecutorLayers, MembersAndFacesThatDoNotExistAreSentences) {
  const std::string body =
      std::string(kFaceViews) +
      resource("map", "kind = \"cube\"\nformat = \"depth32f\"\nwidth = 64\nheight = 64") +
      std::string(kDrawFaces) + show("reads = [\"map\"]");
  shader("show.frag", "void main() { out_visibility = textureLod(map, vec3(1), 0.0).r; }");
  write(replaced(body, "view_index = \"side\"", "view_index = \"side + 1\""));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("view_index of pass 'map'"), HasSubstr("from 0 to 5")));
  write(replaced(body, "light.face(face)", "light.face(face + 1)"));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("light face of view 'cube'"), HasSubstr("from 0 to 5")));
  write(replaced(body, "variable = \"side\"\ncount = 6", "variable = \"side\"\ncount = 7"));
  EXPECT_THAT(error_of(), HasSubstr("which has 6"));
}

}  // namespace
}  // namespace umbrameter
