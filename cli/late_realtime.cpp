// SPDX-License-Identifier: Apache-2.0
#include "cli/late_realtime.h"

#include "cli/device_memory.h"
#include "cli/run_renderer.h"
#include "core/error.h"

namespace umbrameter {

LateRealtime::LateRealtime(LateStore& store, const GlobalOptions& options, const Home& home,
                           bool cull_casters)
    : store_(store),
      options_(options),
      home_(home),
      cull_casters_(cull_casters),
      identity_(recall_device(store, options).value_or("")),
      renderer_([this] { return open(); }) {
  if (identity_.empty()) renderer_.renderer();
}

std::unique_ptr<Renderer> LateRealtime::open() {
  auto opened = open_realtime_renderer(options_, home_, cull_casters_);
  const std::string found = run_identity(*opened);
  is_new_ = found != identity_;
  if (identity_.empty()) identity_ = found;
  if (found == identity_) return opened;
  remember_device(store_, options_, found);
  fail_environment(fmt::format("the GL device is '{}' now, and was '{}'", found, identity_),
                   "run again: what the other device made is not used then");
}

void LateRealtime::remember() {
  if (is_new_) remember_device(store_, options_, identity_);
}

}  // namespace umbrameter
