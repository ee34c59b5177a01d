// SPDX-License-Identifier: Apache-2.0
#pragma once
// Progress on stderr: a bar with the time left on a terminal, a line every few seconds elsewhere. Silent for
// anything shorter than two seconds.

#include "core/progress.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace umbrameter {

/// "task: 42 %, 1:05 left"; without steps done "task: 12 s so far".
std::string progress_text(const std::string& task, uint64_t done, uint64_t total, double elapsed_s);

class ProgressBar final : public Progress {
 public:
  ProgressBar();
  ~ProgressBar() override;
  void begin(std::string_view task, uint64_t total_steps) override;
  void advance(uint64_t steps) override { done_.fetch_add(steps, std::memory_order_relaxed); }
  void end() override;
  /// Wipes the bar so that a line can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void tick();
  void draw();
  void wipe();

  const bool is_terminal_;
  std::atomic<uint64_t> done_{0};
  std::mutex mutex_;  // guards what follows
  std::condition_variable wake_;
  std::string task_;
  uint64_t total_ = 0;
  Clock::time_point start_;
  Clock::time_point last_line_;
  bool is_active_ = false;
  bool is_drawn_ = false;
  bool is_stopping_ = false;
  std::thread ticker_;
};

}  // namespace umbrameter
