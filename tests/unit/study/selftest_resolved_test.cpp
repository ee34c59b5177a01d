// SPDX-License-Identifier: Apache-2.0
// Without these a change of a coarse map's grid could be called benign, or a fine map's be left out.
#include "study/resolved.h"

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

TEST(Resolved, WithoutAMapOrAnEdgeNothingIsCoarse) {
  const Image truth = two_edges();
  EXPECT_FALSE(share_of_coarse_edges(truth, truth, everywhere(truth)));
  Image lit = fault_floor([](double, double) { return 1.0; });
  add_map(lit, 30.0);
  EXPECT_FALSE(share_of_coarse_edges(lit, lit, everywhere(lit)));
  EXPECT_TRUE(is_resolved(std::nullopt));
}

TEST(Resolved, HalfOfTheEdgesMayBeCoarse) {
  EXPECT_TRUE(is_resolved(0.5));
  EXPECT_FALSE(is_resolved(0.51));
}

}  // namespace
}  // namespace umbrameter
