// SPDX-License-Identifier: Apache-2.0
#include "core/guard.h"

#include <new>

namespace umbrameter {

std::optional<Failure> guarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) throw;
    return Failure{error.kind(), error.what()};
  } catch (const std::bad_alloc&) {
    return Failure{ErrorKind::environment, "not enough memory (try a smaller resolution)"};
  } catch (const std::exception& error) {
    return Failure{ErrorKind::internal, error.what()};
  }
  return std::nullopt;
}

}  // namespace umbrameter
