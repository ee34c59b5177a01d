// SPDX-License-Identifier: Apache-2.0
// A frame depends on earlier ones only as it says: what it draws again, to be timed, is the same picture.

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
                           HasSubstr("a frame that is drawn again, to be timed, would be another"),
                           HasSubstr("write 'state' anew in each frame"), HasSubstr("'previous.state'")));
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

/// The same of a technique that says `head` in its first lines.
std::string error_with_head(const std::string& head, const std::string& passes) {
  TechniqueFolder folder;
  for (const char* id : {"step", "draw"}) folder.write(fmt::format("{}.frag", id), "void main() { }");
  const std::string manifest =
      replaced(whole_manifest(), "[[pass]]\nid = \"map\"",
               "[[resource]]\nname = \"state\"\nformat = \"r32f\"\nwidth = 4\nheight = 4\n" + passes +
                   "[[pass]]\nid = \"map\"");
  return error_of(folder, replaced(manifest, "schema = 1\n", "schema = 1\n" + head));
}

const std::string kStep = pass("step", "\"previous.state\"", "\"state\"");

TEST(Frames, WhatTheFrameBeforeWroteIsReadByAnotherName) {
  EXPECT_EQ(error_with_head("frames_before = \"taps\"\n", kStep), "no error");
  EXPECT_EQ(error_with_head("frames_before = 3\n",
                            pass("step", "\"previous.gbuffer.normal\"", "\"state\"") +
                                pass("draw", "\"state\", \"previous.state\"", "\"visibility\"")),
            "no error");
}

TEST(Frames, HistoryIsSaidAndUsed) {
  EXPECT_THAT(error_with_head("", kStep),
              AllOf(HasSubstr("reads 'previous.state', but the technique has no history"),
                    HasSubstr("'frames_before'")));
  EXPECT_THAT(error_with_head("frames_before = 3\n",
                              pass("step", "", "\"state\"") + pass("draw", "\"state\"", "\"visibility\"")),
              HasSubstr("draws frames before and reads nothing of them"));
  EXPECT_THAT(error_with_head("frames_before = \"tap\"\n", kStep),
              AllOf(HasSubstr("unknown name 'tap'"), HasSubstr("'taps'")));
  EXPECT_THAT(error_with_head("frames_before = 3\n", pass("step", "\"previous.stat\"", "\"state\"")),
              AllOf(HasSubstr("reads 'previous.stat'"), HasSubstr("'previous.state'")));
  EXPECT_THAT(error_with_head("frames_before = 3\n", pass("step", "\"previous.visibility\"", "\"state\"")),
              HasSubstr("reads 'previous.visibility', which is neither"));
}

TEST(Frames, TheirNumberIsForTechniquesWithHistory) {
  const std::string views =
      pass("step", "\"previous.state\"", "\"state\"", "condition = \"frame.index > 2\"");
  EXPECT_EQ(error_with_head("frames_before = 3\n", views), "no error");
  EXPECT_THAT(error_with_head("", pass("step", "", "\"state\"", "condition = \"frame.index > 2\"")),
              HasSubstr("unknown name 'frame.index'"));
}

}  // namespace
}  // namespace umbrameter
