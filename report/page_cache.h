// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether a results folder holds the page of given results already: making it again takes longer than everything else when
// nothing is rendered.

#include "store/lazy_store.h"

#include <filesystem>
#include <string>

namespace umbrameter {

/// Whether results.json in `out` is `json`, and report.html is still what this program made of it.
bool is_page_current(LazyStore& store, const std::filesystem::path& out, const std::string& json);

void keep_page(LazyStore& store, const std::filesystem::path& out, const std::string& json);

}  // namespace umbrameter
