// SPDX-License-Identifier: Apache-2.0
// Without these, shadow maps would be fitted to something else than what the camera sees.

#include "realtime/executor/receivers.h"

#include <gtest/gtest.h>

#include <array>

namespace umbrameter {
namespace {

/// A G-buffer that shows nothing; receivers are put in by `put`.
Image empty_gbuffer(int width_px, int height_px) {
  Image image(width_px, height_px);
  for (const char* channel : {"position.x", "position.y", "position.z", "unshadowed_irradiance"}) {
    image.add_plane(channel);
  }
  image.add_plane("primitive_id", -1.0f);
  return image;
}

void put(Image& image, int x, int y, const glm::vec3& p_world, float irradiance = 1.0f) {
  const auto pixel = static_cast<size_t>(y * image.width + x);
  image.plane("position.x")[pixel] = p_world.x;
  image.plane("position.y")[pixel] = p_world.y;
  image.plane("position.z")[pixel] = p_world.z;
  image.plane("primitive_id")[pixel] = 0.0f;
  image.plane("unshadowed_irradiance")[pixel] = irradiance;
}

TEST(ReceiverTiles, BoxTheReceiversOfEachTileAndSkipEmptyOnes) {
  Image image = empty_gbuffer(40, 20);  // 3 x 2 tiles of 16 px, the last ones cut
  put(image, 0, 0, {1, 2, 3});
  put(image, 15, 15, {-1, 5, 3});
  put(image, 39, 19, {9, 9, 9});
  const auto tiles = receiver_tiles(image);
  ASSERT_EQ(tiles.size(), 2u);
  EXPECT_EQ(tiles[0].min_world, glm::vec3(-1, 2, 3));
  EXPECT_EQ(tiles[0].max_world, glm::vec3(1, 5, 3));
  EXPECT_EQ(tiles[1].min_world, glm::vec3(9));
}

TEST(ReceiverTiles, SurfacesTheLightCannotReachAreNoReceivers) {
  Image image = empty_gbuffer(16, 16);
  put(image, 3, 3, {1, 1, 1}, 0.0f);
  EXPECT_TRUE(receiver_tiles(image).empty());
}

/// At the origin, looking along +z.
Camera camera_along_z() {
  Camera camera;
  camera.eye_world = {0, 0, 0};
  camera.at_world = {0, 0, 1};
  camera.near_world = 0.1;
  return camera;
}

TEST(ReceiverTiles, OfASliceHoldNothingBeforeOrBehindIt) {
  Image image = empty_gbuffer(16, 1);
  put(image, 0, 0, {0, 0, 2});
  put(image, 1, 0, {1, 0, 4});
  put(image, 2, 0, {5, 0, 6});
  const auto tiles = receiver_tiles(image, camera_along_z(), {3.0, 5.0});
  ASSERT_EQ(tiles.size(), 1u);
  EXPECT_EQ(tiles[0].min_world, glm::vec3(1, 0, 4));
  EXPECT_EQ(tiles[0].max_world, glm::vec3(1, 0, 4));
}

TEST(ReceiverRange, IsAlongTheCamerasAxis) {
  Image image = empty_gbuffer(16, 1);
  put(image, 0, 0, {30, 0, 2});  // far off, but only 2 along the axis
  put(image, 1, 0, {0, 0, 7});
  put(image, 2, 0, {0, 0, 9}, 0.0f);  // no receiver
  EXPECT_DOUBLE_EQ(receiver_range(image, camera_along_z()).near_world, 2.0);
  EXPECT_DOUBLE_EQ(receiver_range(image, camera_along_z()).far_world, 7.0);
  EXPECT_DOUBLE_EQ(receiver_range(empty_gbuffer(2, 2), camera_along_z()).far_world, 0.2);
}

/// Looks along +z from the origin, 90 degrees wide: x/z and y/z from -1 to 1.
LightView square_view() {
  LightView view;
  view.lateral_bounds = {-1, -1, 1, 1};
  view.near_world = 0.1f;
  view.far_world = 10.0f;
  return view;
}

TEST(ShareOutside, CountsReceiversBesideAndBehindTheView) {
  Image image = empty_gbuffer(16, 1);
  put(image, 0, 0, {0, 0, 2});
  put(image, 1, 0, {1.9, 0, 2});
  put(image, 2, 0, {2.1, 0, 2});      // beside
  put(image, 3, 0, {0, 0, -2});       // behind
  put(image, 4, 0, {9, 0, 2}, 0.0f);  // no receiver
  EXPECT_DOUBLE_EQ(share_outside(image, std::array{square_view()}), 0.5);
}

TEST(ShareOutside, IsWhatNoneOfSeveralViewsCovers) {
  LightView right = square_view();
  right.lateral_bounds = {1, -1, 3, 1};
  LightView sliced = square_view();
  sliced.lateral_bounds = {-3, -1, -1, 1};
  sliced.slice = CameraSlice{0.0, 1.0};
  sliced.camera_axis = {0, 0, 1, 0};
  Image image = empty_gbuffer(16, 1);
  put(image, 0, 0, {0, 0, 2});
  put(image, 1, 0, {4, 0, 2});     // in the second
  put(image, 2, 0, {-1, 0, 0.5});  // in the third and its slice
  put(image, 3, 0, {-4, 0, 2});    // beyond that slice
  EXPECT_DOUBLE_EQ(share_outside(image, std::array{square_view(), right, sliced}), 0.25);
}

TEST(ShareOutside, IsZeroWithoutReceivers) {
  EXPECT_EQ(share_outside(empty_gbuffer(4, 4), std::array{square_view()}), 0.0);
}

}  // namespace
}  // namespace umbrameter
