// SPDX-License-Identifier: Apache-2.0
#include "report/html.h"

#include "core/error.h"

#include <algorithm>
#include <cstdint>

namespace umbrameter {

std::string fill_template(std::string_view page,
                          const std::map<std::string, std::string, std::less<>>& values) {
  std::string html;
  while (true) {
    const size_t open = page.find("{{");
    html += page.substr(0, open);
    if (open == std::string_view::npos) return html;
    const size_t close = page.find("}}", open);
    UMBRAMETER_ASSERT(close != std::string_view::npos, "report template: an open {{");
    const auto found = values.find(page.substr(open + 2, close - open - 2));
    UMBRAMETER_ASSERT(found != values.end(), "report template: unknown key");
    html += found->second;
    page.remove_prefix(close + 2);
  }
}

std::string encode_base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0U);
    }
    const size_t present = std::min<size_t>(3, bytes.size() - i);
    for (size_t k = 0; k < 4; ++k) {
      text += k <= present ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace umbrameter
