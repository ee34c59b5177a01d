// SPDX-License-Identifier: Apache-2.0
#pragma once
// Ctrl-C: nothing half-written stays behind.

#include <filesystem>
#include <string>
#include <vector>

namespace umbrameter {

/// From now on SIGINT and SIGTERM remove the registered places and end the process with 128 + signal. Call
/// it before any thread starts: threads inherit the signal mask. A signal that is ignored (nohup) stays
/// ignored.
void install_interruption_handler();

/// What is said then, instead of "nothing was written".
void set_interruption_note(const std::string& note);

/// A folder to be removed, and the parents that were made for it, innermost first, to be removed when empty.
struct TemporaryPlace {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> made_parents;
};

/// Removes the place; never throws.
void remove_place(const TemporaryPlace& place);

/// The interruption handler removes `place` while this lives.
class RemovedOnInterruption {
 public:
  explicit RemovedOnInterruption(const TemporaryPlace& place);
  ~RemovedOnInterruption();
  RemovedOnInterruption(const RemovedOnInterruption&) = delete;
  RemovedOnInterruption& operator=(const RemovedOnInterruption&) = delete;

 private:
  std::filesystem::path folder_;
};

}  // namespace umbrameter
