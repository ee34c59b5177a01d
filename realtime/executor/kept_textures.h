// SPDX-License-Identifier: Apache-2.0
#pragma once
// Textures of earlier runs, for runs that would draw the same into theirs: between two values of a bias a shadow map stays.

#include "realtime/executor/contents.h"
#include "realtime/inspect.h"
#include "realtime/recently_used.h"

namespace umbrameter {

class KeptTextures {
 public:
  explicit KeptTextures(size_t budget_bytes) : budget_bytes_(budget_bytes), kept_(budget_bytes) {}

  /// Gives `plan`, which is not attached yet, what is there of what it would draw, and marks the steps that it need not draw.
  void give(const RunContents& contents, Plan& plan);
  /// Takes what the plan has drawn, for later runs.
  void take(const RunContents& contents, const Plan& plan);

  /// Lets go of all, so that what is timed has the memory to itself.
  void forget() { kept_.make_room(budget_bytes_); }

  const PassCounts& counts() const { return counts_; }

 private:
  size_t budget_bytes_;
  RecentlyUsed<Texture> kept_;
  PassCounts counts_;
};

/// Which of `contents.steps` must be drawn for `visibility` when the textures in `known` are there. Takes out of `known` what
/// has to be drawn all the same: because a step that must be drawn finds it as it is before its last change, or draws into it.
std::vector<bool> needed_steps(const RunContents& contents,
                               std::map<std::string, std::shared_ptr<const Texture>>& known);

}  // namespace umbrameter
