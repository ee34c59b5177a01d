// SPDX-License-Identifier: Apache-2.0
#pragma once
// One bar for many steps of known weight: what a step reports moves the bar within the step's share of it.

#include "core/progress.h"

#include <cstdint>
#include <mutex>

namespace umbrameter {

class ShareProgress final : public Progress {
 public:
  /// `whole` has begun with the sum of all shares.
  explicit ShareProgress(Progress& whole) : whole_(whole) {}

  void start_share(uint64_t share);
  /// What is left of the share.
  void end_share();

  void begin(std::string_view task, uint64_t total_steps) override;
  void advance(uint64_t steps) override;
  void end() override {}

 private:
  void reach(uint64_t place);

  Progress& whole_;
  std::mutex mutex_;  // guards what follows
  uint64_t share_ = 0;
  uint64_t place_ = 0;  // in the share
  uint64_t steps_ = 0, total_steps_ = 0;
};

}  // namespace umbrameter
