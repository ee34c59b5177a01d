// SPDX-License-Identifier: Apache-2.0
// Without these, a time could be that of another clock, another pass or another frame.

#include "realtime/harness/timers.h"
#include "tests/gpu/gl_test.h"

#include <array>

namespace umbrameter {
namespace {

class TimersTest : public test::GlTest {};

TEST_F(TimersTest, SoftwareRenderersAreTimedByTheWallClock) {
  const TimerKind kind = choose_timer();
  if (context().device().is_hardware) GTEST_SKIP() << "this is " << context().device().renderer;
  EXPECT_EQ(to_text(kind), "glFinish + steady clock");
}

TEST_F(TimersTest, TheCheckCanBeRepeatedAndLeavesNoErrorBehind) {
  const TimerKind first = choose_timer();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(choose_timer(), first);
  EXPECT_NO_THROW(check_gl_errors("after the checks"));
}

class EitherTimer : public test::GlTest, public ::testing::WithParamInterface<TimerKind> {};

TEST_P(EitherTimer, SumsEveryLabelOverOneFrame) {
  const Texture texture(find_texture_format("r32f"), 16, 16);
  PassTimers timers(GetParam(), 3);
  for (int frame = 0; frame < 4; ++frame) {
    timers.begin_frame();
    for (int repeat = 0; repeat < 3; ++repeat) {
      for (const size_t label : {0u, 1u}) {
        timers.begin(label);
        clear_texture(texture, std::array{1.0});
        timers.end();
      }
    }
    const std::vector<double> times_ms = timers.end_frame();
    ASSERT_EQ(times_ms.size(), 3u);
    EXPECT_EQ(times_ms[2], 0.0);
  }
  check_gl_errors("timing");
}

TEST_P(EitherTimer, RefusesIntervalsThatAreNotClosed) {
  PassTimers timers(GetParam(), 1);
  timers.begin_frame();
  EXPECT_THROW(timers.end(), Error);
  timers.begin(0);
  EXPECT_THROW(timers.begin(0), Error);
  EXPECT_THROW(timers.end_frame(), Error);
  timers.end();
  EXPECT_THROW(timers.begin(1), Error);
}

INSTANTIATE_TEST_SUITE_P(Timers, EitherTimer,
                         ::testing::Values(TimerKind::elapsed_query, TimerKind::finish_and_clock),
                         [](const auto& test) {
                           return test.param == TimerKind::elapsed_query ? "Query" : "FinishAndClock";
                         });

}  // namespace
}  // namespace umbrameter
