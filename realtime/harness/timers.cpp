// SPDX-License-Identifier: Apache-2.0
#include "realtime/harness/timers.h"

#include "core/error.h"

namespace umbrameter {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double query_ms(const Query& query) {
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query.id(), GL_QUERY_RESULT, &nanoseconds);
  return static_cast<double>(nanoseconds) * 1e-6;
}

}  // namespace

std::string_view to_text(TimerKind kind) {
  return kind == TimerKind::elapsed_query ? "GL_TIME_ELAPSED" : "glFinish + steady clock";
}

PassTimers::PassTimers(TimerKind kind, size_t label_count) : kind_(kind), label_count_(label_count) {}

void PassTimers::begin_frame() {
  UMBRAMETER_ASSERT(!is_open_, "{} intervals, the last still open", intervals_.size());
  intervals_.clear();
  glFinish();
}

void PassTimers::begin(size_t label) {
  UMBRAMETER_ASSERT(!is_open_ && label < label_count_, "label {} of {}", label, label_count_);
  is_open_ = true;
  const size_t index = intervals_.size();
  intervals_.push_back({label, 0.0});
  if (kind_ == TimerKind::finish_and_clock) {
    glFinish();
    started_ = Clock::now();
    return;
  }
  if (index == queries_.size()) queries_.push_back(make_query(GL_TIME_ELAPSED));
  glBeginQuery(GL_TIME_ELAPSED, queries_[index].id());
}

void PassTimers::end() {
  UMBRAMETER_ASSERT(is_open_, "{} intervals, none open", intervals_.size());
  is_open_ = false;
  if (kind_ == TimerKind::elapsed_query) {
    glEndQuery(GL_TIME_ELAPSED);
    return;
  }
  glFinish();
  intervals_.back().ms = milliseconds_since(started_);
}

std::vector<double> PassTimers::end_frame() {
  UMBRAMETER_ASSERT(!is_open_, "{} intervals, the last still open", intervals_.size());
  glFinish();
  std::vector<double> sums_ms(label_count_, 0.0);
  for (size_t i = 0; i < intervals_.size(); ++i) {
    sums_ms[intervals_[i].label] +=
        kind_ == TimerKind::elapsed_query ? query_ms(queries_[i]) : intervals_[i].ms;
  }
  return sums_ms;
}

}  // namespace umbrameter
