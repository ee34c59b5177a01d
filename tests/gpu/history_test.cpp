// SPDX-License-Identifier: Apache-2.0
// Techniques with history: what a frame finds of the one before it, and that the frame that counts can be drawn again.

#include "realtime/inspect.h"
#include "tests/gpu/tried_technique.h"
#include "tests/support/procedural_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::Each;
using testing::FloatNear;
using testing::HasSubstr;

constexpr int kSidePx = 16;

/// A floor, a box on it, a lamp above.
Scene lamp_over_floor() {
  Scene scene;
  add_floor(scene, {40, 40});
  scene.parts = {{"floor", 0, 2}};
  add_box(scene, {-0.2, 0, -0.2}, {0.2, 0.1, 0.2});
  scene.parts.push_back({"box", 2, 12});
  scene.camera = camera_above({0, 0, 0}, 2, 20);
  scene.lights.push_back(disk_light_above({0, 4, 0}, 0.05));
  finish_scene(scene);
  return scene;
}

const std::string kState =
    "[[resource]]\nname = \"state\"\nformat = \"rgba32f\"\nwidth = \"screen.width\"\nheight = "
    "\"screen.height\"\n";

std::string pass(const std::string& id, const std::string& reads, const std::string& writes,
                 const std::string& more = {}) {
  return "[[pass]]\nid = \"" + id + "\"\nkind = \"fullscreen\"\nfragment = \"" + id + ".frag\"\nreads = [" +
         reads + "]\nwrites = [" + writes + "]\n" + more;
}

class History : public TriedTechnique {
 protected:
  History() : TriedTechnique(lamp_over_floor(), kSidePx) {}

  /// `frames` are drawn before the one that counts.
  void write(int frames, const std::string& body) {
    folder_.write("technique.toml", replaced(manifest_head(), "\"rect\", \"sun\"", "\"disk\"") +
                                        "frames_before = " + std::to_string(frames) + "\n" + body);
  }

  void move(std::string_view motion) { scene_.motion = standard_motion(motion, scene_); }
};

TEST_F(History, CountsTheFramesThatWereDrawn) {
  write(5, kState + pass("count", "\"previous.state\"", "\"state\"") +
               pass("show", "\"state\"", "\"visibility\""));
  // The first frame finds 0 everywhere.
  shader("count.frag",
         "void main() {\n"
         "  vec4 before = texelFetch(previous_state, ivec2(gl_FragCoord.xy), 0);\n"
         "  bool right = history.frame.x == int(before.x) && previous_state_size.xy == vec2(16.0);\n"
         "  out_state = vec4(before.x + 1.0, right ? before.y + 1.0 : -100.0, 0.0, 0.0);\n}");
  shader("show.frag", "void main() { out_visibility = dot(texelFetch(state, ivec2(0), 0), vec4(0.0625)); }");
  const Frame frame = render();
  EXPECT_THAT(frame.image.plane("visibility"), Each(12.0f / 16.0f));
  EXPECT_EQ(frame.frames_before, 5);
  EXPECT_EQ(frame.motion, "still");
  EXPECT_EQ(frame.memory_bytes, 2u * 16u * 16u * 16u);  // this frame's and the one before
  scene_.motion.frames_before = 0;
  EXPECT_THAT(visibility(), Each(2.0f / 16.0f));
}

TEST_F(History, TheFrameThatCountsIsDrawnAgainAsItWas) {
  write(3, kState + pass("count", "\"previous.state\"", "\"state\"") +
               pass("show", "\"state\"", "\"visibility\""));
  shader("count.frag",
         "void main() { out_state = vec4(texelFetch(previous_state, ivec2(gl_FragCoord.xy), 0).x + 1.0); }");
  shader("show.frag", "void main() { out_visibility = 0.125 * texelFetch(state, ivec2(0), 0).x; }");
  SilentProgress progress;
  PreparedRun run = renderer_->prepare(scene_, request(), progress);
  EXPECT_THAT(run.frame.image.plane("visibility"), Each(0.5f));
  EXPECT_THAT(run.passes, testing::ElementsAre("count", "show"));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(run.time_frame().size(), 2u);
  // Another run's frames do not come between.
  EXPECT_THAT(visibility(), Each(0.5f));
}

TEST_F(History, WhatIsDrawnOnceIsThereInEveryFrame) {
  const std::string table = "[[resource]]\nname = \"table\"\nformat = \"r32f\"\nwidth = 1\nheight = 1\n" +
                            pass("fill", "", "\"table\"", "once = true\n");
  write(4, table + kState + pass("count", "\"previous.state\", \"table\"", "\"state\"") +
               pass("show", "\"state\"", "\"visibility\""));
  shader("fill.frag", "void main() { out_table = 0.125; }");
  shader("count.frag",
         "void main() { out_state = texelFetch(previous_state, ivec2(0), 0) + texelFetch(table, ivec2(0), "
         "0).r; }");
  shader("show.frag", "void main() { out_visibility = texelFetch(state, ivec2(0), 0).x; }");
  EXPECT_THAT(visibility(), Each(0.625f));
}

/// 1 where the surface is found again within `reach` in the frame before, else 0.
std::string find_again(const std::string& reach) {
  return "void main() {\n"
         "  vec4 p = texelFetch(gbuffer_position, ivec2(gl_FragCoord.xy), 0);\n"
         "  vec4 clip = history.previous_clip_from_world * vec4(p.xyz, 1.0);\n"
         "  ivec2 px = ivec2(floor((0.5 + 0.5 * clip.xy / clip.w) * vec2(frame.screen_and_seed.xy)));\n"
         "  vec4 before = texelFetch(previous_gbuffer_position, px, 0);\n"
         "  bool is_seen = clip.w > 0.0 && before.w != 0.0 && distance(before.xyz, p.xyz) < " +
         reach + ";\n  out_visibility = is_seen ? 1.0 : 0.0;\n}";
}

// A pixel is .125 wide.
TEST_F(History, AMovingCameraFindsItsPointsInTheFrameBefore) {
  write(2, pass("show", "\"gbuffer.position\", \"previous.gbuffer.position\"", "\"visibility\""));
  shader("show.frag", find_again("1e-5"));
  EXPECT_THAT(visibility(), Each(1.0f));  // a still one sees them in the very same pixels
  move("pan");
  shader("show.frag", find_again("0.1"));
  const std::vector<float> seen = visibility();
  const auto count = std::count(seen.begin(), seen.end(), 1.0f);
  EXPECT_GT(count, 16 * 16 * 6 / 10);  // 3.6 columns and 1.4 rows of 16 have come into view
  EXPECT_LT(count, 16 * 16 * 8 / 10);
  move("cut");
  EXPECT_THAT(visibility(), Each(0.0f));
}

TEST_F(History, AMovingObjectWasElsewhere) {
  write(1, pass("show", "\"gbuffer.position\", \"previous.gbuffer.position\"", "\"visibility\""));
  shader("show.frag",
         "void main() {\n"
         "  ivec2 px = ivec2(gl_FragCoord.xy);\n"
         "  bool is_box = texelFetch(gbuffer_position, px, 0).y > 0.05;\n"
         "  bool was_box = texelFetch(previous_gbuffer_position, px, 0).y > 0.05;\n"
         "  out_visibility = is_box == was_box ? 0.0 : is_box ? 1.0 : 0.5;\n}");
  EXPECT_THAT(visibility(), Each(0.0f));
  scene_.motion = {.name = "script", .object = "box", .object_step_world = {0.125, 0, 0}};
  const std::vector<float> change = visibility();
  EXPECT_EQ(std::count(change.begin(), change.end(), 1.0f), 4);  // a column on one side, one on the other
  EXPECT_EQ(std::count(change.begin(), change.end(), 0.5f), 4);
}

TEST_F(History, AMovingLightMovesItsMap) {
  write(1, kState + "[[view]]\nname = \"light\"\nfit = \"scene\"\nsize = 64\n" +
               pass("store", "", "\"state\"", "views = [\"light\"]\n") +
               pass("show", "\"state\", \"previous.state\"", "\"visibility\""));
  shader("store.frag", "void main() { out_state = vec4(view_light.light_from_world[3].xyz, 1.0); }");
  shader("show.frag",
         "void main() { out_visibility = distance(texelFetch(state, ivec2(0), 0), texelFetch(previous_state, "
         "ivec2(0), 0)); }");
  EXPECT_THAT(visibility(), Each(0.0f));
  move("light");
  EXPECT_THAT(visibility(), Each(FloatNear(0.00618034f * 4.0f, 1e-5f)));
}

TEST_F(History, MapsMoveAsideByTheFramesJitter) {
  write(2, kState +
               "[[view]]\nname = \"light\"\nfit = \"scene\"\nsize = 64\noffset_texels = [\"frame.jitter_x\", "
               "\"frame.jitter_y\"]\n[[view]]\nname = \"still\"\nfit = \"scene\"\nsize = 64\n" +
               pass("store", "\"previous.state\"", "\"state\"", "views = [\"light\", \"still\"]\n") +
               pass("show", "\"state\"", "\"visibility\""));
  // Point 3 of the sequence of bases 2 and 3 is (3/4, 1/9).
  shader("store.frag",
         "void main() {\n"
         "  vec4 way = (view_light.lateral_bounds - view_still.lateral_bounds) * 64.0;\n"
         "  vec2 texels = way.xy / (view_still.lateral_bounds.zw - view_still.lateral_bounds.xy);\n"
         "  bool right = distance(texels, history.jitter.xy) < 1e-3 && way.xy == way.zw;\n"
         "  out_state = vec4(history.jitter.xy, right ? 1.0 : 0.0, texelFetch(previous_state, ivec2(0), "
         "0).x);\n}");
  shader("show.frag",
         "void main() {\n"
         "  vec4 s = texelFetch(state, ivec2(0), 0);\n"
         "  out_visibility = distance(s, vec4(0.25, 1.0 / 9.0 - 0.5, 1.0, -0.25)) < 1e-5 ? 1.0 : 0.0;\n}");
  EXPECT_THAT(visibility(), Each(1.0f));
}

TEST_F(History, SizesStayTheSame) {
  write(2,
        "[[resource]]\nname = \"state\"\nformat = \"r32f\"\nwidth = \"1 + floor(receivers.far)\"\nheight = "
        "1\n" +
            pass("count", "\"previous.state\"", "\"state\"") + pass("show", "\"state\"", "\"visibility\""));
  shader("count.frag", "void main() { out_state = texelFetch(previous_state, ivec2(0), 0).r; }");
  shader("show.frag", "void main() { out_visibility = texelFetch(state, ivec2(0), 0).r; }");
  EXPECT_THAT(visibility(), Each(0.0f));
  move("cut");
  try {
    render();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("resource 'state' is"), HasSubstr("keeps the sizes")));
  }
}

}  // namespace
}  // namespace umbrameter
