// SPDX-License-Identifier: Apache-2.0
// Without these a renderer could draw again what it has, or hold more memory than it may.

#include "realtime/recently_used.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

TEST(RecentlyUsed, KeepsWhatFitsAndDropsWhatWasNotUsedForLongest) {
  RecentlyUsed<int> kept(100);
  for (const auto& [key, value] : {std::pair("a", 1), {"b", 2}}) {
    kept.make_room(50);
    kept.keep(key, std::make_shared<const int>(value), 50);
  }
  ASSERT_NE(kept.find("a"), nullptr);  // used after b now
  kept.make_room(50);
  kept.keep("c", std::make_shared<const int>(3), 50);
  EXPECT_EQ(kept.find("b"), nullptr);
  EXPECT_EQ(*kept.find("a"), 1);
  EXPECT_EQ(*kept.find("c"), 3);
}

TEST(RecentlyUsed, WhatNeverFitsStandsAlone) {
  RecentlyUsed<int> kept(100);
  kept.keep("small", std::make_shared<const int>(1), 10);
  kept.make_room(1000);
  kept.keep("large", std::make_shared<const int>(2), 1000);
  EXPECT_EQ(kept.find("small"), nullptr);
  EXPECT_EQ(*kept.find("large"), 2);
  kept.make_room(1);
  EXPECT_EQ(kept.find("large"), nullptr);
}

TEST(RecentlyUsed, WhatIsInUseOutlivesItsPlace) {
  RecentlyUsed<int> kept(1);
  kept.keep("a", std::make_shared<const int>(7), 1);
  const auto used = kept.find("a");
  kept.make_room(1);
  EXPECT_EQ(kept.find("a"), nullptr);
  EXPECT_EQ(*used, 7);
}

}  // namespace
}  // namespace umbrameter
