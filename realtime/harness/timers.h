// SPDX-License-Identifier: Apache-2.0
#pragma once
// How long passes take on the GPU.

#include "realtime/harness/objects.h"

#include <chrono>
#include <string_view>
#include <vector>

namespace umbrameter {

enum class TimerKind { elapsed_query, finish_and_clock };

/// "GL_TIME_ELAPSED" or "glFinish + steady clock": what Frame::timer says.
std::string_view to_text(TimerKind kind);

/// Runs known work under GL_TIME_ELAPSED and a wall clock. elapsed_query only if no query claims more time
/// than passed on the wall (a software rasteriser has returned the machine's uptime for a lone clear) and a
/// long vertex-bound draw is counted in full (software rasterisers leave out what runs on the calling
/// thread).
TimerKind choose_timer();

/// Times labelled passes over frames. Use:
///   for each frame: begin_frame(); for each pass: begin(label) ... end(); end_frame()
/// A label may be timed many times a frame: its times are summed. The first frame grows the pool of queries, so that
/// later frames of the same shape allocate and read back nothing before their end.
class PassTimers {
 public:
  PassTimers(TimerKind kind, size_t label_count);

  void begin_frame();
  void begin(size_t label);
  void end();
  /// Waits for the GPU; ms of each label.
  std::vector<double> end_frame();

  TimerKind kind() const { return kind_; }

 private:
  struct Interval {
    size_t label = 0;
    double ms = 0.0;
  };

  TimerKind kind_;
  size_t label_count_ = 0;
  std::vector<Query> queries_;
  std::vector<Interval> intervals_;  // of the frame being timed
  std::chrono::steady_clock::time_point started_;
  bool is_open_ = false;
};

}  // namespace umbrameter
