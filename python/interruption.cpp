// SPDX-License-Identifier: Apache-2.0
#include "python/interruption.h"

#include "core/error.h"

#include <atomic>
#include <csignal>

namespace umbrameter::python {
namespace {

std::atomic<bool> interrupted{false};
std::atomic<bool> in_use{false};
struct sigaction previous;

void note(int) {
  interrupted = true;
}

}  // namespace

Interruptible::Interruptible() {
  is_first_ = !in_use.exchange(true);
  if (!is_first_) return;
  interrupted = false;
  struct sigaction action {};
  action.sa_handler = note;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &previous);
}

Interruptible::~Interruptible() {
  if (!is_first_) return;
  sigaction(SIGINT, &previous, nullptr);
  in_use = false;
}

bool is_interrupted() {
  return interrupted;
}

void InterruptibleProgress::check() {
  if (interrupted) throw Error(ErrorKind::cancelled, "interrupted");
}

}  // namespace umbrameter::python
