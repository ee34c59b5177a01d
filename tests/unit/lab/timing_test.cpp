// SPDX-License-Identifier: Apache-2.0
// Without these, one run's frames could all fall into another program's busy minute, or a slow run take the hour.

#include "lab/timing.h"

#include "core/error.h"
#include "tests/support/lab/fakes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace umbrameter {
namespace {

class Timing : public testing::Test {
 protected:
  Timing() : renderer_(fake_realtime()) {
    renderer_.time_frame = [this](const RenderRequest& request, int frame) {
      order_ += request.technique;
      if (request.technique == fails_ && frame == 20) fail_input("lost", {}, "");
      return std::vector<double>{frame_ms_[request.technique], 0.0};
    };
  }

  std::vector<TimedRun> run(const std::string& techniques, const TimingPlan& plan) {
    std::vector<LabelledRequest> requests;
    for (const char id : techniques) {
      RenderRequest request;
      request.technique = std::string(1, id);
      requests.push_back({request.technique, request});
    }
    SilentProgress progress;
    return render_interleaved(renderer_, fake_scene("plate").scene, requests, plan, progress);
  }

  FakeRenderer renderer_;
  std::map<std::string, double> frame_ms_;
  std::string order_;  // of the frames, warm-up included
  std::string fails_;
};

TEST_F(Timing, WarmsUpThenTakesTurns) {
  frame_ms_ = {{"a", 30.0}, {"b", 60.0}};
  const std::vector<TimedRun> runs = run("ab", {.wanted_frames = 4, .budget_s = 10.0});
  EXPECT_EQ(order_,
            "aab"
            "abababab");  // until 50 ms have passed, then in turn
  for (const TimedRun& result : runs) EXPECT_EQ(result.times.frames_ms.size(), 4u);
  EXPECT_EQ(summarise(runs[1].times).back().median_ms, 60.0);
  EXPECT_EQ(runs[0].times.passes, (std::vector<std::string>{"map", "resolve"}));
  EXPECT_EQ(runs[0].timer, "fake clock");
}

TEST_F(Timing, WarmUpEndsForFramesThatTakeNoTime) {
  frame_ms_ = {{"a", 0.0}};
  EXPECT_EQ(run("a", {.wanted_frames = 4, .budget_s = 1.0})[0].times.frames_ms.size(), 4u);
  EXPECT_EQ(order_.size(), 16u + 4u);
}

TEST_F(Timing, SlowRunsGetFewerFramesSpreadOverAllRounds) {
  frame_ms_ = {{"a", 100.0}, {"b", 500.0}};
  const std::vector<TimedRun> runs = run("ab", {.wanted_frames = 8, .budget_s = 1.0});
  EXPECT_EQ(runs[0].times.frames_ms.size(), 8u);
  EXPECT_EQ(runs[1].times.frames_ms.size(), 2u);
  EXPECT_EQ(order_,
            "ab"
            "aaaabaaaab");
}

TEST_F(Timing, AFrameBeyondTheBudgetIsTheOnlyOne) {
  frame_ms_ = {{"a", 3000.0}};
  EXPECT_EQ(run("a", {.wanted_frames = 8, .budget_s = 1.0})[0].times.frames_ms.size(), 1u);
  EXPECT_EQ(order_, "a");
}

TEST_F(Timing, ARunThatFailsWhileTimedLeavesTheOthersAlone) {
  frame_ms_ = {{"a", 0.0}, {"b", 0.0}};
  fails_ = "a";
  const std::vector<TimedRun> runs = run("ab", {.wanted_frames = 30, .budget_s = 1.0});
  ASSERT_TRUE(runs[0].failure);
  EXPECT_EQ(runs[0].failure->message, "lost");
  EXPECT_FALSE(runs[1].failure);
  EXPECT_EQ(runs[1].times.frames_ms.size(), 30u);
  EXPECT_EQ(std::ranges::count(order_, 'a'), 21);
}

TEST_F(Timing, WithoutFramesNothingIsTimed) {
  const std::vector<TimedRun> runs = run("a", {.wanted_frames = 0});
  EXPECT_TRUE(order_.empty());
  EXPECT_TRUE(runs[0].times.frames_ms.empty());
  EXPECT_TRUE(runs[0].frame.image.has("visibility"));
}

TEST_F(Timing, RunsThatDoNotFitTogetherAreTimedInGroups) {
  frame_ms_ = {{"a", 60.0}, {"b", 60.0}, {"c", 60.0}};
  FakeRenderer large([](const RenderRequest&) {
    Frame frame = frame_of(technique_image(0.0f));
    frame.memory_bytes = uint64_t{1} << 30;  // two of them fill the limit
    return frame;
  });
  large.time_frame = renderer_.time_frame;
  std::vector<LabelledRequest> requests(3);
  for (size_t i = 0; i < 3; ++i) requests[i].request.technique = std::string(1, "abc"[i]);
  SilentProgress progress;
  render_interleaved(large, fake_scene("plate").scene, requests, {.wanted_frames = 2, .budget_s = 1.0},
                     progress);
  EXPECT_EQ(order_,
            "ab"
            "abab"
            "c"
            "cc");
}

}  // namespace
}  // namespace umbrameter
