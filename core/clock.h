#pragma once
// The clock that durations are taken with.

#include <chrono>

namespace umbrameter {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace umbrameter
