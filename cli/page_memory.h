// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether a results folder holds the page of given results already: making it again takes longer than everything else when
// nothing is rendered.

#include "store/late_store.h"

#include <filesystem>
#include <string>

namespace umbrameter {

/// Whether results.json in `out` is `json`, and report.html is still what this program made of it.
bool is_page_current(LateStore& store, const std::filesystem::path& out, const std::string& json);

void remember_page(LateStore& store, const std::filesystem::path& out, const std::string& json);

}  // namespace umbrameter
