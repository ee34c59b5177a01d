// SPDX-License-Identifier: Apache-2.0
#pragma once
// The real-time renderer, whose device is known before it is opened (store/device_cache.h).

#include "lab/lazy_renderer.h"
#include "store/lazy_store.h"

#include <functional>
#include <memory>
#include <string>

namespace umbrameter {

/// How the device that was asked for is opened, and what it says of itself then.
struct DeviceOpener {
  std::string asked;  // empty: any
  std::function<std::unique_ptr<Renderer>()> open;
  std::function<std::string(const Renderer&)> identity_of;
};

class LazyRealtime {
 public:
  /// Opens the device at once when its identity is not known.
  LazyRealtime(LazyStore& store, DeviceOpener device);

  const std::string& identity() const { return identity_; }
  /// Error{environment} when it is opened and is another than was remembered.
  Renderer& renderer() { return renderer_; }
  /// Keeps the identity of a device that had to be opened.
  void keep_identity();

 private:
  std::unique_ptr<Renderer> open();

  LazyStore& store_;
  DeviceOpener device_;
  std::string identity_;  // empty: not known
  bool is_new_ = false;
  LazyRenderer renderer_;
};

}  // namespace umbrameter
