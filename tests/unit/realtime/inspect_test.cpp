// SPDX-License-Identifier: Apache-2.0
// Without these --dump could show another layer than the one asked for.
#include "realtime/inspect.h"

#include "core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace umbrameter {
namespace {

TEST(ResourcePart, IsNameLayerLevel) {
  EXPECT_EQ(parse_resource_part("shadow_map").resource, "shadow_map");
  EXPECT_EQ(parse_resource_part("shadow_map").layer, 0);
  EXPECT_EQ(parse_resource_part("gbuffer.normal:2").resource, "gbuffer.normal");
  EXPECT_EQ(parse_resource_part("chain:2").layer, 2);
  EXPECT_EQ(parse_resource_part("chain:2:5").level, 5);
}

TEST(ResourcePart, AnythingElseIsASentence) {
  for (const char* text : {"", ":1", "map:", "map:x", "map:-1", "map:1:", "map:1:2:3", "map:1.5", "map: 1"}) {
    try {
      parse_resource_part(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_THAT(error.what(), testing::HasSubstr("RESOURCE:LAYER")) << text;
      EXPECT_THAT(error.what(), testing::HasSubstr(std::string("'") + text + "'"));
    }
  }
}

}  // namespace
}  // namespace umbrameter
