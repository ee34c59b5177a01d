// SPDX-License-Identifier: Apache-2.0
// Without these tests a scene's title could run as script in a page.

#include "core/html.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

TEST(EscapeHtml, LeavesNoMarkup) {
  EXPECT_EQ(escape_html("<a href=\"x\">'&'</a>"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
}

TEST(EscapeHtml, KeepsUtf8AndReplacesWhatIsNone) {
  EXPECT_EQ(escape_html("3 ± 1 µm"), "3 ± 1 µm");
  EXPECT_EQ(escape_html("a\xC3"), "a\xEF\xBF\xBD");                // cut off
  EXPECT_EQ(escape_html("\xC0\xBC"), "\xEF\xBF\xBD\xEF\xBF\xBD");  // '<' in two bytes is not UTF-8
  EXPECT_EQ(escape_html(std::string_view("\0\x1b", 2)), "\xEF\xBF\xBD\xEF\xBF\xBD");
}

}  // namespace
}  // namespace umbrameter
