// SPDX-License-Identifier: Apache-2.0
// A frame depends on no earlier one: pictures come from the first, times from later ones.

#include "tests/unit/realtime/whole_manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kResources =
    "[[resource]]\nname = \"state\"\nformat = \"r32f\"\nwidth = 4\nheight = 4\n\n"
    "[[resource]]\nname = \"next\"\nformat = \"r32f\"\nwidth = 4\nheight = 4\n\n";

std::string pass(const std::string& id, const std::string& reads, const std::string& writes,
                 const std::string& more = {}) {
  return fmt::format(
      "[[pass]]\nid = \"{}\"\nkind = \"fullscreen\"\nfragment = \"{}.frag\"\nreads = [{}]\nwrites = "
      "[{}]\n{}\n",
      id, id, reads, writes, more);
}

/// What becomes of the whole manifest when these passes run before its own and its last one reads `state`.
std::string error_with(const std::string& passes) {
  TechniqueFolder folder;
  for (const char* id : {"start", "step", "back", "draw"})
    folder.write(fmt::format("{}.frag", id), "void main() { }");
  std::string manifest =
      replaced(whole_manifest(), "[[pass]]\nid = \"map\"", kResources + passes + "[[pass]]\nid = \"map\"");
  manifest = replaced(manifest, "\"gbuffer.position\", \"shadow_map\"",
                      "\"gbuffer.position\", \"shadow_map\", \"state\"");
  return error_of(folder, manifest);
}

const std::string kStart = pass("start", "", "\"state\"", "once = true");

TEST(Frames, StateThatGoesRoundIsRefused) {
  const std::string error =
      error_with(kStart + pass("step", "\"state\"", "\"next\"") + pass("back", "\"next\"", "\"state\""));
  EXPECT_THAT(error, AllOf(HasSubstr("pass 'step' reads 'state' as the frame before left it"),
                           HasSubstr("techniques that carry state over frames cannot be judged"),
                           HasSubstr("write 'state' anew in each frame")));
}

TEST(Frames, SumsThatGrowFromFrameToFrameAreRefused) {
  EXPECT_THAT(error_with(kStart + pass("step", "", "\"next\"") +
                         pass("draw", "\"next\"", "\"state\"", "blend = \"add\"")),
              HasSubstr("pass 'draw' draws over 'state' as the frame before left it"));
}

TEST(Frames, SumsThatBeginAnewAndTablesMadeOnceAreFine) {
  EXPECT_EQ(
      error_with(kStart + pass("step", "\"state\"", "\"next\"") + pass("draw", "\"next\"", "\"visibility\"")),
      "no error");
  EXPECT_EQ(error_with(pass("start", "", "\"next\"", "once = true") +
                       pass("draw", "\"next\"", "\"state\"", "blend = \"add\"\nclear = [0]")),
            "no error");
  EXPECT_EQ(error_with(pass("start", "", "\"state\"") + pass("step", "\"state\"", "\"next\"") +
                       pass("back", "\"next\"", "\"state\"")),
            "no error");
}

}  // namespace
}  // namespace umbrameter
