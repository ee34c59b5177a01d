#pragma once
// Ctrl-C: nothing half-written stays behind.

#include <filesystem>

namespace umbrameter {

/// From now on SIGINT and SIGTERM remove the registered folders and end the process with 128 + signal. Call
/// it before any thread starts: threads inherit the signal mask. A signal that is ignored (nohup) stays
/// ignored.
void install_interruption_handler();

/// Registers a folder while it lives.
class RemovedOnInterruption {
 public:
  explicit RemovedOnInterruption(std::filesystem::path folder);
  ~RemovedOnInterruption();
  RemovedOnInterruption(const RemovedOnInterruption&) = delete;
  RemovedOnInterruption& operator=(const RemovedOnInterruption&) = delete;

 private:
  std::filesystem::path folder_;
};

}  // namespace umbrameter
