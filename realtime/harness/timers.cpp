#include "realtime/harness/timers.h"

#include "core/error.h"
#include "core/statistics.h"

#include <algorithm>
#include <cmath>

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

PassTimers::PassTimers(TimerKind kind, std::vector<std::string> labels)
    : kind_(kind), labels_(std::move(labels)), frames_ms_(labels_.size()) {}

void PassTimers::begin_frame(bool is_counted) {
  UMBRAMETER_ASSERT(!is_open_, "{} intervals, the last still open", intervals_.size());
  is_counted_ = is_counted;
  intervals_.clear();
  glFinish();
}

void PassTimers::begin(size_t label) {
  UMBRAMETER_ASSERT(!is_open_ && label < labels_.size(), "label {} of {}", label, labels_.size());
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

void PassTimers::end_frame() {
  UMBRAMETER_ASSERT(!is_open_, "{} intervals, the last still open", intervals_.size());
  glFinish();
  if (!is_counted_) return;
  std::vector<double> sums(labels_.size(), 0.0);
  for (size_t i = 0; i < intervals_.size(); ++i) {
    sums[intervals_[i].label] += kind_ == TimerKind::elapsed_query ? query_ms(queries_[i]) : intervals_[i].ms;
  }
  for (size_t label = 0; label < sums.size(); ++label) frames_ms_[label].push_back(sums[label]);
}

std::vector<PassTime> PassTimers::results() const {
  std::vector<PassTime> results;
  const auto add = [&](const std::string& label, const std::vector<double>& frames_ms) {
    const MedianSpread spread = median_spread(frames_ms);
    results.push_back({label, spread.median, spread.mad, static_cast<int>(frames_ms.size())});
  };
  std::vector<double> totals_ms(frames_ms_.empty() ? 0 : frames_ms_.front().size(), 0.0);
  for (size_t label = 0; label < labels_.size(); ++label) {
    add(labels_[label], frames_ms_[label]);
    for (size_t frame = 0; frame < totals_ms.size(); ++frame) totals_ms[frame] += frames_ms_[label][frame];
  }
  add("total", totals_ms);
  return results;
}

MedianSpread median_spread(std::span<const double> values) {
  if (values.empty()) return {};
  const double middle = median(std::vector<double>(values.begin(), values.end()));
  std::vector<double> deviations;
  for (const double value : values) deviations.push_back(std::abs(value - middle));
  return {middle, median(std::move(deviations))};
}

}  // namespace umbrameter
