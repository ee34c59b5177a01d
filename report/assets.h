// SPDX-License-Identifier: Apache-2.0
#pragma once
// The files of report/assets, embedded at build time.

#include <string_view>

namespace umbrameter {

/// The text of report/assets/<name>.
std::string_view report_asset(std::string_view name);

}  // namespace umbrameter
