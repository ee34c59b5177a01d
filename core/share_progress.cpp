// SPDX-License-Identifier: Apache-2.0
#include "core/share_progress.h"

#include <algorithm>

namespace umbrameter {

void ShareProgress::start_share(uint64_t share) {
  const std::lock_guard lock(mutex_);
  share_ = share;
  place_ = steps_ = total_steps_ = 0;
}

void ShareProgress::end_share() {
  const std::lock_guard lock(mutex_);
  reach(share_);
}

/// A second task within a step begins anew, and moves the bar only where it gets further than the first.
void ShareProgress::begin(std::string_view, uint64_t total_steps) {
  const std::lock_guard lock(mutex_);
  steps_ = 0;
  total_steps_ = total_steps;
}

void ShareProgress::advance(uint64_t steps) {
  const std::lock_guard lock(mutex_);
  steps_ += steps;
  if (total_steps_ == 0) return;
  const double done = std::min(1.0, static_cast<double>(steps_) / static_cast<double>(total_steps_));
  reach(static_cast<uint64_t>(done * static_cast<double>(share_)));
}

void ShareProgress::reach(uint64_t place) {
  if (place <= place_) return;
  whole_.advance(place - place_);
  place_ = place;
}

}  // namespace umbrameter
