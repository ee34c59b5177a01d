// SPDX-License-Identifier: Apache-2.0
// Without these a mistyped file name would be met with no help, or with the wrong one.

#include "core/file_hint.h"

#include "core/names.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace umbrameter {
namespace {

TEST(FileHint, NamesTheNearestEntryOfTheSameFolder) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "small.toml") << "a";
  std::ofstream(folder.path() / "stress.toml") << "a";
  EXPECT_EQ(hint_for_missing(folder.path() / "smal.toml"),
            "did you mean '" + (folder.path() / "small.toml").string() + "'?");
  EXPECT_EQ(hint_for_missing(folder.path() / "quite-another-thing.exr"), "");
}

TEST(FileHint, SaysThatTheFolderIsMissing) {
  const TemporaryFolder folder;
  EXPECT_EQ(hint_for_missing(folder.path() / "no/small.toml"),
            "there is no folder '" + (folder.path() / "no").string() + "'");
}

TEST(NearestName, PrefersTheNameThatBeginsAlike) {
  const std::vector<std::string> known{"pcf", "pcss"};
  EXPECT_EQ(nearest_name("pcs", known), "pcss");
  EXPECT_EQ(nearest_name("pcg", known), "pcf");
  EXPECT_EQ(nearest_name("xyz", known), "");
}

}  // namespace
}  // namespace umbrameter
