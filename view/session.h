// SPDX-License-Identifier: Apache-2.0
#pragma once
// Keeps drawing, truth and metrics up with what is chosen. Knows no window: everything that takes time runs on threads of
// its own, and update() never waits for them.

#include "core/clock.h"
#include "view/draw_worker.h"
#include "view/judge_worker.h"
#include "view/state.h"
#include "view/truth_worker.h"
#include "view/view.h"

#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace umbrameter {

class Session {
 public:
  /// `tell` is called from any thread when update() has something to do.
  Session(const ViewSetup& setup, const std::function<void()>& tell);

  /// To be called before every picture of the window. True when there is something new to show.
  bool update(const ViewState& state);

  /// The newest picture of the technique, at whatever size and place; null before the first.
  std::shared_ptr<const Image> test() const { return test_; }
  const Drawing* drawing() const { return drawing_ ? &*drawing_ : nullptr; }
  /// The truth of what is shown; null while it is not there yet.
  const TruthPass* truth(const ViewState& state) const;
  /// The newest scores of what is shown, maybe with an earlier pass of the truth.
  const Judged* judged(const ViewState& state) const;
  /// Whether the picture is of what is chosen, at full size.
  bool is_full(const ViewState& state) const;
  /// Whether what is chosen could not be drawn.
  bool has_failed(const ViewState& state) const;
  bool is_moving() const { return seconds_since(last_motion_) < kRest_s; }
  bool is_working() const { return draws_.is_busy() || truths_.is_busy() || judges_.is_busy(); }
  /// Why the newest picture could not be drawn; empty when it could.
  const std::string& problem() const { return problem_; }
  const std::string& judge_problem() const { return judge_problem_; }
  /// Times between pictures that came while the camera moved, the newest last.
  const std::deque<double>& moving_intervals_s() const { return moving_intervals_s_; }
  int drawings() const { return drawings_; }
  /// What the last picture at full size took; 0 before there is one.
  double full_frame_s() const { return full_frame_s_; }

 private:
  static constexpr double kRest_s = 0.15;  // without motion before a full picture is drawn

  bool take_drawing(const ViewState& state);
  bool take_truth();
  bool take_judged();
  void ask_drawing(const ViewState& state);
  void ask_truth(const ViewState& state);
  void ask_judge(const ViewState& state);
  int divisor() const;

  DrawWorker draws_;
  TruthWorker truths_;
  JudgeWorker judges_;

  std::optional<Drawing> drawing_;
  std::shared_ptr<const Image> test_;
  std::optional<TruthPass> truth_;
  std::optional<Judged> judged_;
  std::string problem_, judge_problem_;
  uint64_t failed_run_version_ = 0, failed_place_version_ = 0;

  uint64_t asked_place_ = 0, asked_run_ = 0, asked_truth_ = 0;
  int asked_width_px_ = 0;
  std::string asked_extras_;
  uint64_t judged_place_ = 0, judged_run_ = 0;
  int judged_pass_ = -1;
  Clock::time_point last_motion_{}, last_drawing_{};
  double seconds_per_pixel_ = 0.0;  // of drawing; 0 before the first picture
  double full_frame_s_ = 0.0;
  int drawings_ = 0;
  std::deque<double> moving_intervals_s_;
};

}  // namespace umbrameter
