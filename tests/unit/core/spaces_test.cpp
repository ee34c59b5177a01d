// SPDX-License-Identifier: Apache-2.0
// Without these: a sign or a row flip could hide in both renderers at once.
#include "core/spaces.h"

#include <gtest/gtest.h>

#include <numbers>

namespace umbrameter {
namespace {

constexpr double kFov = std::numbers::pi / 2;  // half height tan = 1

TEST(Spaces, ViewLooksAlongMinusZ) {
  const glm::dvec4 p_view = view_from_world({0, 0, 5}, {0, 0, 0}, {0, 1, 0}) * glm::dvec4(1, 2, 0, 1);
  EXPECT_EQ(p_view, glm::dvec4(1, 2, -5, 1));
}

TEST(Spaces, ReversedDepthIsOneAtTheNearPlaneAndFallsAsNearOverDistance) {
  const glm::dmat4 clip = clip_from_view(kFov, 1.0, 0.1);
  for (const double z : {0.1, 1.0, 1000.0}) {
    const glm::dvec4 p = clip * glm::dvec4(0, 0, -z, 1);
    EXPECT_DOUBLE_EQ(p.z / p.w, 0.1 / z);
  }
}

TEST(Spaces, RowZeroIsOnTop) {
  const glm::dmat4 clip = clip_from_view(kFov, 2.0, 0.1);
  // At distance 1 the picture spans y in [-1, 1] and x in [-2, 2]: (1.5, 0.75) is 7/8 to the right, 1/8 from
  // the top.
  const glm::dvec2 px = pixel_of_clip(clip * glm::dvec4(1.5, 0.75, -1, 1), 400, 200);
  EXPECT_NEAR(px.x, 350.0, 1e-9);
  EXPECT_NEAR(px.y, 25.0, 1e-9);
}

TEST(Spaces, PixelDirectionAndProjectionAreInverse) {
  const glm::dvec2 p_px(13.5, 77.25);
  const glm::dvec3 direction = view_direction_of_pixel(p_px, 320, 180, 1.1);
  const glm::dvec2 back =
      pixel_of_clip(clip_from_view(1.1, 320.0 / 180.0, 0.1) * glm::dvec4(7.0 * direction, 1), 320, 180);
  EXPECT_NEAR(back.x, p_px.x, 1e-9);
  EXPECT_NEAR(back.y, p_px.y, 1e-9);
}

TEST(Spaces, StoredDepthAndDistanceAreInverse) {
  EXPECT_DOUBLE_EQ(perspective_depth(0.5, 0.5, 20), 1.0);
  EXPECT_DOUBLE_EQ(perspective_depth(20, 0.5, 20), 0.0);
  EXPECT_DOUBLE_EQ(orthographic_depth(2, 2, 10), 1.0);
  EXPECT_DOUBLE_EQ(orthographic_depth(10, 2, 10), 0.0);
  for (const double z : {0.5, 0.7, 3.0, 19.9}) {
    EXPECT_NEAR(perspective_distance(perspective_depth(z, 0.5, 20), 0.5, 20), z, 1e-12 * z);
    EXPECT_NEAR(orthographic_distance(orthographic_depth(z, 0.5, 20), 0.5, 20), z, 1e-12 * z);
  }
}

}  // namespace
}  // namespace umbrameter
