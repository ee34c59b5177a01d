// SPDX-License-Identifier: Apache-2.0
// Without these the truth of foliage could be that of solid cards, or of cards shifted by half a texel.

#include "reference/exact_check.h"
#include "tests/statistical/agreement.h"
#include "tests/statistical/oracle_scenes.h"
#include "tests/support/cutout_card.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include <cmath>

namespace umbrameter {
namespace {

constexpr double kPeriod = 0.1;  // the square light's footprint on the card is 0.2 wide: whole periods

const AlphaMask kCheckerboard = pattern_mask({"#.", ".#"});
const AlphaMask kLeaves = pattern_mask({"#.#.", "....", ".##.", "#..."});

Scene floor_under_card(const AlphaMask& mask) {
  Scene scene = floor_under(rect_light_above({0, kLightHeight, 0}, {1, 1}), 0.4);
  add_cutout_card(scene, mask, {8, 8}, kOccluderHeight, kPeriod);
  finish_scene(scene);
  return scene;
}

TEST(Cutouts, a_light_as_wide_as_whole_periods_shines_through_the_share_of_the_holes) {
  for (const AlphaMask& mask : {kCheckerboard, kLeaves}) {
    const double share = hole_share(mask);
    const Frame frame = render_reference(floor_under_card(mask));
    const Agreement agreement = compare(frame, [share](const glm::dvec3&) { return share; });
    EXPECT_EQ(objection(agreement), "") << share;
    // Stratified samples do better than as many coins.
    EXPECT_LT(agreement.rmse, std::sqrt(share * (1.0 - share) / ReferencePicture{}.samples_per_pixel))
        << share;
  }
}

TEST(Cutouts, the_masks_texels_lie_where_their_coordinates_say) {
  // A light so small that each point sees one texel: from p the ray meets the card at 4/5 p.
  Scene scene = floor_under(rect_light_above({0, kLightHeight, 0}, {1e-4, 1e-4}), 0.4);
  add_cutout_card(scene, kLeaves, {8, 8}, kOccluderHeight, kPeriod);
  finish_scene(scene);
  const Frame frame = render_reference(scene);
  const auto visibility = frame.image.plane("visibility");
  size_t wrong = 0;
  for (size_t i = 0; i < visibility.size(); ++i) {
    const glm::vec2 uv(position_of(frame, i).x * (1.0 - kFraction) / kPeriod,
                       position_of(frame, i).z * (1.0 - kFraction) / kPeriod);
    const glm::vec2 in_texel = glm::fract(4.0f * uv) - 0.5f;
    if (std::max(std::abs(in_texel.x), std::abs(in_texel.y)) > 0.49f) continue;  // the light's own width
    wrong += visibility[i] == (is_hole(kLeaves, uv) ? 1.0f : 0.0f) ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(Cutouts, a_card_that_is_all_there_is_as_dark_as_a_solid_one_but_proves_nothing) {
  const Frame frame = render_reference(floor_under_card(pattern_mask({"#"})));
  for (const float v : frame.image.plane("visibility")) ASSERT_EQ(v, 0.0f);
  for (const float samples : frame.image.plane("sample_count")) ASSERT_GT(samples, 0.0f);
}

TEST(Cutouts, a_card_that_is_all_hole_is_not_there) {
  const Frame frame = render_reference(floor_under_card(pattern_mask({"."})));
  for (const float v : frame.image.plane("visibility")) ASSERT_EQ(v, 1.0f);
  for (const float distance : frame.image.plane("blocker_distance")) ASSERT_EQ(distance, 0.0f);
}

TEST(Cutouts, the_exact_oracle_says_that_it_cannot) {
  const Scene scene = floor_under_card(kLeaves);
  EXPECT_THROW(require_exact(scene), Error);
}

}  // namespace
}  // namespace umbrameter
