// SPDX-License-Identifier: Apache-2.0
#pragma once
// How long work reports how far it is. The bar itself is drawn by cli/.

#include <cstdint>
#include <string_view>

namespace umbrameter {

/// Receives progress. `advance` may be called from any thread; `begin` and `end` from the caller's only.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void begin(std::string_view task, uint64_t total_steps) = 0;
  virtual void advance(uint64_t steps) = 0;
  virtual void end() = 0;
};

/// Ignores everything.
class SilentProgress final : public Progress {
 public:
  void begin(std::string_view, uint64_t) override {}
  void advance(uint64_t) override {}
  void end() override {}
};

}  // namespace umbrameter
