// SPDX-License-Identifier: Apache-2.0
#pragma once
// The GL device's identity without a GL context: remembered in a store as long as nothing that could change it has.

#include "cli/verbs.h"
#include "store/lazy_store.h"

#include <optional>
#include <string>

namespace umbrameter {

/// What keep_device() kept, unless another machine, other devices, drivers, environment variables or options speak
/// against it.
std::optional<std::string> find_device(LazyStore& store, const GlobalOptions& options);

/// To be called while the device is open: the libraries that are loaded then are its driver.
void keep_device(LazyStore& store, const GlobalOptions& options, const std::string& identity);

}  // namespace umbrameter
