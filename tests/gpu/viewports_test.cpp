// SPDX-License-Identifier: Apache-2.0
// Passes that draw into a part of their targets: the rest stays as it was, whatever clears, draws or resolves.

#include "tests/gpu/tried_technique.h"
#include "tests/support/procedural_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;

constexpr int kSidePx = 8;

/// A floor at y = 0 and a wider one at y = 1 over all of it, from a sun overhead.
Scene covered_floor() {
  Scene scene;
  add_floor(scene, {4, 4});
  add_floor(scene, {8, 8}, 1.0);
  scene.camera = camera_above({0, 0, 0}, 2, 20);
  scene.lights.push_back(sun_light({0, 1, 0}, 0.01));
  finish_scene(scene);
  return scene;
}

std::string resource(const std::string& format, const std::string& more = {}) {
  return "[[resource]]\nname = \"sheet\"\nformat = \"" + format + "\"\nwidth = 6\nheight = 4\n" + more;
}

/// Fills the sheet, then draws into a part of it.
std::string passes(const std::string& viewport, const std::string& more = {}) {
  return "[[pass]]\nid = \"fill\"\nkind = \"fullscreen\"\nfragment = \"fill.frag\"\nwrites = [\"sheet\"]\n"
         "[[pass]]\nid = \"part\"\nkind = \"fullscreen\"\nfragment = \"part.frag\"\nwrites = [\"sheet\"]\n"
         "viewport = " +
         viewport + "\n" + more;
}

constexpr const char* kShow =
    "[[pass]]\nid = \"show\"\nkind = \"fullscreen\"\nfragment = \"show.frag\"\nreads = [\"sheet\"]\n"
    "writes = [\"visibility\"]\n";

/// 1 where texels x 2 to 4, y 1 to 2 hold `inside` and all others `outside`.
std::string show_part(const std::string& inside, const std::string& outside) {
  return "void main() {\n"
         "  bool right = true;\n"
         "  for (int y = 0; y < 4; ++y)\n"
         "    for (int x = 0; x < 6; ++x) {\n"
         "      bool is_inside = x >= 2 && x < 5 && y >= 1 && y < 3;\n"
         "      right = right && texelFetch(sheet, ivec2(x, y), 0).r == (is_inside ? " +
         inside + " : " + outside +
         ");\n"
         "    }\n"
         "  out_visibility = right ? 1.0 : 0.0;\n}";
}

class Viewports : public TriedTechnique {
 protected:
  Viewports() : TriedTechnique(covered_floor(), kSidePx) {}

  void SetUp() override {
    TriedTechnique::SetUp();
    shader("fill.frag", "void main() { out_sheet = 0.25; }");
    shader("part.frag", "void main() { out_sheet = 0.75; }");
  }

  void write(const std::string& body) {
    folder_.write("technique.toml", replaced(manifest_head(), "\"rect\", \"sun\"", "\"sun\"") + body);
  }
};

TEST_F(Viewports, HoldFullscreenPassesToTheirPart) {
  write(resource("r32f") + passes("[2, 1, 3, \"4 / 2\"]") + kShow);
  shader("show.frag", show_part("0.75", "0.25"));
  EXPECT_THAT(visibility(), Each(1.0f));
  write(resource("r32f", "samples = 4\n") + passes("[2, 1, 3, 2]") + kShow);
  EXPECT_THAT(visibility(), Each(1.0f)) << "of several samples";
}

TEST_F(Viewports, HoldClearsToTheirPart) {
  write(resource("r32f") + passes("[2, 1, 3, 2]", "clear = [0.5]\n") + kShow);
  shader("part.frag", "void main() { discard; }");
  shader("show.frag", show_part("0.5", "0.25"));
  EXPECT_THAT(visibility(), Each(1.0f));
}

TEST_F(Viewports, HoldTrianglesToTheirPartThatCoverTheWholeView) {
  write("[[view]]\nname = \"light\"\nfit = \"visible\"\nsize = 4\n" + resource("r32f") +
        "[[resource]]\nname = \"depths\"\nformat = \"depth32f\"\nwidth = 6\nheight = 4\n"
        "[[pass]]\nid = \"fill\"\nkind = \"fullscreen\"\nfragment = \"fill.frag\"\nwrites = [\"sheet\"]\n"
        "[[pass]]\nid = \"empty\"\nkind = \"fullscreen\"\nfragment = \"far.frag\"\nwrites = [\"depths\"]\n"
        "[[pass]]\nid = \"part\"\nkind = \"scene\"\nview = \"light\"\nfragment = \"part.frag\"\n"
        "writes = [\"sheet\", \"depths\"]\nviewport = [2, 1, 3, 2]\n" +
        kShow);
  shader("far.frag", "void main() { gl_FragDepth = 0.0; }");
  shader("show.frag", show_part("0.75", "0.25"));
  EXPECT_THAT(visibility(), Each(1.0f));
}

TEST_F(Viewports, FollowLoops) {
  write(resource("r32f") +
        "[[pass]]\nid = \"columns\"\nkind = \"loop\"\nvariable = \"i\"\ncount = 6\n"
        "[[pass.pass]]\nid = \"column\"\nkind = \"fullscreen\"\nfragment = \"column.frag\"\n"
        "writes = [\"sheet\"]\nclear = [0.0]\nviewport = [\"i\", 0, 1, 4]\n" +
        kShow);
  shader("column.frag", "void main() { out_sheet = float(i); }");
  shader("show.frag",
         "void main() {\n"
         "  bool right = true;\n"
         "  for (int x = 0; x < 6; ++x) right = right && texelFetch(sheet, ivec2(x, 3), 0).r == float(x);\n"
         "  out_visibility = right ? 1.0 : 0.0;\n}");
  EXPECT_THAT(visibility(), Each(1.0f));
}

TEST_F(Viewports, AreErrorsOutsideTheTarget) {
  shader("show.frag", show_part("0.75", "0.25"));
  write(resource("r32f") + passes("[4, 1, 3, 2]") + kShow);
  EXPECT_THAT(error_of(), AllOf(HasSubstr("technique.toml:"),
                                HasSubstr("viewport of pass 'part' covers texels 4 to 7 of 'sheet', whose "
                                          "width is 6"),
                                HasSubstr("lies inside")));
  write(resource("r32f") + passes("[2, 3, 3, 2]") + kShow);
  EXPECT_THAT(error_of(), HasSubstr("covers texels 3 to 5 of 'sheet', whose height is 4"));
  write(resource("r32f") + passes("[2, 1, 0, 2]") + kShow);
  EXPECT_THAT(error_of(), HasSubstr("viewport of pass 'part'"));
  write(resource("r32f") + passes("[2, 1, 3]") + kShow);
  EXPECT_THAT(error_of(), AllOf(HasSubstr("'viewport' has 3 entries"), HasSubstr("[x, y, width, height]")));
}

TEST_F(Viewports, LeaveNoPixelOfTheAnswerUnwritten) {
  write(
      "[[pass]]\nid = \"show\"\nkind = \"fullscreen\"\nfragment = \"show.frag\"\nwrites = [\"visibility\"]\n"
      "clear = [1.0]\nviewport = [0, 0, 4, 4]\n");
  shader("show.frag", "void main() { out_visibility = 1.0; }");
  EXPECT_THAT(error_of(), AllOf(HasSubstr("draws into a part of 'visibility'"), HasSubstr("every pixel")));
}

}  // namespace
}  // namespace umbrameter
