// SPDX-License-Identifier: Apache-2.0
#pragma once
// Does a script's steps in a window, one after the other.

#include "view/live_view.h"

namespace umbrameter {

class ScriptRun {
 public:
  ScriptRun(LiveView& view, const std::vector<ScriptStep>& steps) : view_(view), steps_(steps) {}

  /// Goes on as far as can be before the next picture of the window; false once everything is done. Error{input} for a step
  /// that cannot be.
  bool advance();
  bool is_done() const { return next_ >= steps_.size(); }

 private:
  bool is_waiting(const ScriptStep& step);
  bool is_there(const ScriptStep& step) const;
  void act(const ScriptStep& step);
  void press(const ScriptStep& step, bool is_down, bool is_up);
  void drag(const ScriptStep& step);
  void set_parameter(const ScriptStep& step);

  LiveView& view_;
  const std::vector<ScriptStep>& steps_;
  size_t next_ = 0;
  int count_ = 0;  // within the step: frames, drawings
  int drawings_seen_ = 0;
  bool has_begun_ = false;
  Clock::time_point begun_ = Clock::now();
};

}  // namespace umbrameter
