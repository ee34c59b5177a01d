// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text into HTML, safely.

#include <string>
#include <string_view>

namespace umbrameter {

/// `text` with & < > " ' as entities and bytes that are not UTF-8 or are control characters as U+FFFD; safe
/// in element content and in quoted attributes.
std::string escape_html(std::string_view text);

}  // namespace umbrameter
