// SPDX-License-Identifier: Apache-2.0
#include "cli/lazy_realtime.h"

#include "cli/device_cache.h"
#include "cli/run_renderer.h"
#include "core/error.h"

namespace umbrameter {

LazyRealtime::LazyRealtime(LazyStore& store, const GlobalOptions& options, const Home& home,
                           bool cull_casters)
    : store_(store),
      options_(options),
      home_(home),
      cull_casters_(cull_casters),
      identity_(find_device(store, options).value_or("")),
      renderer_([this] { return open(); }) {
  if (identity_.empty()) renderer_.renderer();
}

std::unique_ptr<Renderer> LazyRealtime::open() {
  auto opened = open_realtime_renderer(options_, home_, cull_casters_);
  const std::string found = run_identity(*opened);
  is_new_ = found != identity_;
  if (identity_.empty()) identity_ = found;
  if (found == identity_) return opened;
  keep_device(store_, options_, found);
  fail_environment(fmt::format("the GL device is '{}' now, and was '{}'", found, identity_),
                   "run again: what the other device made is not used then");
}

void LazyRealtime::keep_identity() {
  if (is_new_) keep_device(store_, options_, identity_);
}

}  // namespace umbrameter
