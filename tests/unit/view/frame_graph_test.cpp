// SPDX-License-Identifier: Apache-2.0
// Without this the frame graph could join passes that hand each other nothing.

#include "view/frame_graph.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

PassDeclaration pass(std::string id, std::vector<std::string> reads, std::vector<std::string> writes) {
  PassDeclaration made;
  made.id = std::move(id);
  made.reads = std::move(reads);
  made.writes = std::move(writes);
  return made;
}

std::vector<std::string> names(const FrameGraph& graph, const std::vector<size_t>& lanes) {
  std::vector<std::string> found;
  for (const size_t lane : lanes) found.push_back(graph.lanes[lane].resource);
  return found;
}

using Names = std::vector<std::string>;

TEST(FrameGraph, LanesRunFromTheFirstPassThatHasToDoWithATextureToTheLast) {
  const FrameGraph graph =
      frame_graph({pass("map", {}, {"shadow_map"}), pass("blur", {"shadow_map"}, {"moments"}),
                   pass("shade", {"gbuffer.position", "gbuffer.normal", "moments"}, {"visibility"})});
  ASSERT_EQ(graph.rows.size(), 4u);  // the G-buffer before them
  EXPECT_EQ(names(graph, graph.rows[0].writes), Names{kGBufferLane});
  EXPECT_EQ(names(graph, graph.rows[3].reads), (Names{kGBufferLane, "moments"}));  // its two parts are one
  ASSERT_EQ(graph.lanes.size(), 4u);
  EXPECT_EQ(graph.lanes[0].last_row, 3u);
  EXPECT_EQ(graph.lanes[1].first_row, 1u);
  EXPECT_EQ(graph.lanes[1].last_row, 2u);
  // visibility begins after the map's last reader, moments while it is still there
  EXPECT_EQ(graph.lanes[3].column, graph.lanes[1].column);
  EXPECT_NE(graph.lanes[2].column, graph.lanes[1].column);
  EXPECT_EQ(graph.columns, 3u);
}

TEST(FrameGraph, PassesThatAreNotDrawnAndTheirTexturesAreLeftOut) {
  PassDeclaration loop = pass("lights", {}, {});
  loop.body = {pass("map", {}, {"shadow_map"}), pass("blur", {"shadow_map"}, {"moments"})};
  const std::vector<PassDeclaration> passes{loop, pass("shade", {"shadow_map"}, {"visibility"})};
  const FrameGraph some = frame_graph(passes, {"map", "shade"}), none = frame_graph(passes, {"shade"});
  ASSERT_EQ(some.rows.size(), 4u);
  EXPECT_EQ(some.rows[2].id, "map");
  EXPECT_EQ(some.lanes.size(), 3u);
  ASSERT_EQ(none.rows.size(), 2u);
  EXPECT_EQ(none.rows[1].id, "shade");
}

TEST(FrameGraph, PassesOfALoopStandBelowItAndHaveTheTimerTheyAreSummedUnder) {
  PassDeclaration loop;
  loop.id = "lights";
  loop.body = {pass("map", {}, {"shadow_map"})};
  loop.body[0].timer = "maps";
  const FrameGraph graph = frame_graph({loop});
  ASSERT_EQ(graph.rows.size(), 3u);
  EXPECT_TRUE(graph.rows[1].is_loop);
  EXPECT_EQ(graph.rows[2].depth, 1);
  EXPECT_EQ(graph.rows[2].label, "maps");
}

}  // namespace
}  // namespace umbrameter
