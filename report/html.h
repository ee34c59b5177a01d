// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the page's text is put together with. Not here: escaping (core/html.h).

#include <map>
#include <string>
#include <string_view>

namespace umbrameter {

/// Replaces every {{key}} of `page` once by its value, as it stands. An unknown key is our bug.
std::string fill_template(std::string_view page,
                          const std::map<std::string, std::string, std::less<>>& values);

std::string encode_base64(std::string_view bytes);

}  // namespace umbrameter
