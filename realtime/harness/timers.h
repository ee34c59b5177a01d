#pragma once
// How long passes take on the GPU.

#include "core/renderer.h"
#include "realtime/harness/objects.h"

#include <chrono>
#include <span>
#include <string>
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
///   for each frame: begin_frame(is_counted); for each pass: begin(label) ... end(); end_frame()
/// A label may be timed many times a frame: its times are summed. Frames with is_counted = false warm up and
/// grow the pool of queries, so that counted frames of the same shape allocate and read back nothing.
class PassTimers {
 public:
  PassTimers(TimerKind kind, std::vector<std::string> labels);

  void begin_frame(bool is_counted);
  void begin(size_t label);
  void end();
  /// Waits for the GPU and collects the frame's times.
  void end_frame();

  /// Per label, in order, then "total" (the sum over labels, frame by frame).
  std::vector<PassTime> results() const;
  TimerKind kind() const { return kind_; }

 private:
  struct Interval {
    size_t label = 0;
    double ms = 0.0;
  };

  TimerKind kind_;
  std::vector<std::string> labels_;
  std::vector<Query> queries_;
  std::vector<Interval> intervals_;             // of the frame being timed
  std::vector<std::vector<double>> frames_ms_;  // [label][counted frame]
  std::chrono::steady_clock::time_point started_;
  bool is_counted_ = false;
  bool is_open_ = false;
};

/// Median, and median absolute deviation from it; both 0 for an empty span.
struct MedianSpread {
  double median = 0.0;
  double mad = 0.0;
};
MedianSpread median_spread(std::span<const double> values);

}  // namespace umbrameter
