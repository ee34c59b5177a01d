// SPDX-License-Identifier: Apache-2.0
#include "realtime/executor/barriers.h"

#include <map>
#include <string>
#include <vector>

namespace umbrameter {
namespace {

/// How a step uses a resource.
struct Use {
  std::string name;
  GLbitfield ways = 0;     // the barriers that order it behind stores of shaders
  GLbitfield store = 0;    // the one for stores into it
  bool is_stored = false;  // by the step's shader
};

struct Pending {
  GLbitfield unseen = 0;  // ways that would not see what was stored
  bool is_read = false;   // and stores must wait for it
  GLbitfield store = 0;
};

Use texture_use(const std::string& name, GLbitfield ways, bool is_stored) {
  return {name, ways, GL_SHADER_IMAGE_ACCESS_BARRIER_BIT, is_stored};
}

Use buffer_use(const std::string& name, GLbitfield more_ways, bool is_stored) {
  return {name, GL_SHADER_STORAGE_BARRIER_BIT | more_ways, GL_SHADER_STORAGE_BARRIER_BIT, is_stored};
}

Use write_use(const PassDeclaration& pass, const std::string& name, bool is_buffer) {
  switch (pass.kind) {
    case PassKind::compute: {
      const bool clears = pass.state.clear.has_value();
      if (is_buffer) return buffer_use(name, clears ? GL_BUFFER_UPDATE_BARRIER_BIT : 0, true);
      const GLbitfield clear = clears ? GL_TEXTURE_UPDATE_BARRIER_BIT : 0;
      return texture_use(name, GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | clear, true);
    }
    case PassKind::mipmap:
      return texture_use(name, GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT, false);
    case PassKind::scene:
    case PassKind::fullscreen:
    case PassKind::loop:
      break;
  }
  return texture_use(name, GL_FRAMEBUFFER_BARRIER_BIT, false);
}

std::vector<Use> uses_of(const PassDeclaration& pass, const Targets& targets) {
  std::vector<Use> uses;
  const auto is_buffer = [&](const std::string& name) { return targets.buffers().find(name) != nullptr; };
  for (const std::string& name : pass.reads)
    uses.push_back(is_buffer(name) ? buffer_use(name, 0, false)
                                   : texture_use(name, GL_TEXTURE_FETCH_BARRIER_BIT, false));
  for (const std::string& name : pass.writes) uses.push_back(write_use(pass, name, is_buffer(name)));
  return uses;
}

class Tracker {
 public:
  /// The barriers before a step; notes what it does.
  GLbitfield pass_by(const std::vector<Use>& uses) {
    GLbitfield barriers = 0;
    for (const Use& use : uses) {
      const Pending& pending = pending_[use.name];
      barriers |= pending.unseen & use.ways;
      if (use.is_stored && pending.is_read) barriers |= use.store;
    }
    wait(barriers);
    for (const Use& use : uses) note(use);
    return barriers;
  }

  bool has_stores() const { return has_stores_; }

 private:
  void wait(GLbitfield barriers) {
    for (auto& [name, pending] : pending_) {
      pending.unseen &= ~barriers;
      if ((pending.store & barriers) != 0) pending.is_read = false;
    }
  }

  void note(const Use& use) {
    Pending& pending = pending_[use.name];
    pending.store = use.store;
    pending.is_read = !use.is_stored;
    if (!use.is_stored) return;
    pending.unseen = GL_ALL_BARRIER_BITS;
    has_stores_ = true;
  }

  std::map<std::string, Pending> pending_;
  bool has_stores_ = false;
};

}  // namespace

void place_barriers(Plan& plan) {
  Tracker tracker;
  for (const bool once : {true, false}) {  // the order of the first frame; others leave the first ones out
    for (Step& step : plan.steps) {
      if (step.once != once || step.is_kept) continue;
      step.barriers = tracker.pass_by(uses_of(*plan.passes[step.pass].declaration, *plan.targets));
    }
  }
  plan.last_barriers = tracker.has_stores() ? GL_ALL_BARRIER_BITS : 0;
}

}  // namespace umbrameter
