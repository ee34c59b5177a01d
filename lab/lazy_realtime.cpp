// SPDX-License-Identifier: Apache-2.0
#include "lab/lazy_realtime.h"

#include "core/error.h"
#include "store/device_cache.h"

#include <utility>

namespace umbrameter {

LazyRealtime::LazyRealtime(LazyStore& store, DeviceOpener device)
    : store_(store),
      device_(std::move(device)),
      identity_(find_device(store, device_.asked).value_or("")),
      renderer_([this] { return open(); }) {
  if (identity_.empty()) renderer_.renderer();
}

std::unique_ptr<Renderer> LazyRealtime::open() {
  auto opened = device_.open();
  const std::string found = device_.identity_of(*opened);
  is_new_ = found != identity_;
  if (identity_.empty()) identity_ = found;
  if (found == identity_) return opened;
  keep_device(store_, device_.asked, found);
  fail_environment(fmt::format("the GL device is '{}' now, and was '{}'", found, identity_),
                   "run again: what the other device made is not used then");
}

void LazyRealtime::keep_identity() {
  if (is_new_) keep_device(store_, device_.asked, identity_);
}

}  // namespace umbrameter
