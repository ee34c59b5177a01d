#include "study/html_text.h"

namespace umbrameter {

std::string escaped(const std::string& text, char what, const std::string& with) {
  std::string out;
  for (const char c : text) out += c == what ? with : std::string(1, c);
  return out;
}

std::string html_escaped(const std::string& text) {
  return escaped(escaped(escaped(escaped(text, '&', "&amp;"), '<', "&lt;"), '>', "&gt;"), '"', "&quot;");
}

std::string markdown_cell(const std::string& text) {
  return escaped(escaped(text, '|', "\\|"), '\n', " ");
}

}  // namespace umbrameter
