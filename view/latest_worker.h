// SPDX-License-Identifier: Apache-2.0
#pragma once
// A thread that always works on the newest job: older ones that have not begun are dropped, one in progress is told that it
// is stale. The window never waits for it.

#include "core/error.h"
#include "core/guard.h"
#include "core/progress.h"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace umbrameter {

template <class Job, class Result>
class LatestWorker {
 public:
  /// What a job in progress may ask and tell.
  class Desk {
   public:
    explicit Desk(LatestWorker& owner) : owner_(owner) {}
    /// A newer job waits, or the window closes.
    bool is_stale() const { return owner_.has_newer_.load(std::memory_order_relaxed); }
    /// Replaces what nobody has taken yet.
    void publish(Result result) {
      {
        const std::lock_guard lock(owner_.mutex_);
        owner_.result_ = std::move(result);
      }
      owner_.tell_();
    }

   private:
    LatestWorker& owner_;
  };

  using Work = std::function<void(const Job&, Desk&)>;

  /// `open` runs on the thread and gives what does the jobs; what that owns is destroyed there, too. An error of either is
  /// handed to take_failure(). `tell` is called on the thread when there is a result or a failure to take.
  LatestWorker(std::function<Work()> open, std::function<void()> tell)
      : tell_(std::move(tell)), thread_([this, open = std::move(open)]() mutable { run(std::move(open)); }) {}

  ~LatestWorker() {
    {
      const std::lock_guard lock(mutex_);
      is_closing_ = true;
      has_newer_ = true;
    }
    wake_.notify_one();
    thread_.join();
  }
  LatestWorker(const LatestWorker&) = delete;
  LatestWorker& operator=(const LatestWorker&) = delete;

  void ask(Job job) {
    {
      const std::lock_guard lock(mutex_);
      job_ = std::move(job);
      has_newer_ = true;
    }
    wake_.notify_one();
  }

  /// Forgets the waiting job and makes the one in progress stale.
  void cancel() {
    const std::lock_guard lock(mutex_);
    job_.reset();
    has_newer_ = true;
  }

  std::optional<Result> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(result_, std::nullopt);
  }

  std::optional<Failure> take_failure() {
    const std::lock_guard lock(mutex_);
    return std::exchange(failure_, std::nullopt);
  }

  bool is_busy() const {
    const std::lock_guard lock(mutex_);
    return is_working_ || job_.has_value();
  }

 private:
  void run(std::function<Work()> open) {
    Work work;
    is_open_ = guard([&] { work = open(); });
    open = nullptr;
    while (const std::optional<Job> job = next()) {
      Desk desk(*this);
      if (is_open_) guard([&] { work(*job, desk); });
      {
        const std::lock_guard lock(mutex_);
        is_working_ = false;
      }
      tell_();
    }
    guard([&] { work = nullptr; });
  }

  std::optional<Job> next() {
    std::unique_lock lock(mutex_);
    wake_.wait(lock, [this] { return is_closing_ || job_.has_value(); });
    if (is_closing_) return std::nullopt;
    is_working_ = true;
    has_newer_ = false;
    return std::exchange(job_, std::nullopt);
  }

  /// Whether `work` came to its end, or to a cancellation. A thread's body must not throw.
  bool guard(const std::function<void()>& work) {
    try {
      std::optional<Failure> failure = guarded(work);
      if (!failure) return true;
      const std::lock_guard lock(mutex_);
      failure_ = std::move(failure);
      return false;
    } catch (const Error&) {  // guarded() lets cancellations through
      return true;
    }
  }

  const std::function<void()> tell_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Job> job_;
  std::optional<Result> result_;
  std::optional<Failure> failure_;
  bool is_closing_ = false, is_working_ = false, is_open_ = false;
  std::atomic<bool> has_newer_{false};
  std::thread thread_;  // last: starts when everything else is there
};

/// Ends long work with Error{cancelled} once its job is stale.
template <class Desk>
class StaleProgress final : public Progress {
 public:
  explicit StaleProgress(const Desk& desk) : desk_(desk) {}
  void begin(std::string_view, uint64_t) override {}
  void advance(uint64_t) override {
    if (desk_.is_stale()) throw Error(ErrorKind::cancelled, "something newer is wanted");
  }
  void end() override {}

 private:
  const Desk& desk_;
};

}  // namespace umbrameter
