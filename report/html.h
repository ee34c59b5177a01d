#pragma once
// Text into HTML, safely.

#include <map>
#include <string>
#include <string_view>

namespace umbrameter {

/// `text` with & < > " ' as entities and bytes that are not UTF-8 or are control characters as U+FFFD; safe
/// in element content and in quoted attributes.
std::string escape_html(std::string_view text);

/// Replaces every {{key}} of `page` once by its value, as it stands. An unknown key is our bug.
std::string fill_template(std::string_view page,
                          const std::map<std::string, std::string, std::less<>>& values);

std::string encode_base64(std::string_view bytes);

}  // namespace umbrameter
