// SPDX-License-Identifier: Apache-2.0
// Without these a change of a coarse map's grid could be called benign, or a fine map's be left out.
#include "metrics/faults/resolved.h"

#include "tests/unit/metrics/fault_scene.h"

#include <gtest/gtest.h>

namespace umbrameter {
namespace {

using testing::add_map;
using testing::box_ramp;
using testing::everywhere;
using testing::fault_floor;

// Two edges, 40 and 4 px wide.
Image two_edges() {
  return fault_floor(
      [](double x, double) { return std::min(1.0, box_ramp(0.6 - x, 0.4) + box_ramp(x - 1.9, 0.04)); });
}

std::optional<double> coarse(double texel_px) {
  const Image truth = two_edges();
  Image picture = truth;
  add_map(picture, texel_px);
  return share_of_coarse_edges(picture, truth, everywhere(truth));
}

TEST(Resolved, EdgesNarrowerThanTwoTexelsAreCoarse) {
  EXPECT_EQ(coarse(1.5), 0.0);
  // The narrow one alone; each edge counts by the profiles it has, and the wide one has three times as many.
  EXPECT_NEAR(*coarse(3.0), 0.25, 0.05);
  EXPECT_EQ(coarse(30.0), 1.0);
}

TEST(Resolved, ATexelBelowAPixelIsNeverCoarse) {
  EXPECT_EQ(coarse(0.9), 0.0);
}

TEST(Resolved, AShadowNarrowerThanTwoTexelsIsNot) {
  // A bar of 3 px and one of 30 px: an eleventh of the shade is the narrow one's.
  const Image truth = fault_floor([](double x, double) {
    const bool is_dark = (x > 0.5 && x < 0.53) || (x > 1.0 && x < 1.3);
    return is_dark ? 0.0 : 1.0;
  });
  const auto narrow = [&](double texel_px) {
    Image picture = truth;
    add_map(picture, texel_px);
    return share_of_narrow_shade(picture, truth, everywhere(truth));
  };
  EXPECT_EQ(narrow(1.3), 0.0);
  EXPECT_NEAR(narrow(1.6), 1.0 / 11.0, 0.005);
  EXPECT_NEAR(narrow(16.0), 1.0, 1e-9);
  EXPECT_EQ(share_of_narrow_shade(truth, truth, everywhere(truth)), 0.0);
}

TEST(Resolved, WithoutAMapOrAnEdgeNothingIsCoarse) {
  const Image truth = two_edges();
  EXPECT_FALSE(share_of_coarse_edges(truth, truth, everywhere(truth)));
  Image lit = fault_floor([](double, double) { return 1.0; });
  add_map(lit, 30.0);
  EXPECT_FALSE(share_of_coarse_edges(lit, lit, everywhere(lit)));
  EXPECT_TRUE(is_resolved({}));
}

TEST(Resolved, HalfOfTheEdgesMayBeCoarseAndATenthOfTheShadeNarrow) {
  EXPECT_TRUE(is_resolved({0.5, 0.1}));
  EXPECT_FALSE(is_resolved({0.51, 0.0}));
  EXPECT_FALSE(is_resolved({0.0, 0.11}));
}

}  // namespace
}  // namespace umbrameter
