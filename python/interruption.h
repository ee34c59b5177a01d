// SPDX-License-Identifier: Apache-2.0
#pragma once
// Ctrl-C while C++ is at work and Python is not listening.

#include "core/progress.h"

namespace umbrameter::python {

/// While it lives, Ctrl-C is noted instead of ending anything. One at a time does so; further ones, in other threads, note
/// nothing.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  bool is_first_ = false;
};

/// True since Ctrl-C was noted, until the Interruptible ends.
bool is_interrupted();

/// Throws Error{cancelled} at the next step after Ctrl-C.
class InterruptibleProgress final : public Progress {
 public:
  void begin(std::string_view, uint64_t) override { check(); }
  void advance(uint64_t) override { check(); }
  void end() override {}
  static void check();
};

}  // namespace umbrameter::python
