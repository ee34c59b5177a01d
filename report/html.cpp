// SPDX-License-Identifier: Apache-2.0
#include "report/html.h"

#include "core/error.h"

#include <OpenImageIO/strutil.h>

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
  return OIIO::Strutil::base64_encode({bytes.data(), bytes.size()});
}

}  // namespace umbrameter
