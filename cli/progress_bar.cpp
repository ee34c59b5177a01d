// SPDX-License-Identifier: Apache-2.0
#include "cli/progress_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace umbrameter {
namespace {

using Seconds = std::chrono::duration<double>;
constexpr double kSilence_s = 2.0;
constexpr double kLineInterval_s = 5.0;
constexpr auto kTick = std::chrono::milliseconds(200);

std::string remaining_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string progress_text(const std::string& task, uint64_t done, uint64_t total, double elapsed_s) {
  if (done == 0 || total == 0) return fmt::format("{}: {} so far", task, remaining_text(elapsed_s));
  const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
  return fmt::format("{}: {:.0f} %, {} left", task, std::floor(100.0 * share),
                     remaining_text(elapsed_s * (1.0 - share) / share));
}

ProgressBar::ProgressBar() : is_terminal_(isatty(STDERR_FILENO) == 1), ticker_([this] { tick(); }) {}

ProgressBar::~ProgressBar() {
  {
    const std::lock_guard lock(mutex_);
    is_stopping_ = true;
    wipe();
  }
  wake_.notify_all();
  ticker_.join();
}

void ProgressBar::begin(std::string_view task, uint64_t total_steps) {
  const std::lock_guard lock(mutex_);
  task_ = task;
  total_ = total_steps;
  done_ = 0;
  start_ = last_line_ = Clock::now();
  is_active_ = true;
}

void ProgressBar::end() {
  const std::lock_guard lock(mutex_);
  is_active_ = false;
  wipe();
}

void ProgressBar::clear() {
  const std::lock_guard lock(mutex_);
  wipe();
}

void ProgressBar::tick() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, kTick, [this] { return is_stopping_; })) draw();
}

void ProgressBar::draw() {
  const double elapsed_s = Seconds(Clock::now() - start_).count();
  if (!is_active_ || elapsed_s < kSilence_s) return;
  const std::string text = progress_text(task_, done_, total_, elapsed_s);
  if (is_terminal_) {
    constexpr int kCells = 24;
    const double share =
        total_ == 0 ? 0.0 : std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_));
    const int filled = static_cast<int>(share * kCells);
    fmt::print(stderr, "\r\033[K[{}{}] {}", std::string(static_cast<size_t>(filled), '#'),
               std::string(static_cast<size_t>(kCells - filled), ' '), text);
    std::fflush(stderr);
    is_drawn_ = true;
    return;
  }
  const bool is_first = last_line_ == start_;
  if (!is_first && Seconds(Clock::now() - last_line_).count() < kLineInterval_s) return;
  last_line_ = Clock::now();
  fmt::print(stderr, "umbrameter: {}\n", text);
}

void ProgressBar::wipe() {
  if (!is_drawn_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  is_drawn_ = false;
}

}  // namespace umbrameter
