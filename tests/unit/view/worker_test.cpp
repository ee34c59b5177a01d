// SPDX-License-Identifier: Apache-2.0
// Without this the window could wait for a ray tracer, show an older answer after a newer one, or hang when it is closed.

#include "view/latest_worker.h"
#include "view/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>

namespace umbrameter {
namespace {

using Worker = LatestWorker<int, int>;

/// Waits for a result; the test's own time limit ends a wait that has no end.
int wait_for(Worker& worker) {
  for (;;) {
    if (const auto result = worker.take()) return *result;
    std::this_thread::yield();
  }
}

TEST(LatestWorker, DropsJobsThatANewerOneOvertook) {
  std::promise<void> begun, go;
  std::shared_future<void> gate = go.get_future().share();
  std::vector<int> done;
  Worker worker(
      [&] {
        return [&, is_first = true](const int& job, Worker::Desk& desk) mutable {
          if (std::exchange(is_first, false)) begun.set_value(), gate.wait();
          done.push_back(job);
          desk.publish(job);
        };
      },
      [] {});
  worker.ask(1);
  begun.get_future().wait();
  worker.ask(2);
  worker.ask(3);
  go.set_value();
  while (wait_for(worker) != 3) continue;
  EXPECT_EQ(done, (std::vector<int>{1, 3}));
}

TEST(LatestWorker, TellsAJobInProgressThatItIsStaleAndEndsIt) {
  std::promise<void> begun;
  bool was_cancelled = false;
  Worker worker(
      [&] {
        return [&](const int& job, Worker::Desk& desk) {
          if (job == 2) return desk.publish(job);
          begun.set_value();
          StaleProgress progress(desk);
          try {
            for (;;) progress.advance(1);
          } catch (const Error& error) {
            was_cancelled = error.kind() == ErrorKind::cancelled;
            throw;
          }
        };
      },
      [] {});
  worker.ask(1);
  begun.get_future().wait();
  worker.ask(2);
  EXPECT_EQ(wait_for(worker), 2);
  EXPECT_TRUE(was_cancelled);
  EXPECT_FALSE(worker.take_failure());  // nobody is told of what was cancelled
}

TEST(LatestWorker, ClosesWhileAJobRuns) {
  std::promise<void> begun;
  {
    Worker worker(
        [&] {
          return [&](const int&, Worker::Desk& desk) {
            begun.set_value();
            while (!desk.is_stale()) std::this_thread::yield();
          };
        },
        [] {});
    worker.ask(1);
    begun.get_future().wait();
  }  // must come back
}

TEST(LatestWorker, HandsOverWhatAJobThrewAndGoesOn) {
  Worker worker(
      [] {
        return [](const int& job, Worker::Desk& desk) {
          if (job == 1) fail_input("no such thing");
          desk.publish(job);
        };
      },
      [] {});
  worker.ask(1);
  std::optional<Failure> failure;
  while (!failure) failure = worker.take_failure();
  EXPECT_EQ(failure->message, "no such thing");
  worker.ask(2);
  EXPECT_EQ(wait_for(worker), 2);
}

TEST(LatestWorker, HandsOverWhyItCouldNotBeOpened) {
  Worker worker([]() -> Worker::Work { fail_environment("no GL"); }, [] {});
  worker.ask(1);
  std::optional<Failure> failure;
  while (!failure) failure = worker.take_failure();
  EXPECT_EQ(failure->kind, ErrorKind::environment);
  while (worker.is_busy()) std::this_thread::yield();
  EXPECT_FALSE(worker.take());
}

void expect_refused(const std::string& text, const std::string& part) {
  try {
    parse_script(text, "s.txt");
    FAIL() << text;
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(part));
  }
}

TEST(Script, ReadsCommandsWordsAndComments) {
  const auto steps = parse_script("# a flight\nkey PAGE_DOWN\n\nwait truth 0.02  # then\n", "s.txt");
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].words, std::vector<std::string>{"PAGE_DOWN"});
  EXPECT_EQ(steps[1].where.line, 4);
  EXPECT_DOUBLE_EQ(steps[1].number(1), 0.02);
}

TEST(Script, RefusesWhatItDoesNotKnowAtItsLine) {
  expect_refused("key A\nkay B\n", "s.txt:2: unknown command 'kay' (did you mean 'key'?)");
  expect_refused("resize 10\n", "'resize' has 1 words behind it");
  EXPECT_THROW(parse_script("frames many\n", "s.txt")[0].number(0), Error);
}

TEST(Script, KnowsKeysByName) {
  EXPECT_EQ(key_of("A"), 65);
  EXPECT_EQ(key_of("SPACE"), 32);
  EXPECT_EQ(key_of("a"), -1);
}

}  // namespace
}  // namespace umbrameter
