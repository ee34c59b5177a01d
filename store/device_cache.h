// SPDX-License-Identifier: Apache-2.0
#pragma once
// The GL device's identity without a GL context: remembered in a store as long as nothing that could change it has.

#include "store/lazy_store.h"

#include <optional>
#include <string>

namespace umbrameter {

/// What keep_device() kept under `asked`, the device that was asked for (empty: any), unless another machine, other devices,
/// drivers or environment variables speak against it.
std::optional<std::string> find_device(LazyStore& store, const std::string& asked);

/// To be called while the device is open: the libraries that are loaded then are its driver.
void keep_device(LazyStore& store, const std::string& asked, const std::string& identity);

}  // namespace umbrameter
