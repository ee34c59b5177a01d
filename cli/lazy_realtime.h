// SPDX-License-Identifier: Apache-2.0
#pragma once
// The real-time renderer, whose device is known before it is opened (cli/device_cache.h).

#include "cli/home.h"
#include "cli/lazy_renderer.h"
#include "store/lazy_store.h"

#include <string>

namespace umbrameter {

class LazyRealtime {
 public:
  /// Opens the device at once when its identity is not known.
  LazyRealtime(LazyStore& store, const GlobalOptions& options, const Home& home, bool cull_casters);

  const std::string& identity() const { return identity_; }
  /// Error{environment} when it is opened and is another than was remembered.
  Renderer& renderer() { return renderer_; }
  /// Keeps the identity of a device that had to be opened.
  void keep_identity();

 private:
  std::unique_ptr<Renderer> open();

  LazyStore& store_;
  const GlobalOptions& options_;
  const Home& home_;
  bool cull_casters_;
  std::string identity_;  // empty: not known
  bool is_new_ = false;
  LazyRenderer renderer_;
};

}  // namespace umbrameter
