// SPDX-License-Identifier: Apache-2.0
#include "results/table_text.h"

namespace umbrameter {

std::string escaped(const std::string& text, char what, const std::string& with) {
  std::string out;
  for (const char c : text) out += c == what ? with : std::string(1, c);
  return out;
}

std::string markdown_cell(const std::string& text) {
  return escaped(escaped(text, '|', "\\|"), '\n', " ");
}

}  // namespace umbrameter
