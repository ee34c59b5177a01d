// SPDX-License-Identifier: Apache-2.0
// What a map covers decides its resolution and what is lost at its rim.

#include "realtime/views/camera_tiles.h"
#include "realtime/views/light_view.h"
#include "tests/support/procedural_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace umbrameter {
namespace {

/// A wide floor of which the camera sees a small part, and a plate above it.
Scene wide_scene(LightType type) {
  Scene scene;
  add_floor(scene, {40, 40});
  add_floor(scene, {1, 1}, 1.0);
  Light light = rect_light_above({0, 20, 0}, {1, 1});
  light.type = type;
  light.half_angle_rad = 0.01;
  scene.lights = {light};
  scene.camera = camera_above({0, 0, 0}, 4, 10);
  finish_scene(scene);
  return scene;
}

LightView fitted(const Scene& scene, LightFit fit) {
  const std::vector<ReceiverTile> tiles = camera_tiles(scene, 160, 160);
  return fit_center_view(scene, tiles, fit);
}

double width(const LightView& view) {
  return static_cast<double>(view.lateral_bounds.z) - static_cast<double>(view.lateral_bounds.x);
}

TEST(CameraTiles, CoverWhatTheCameraSeesAndLittleElse) {
  const Scene scene = wide_scene(LightType::sun);
  const std::vector<ReceiverTile> tiles = camera_tiles(scene, 160, 160);
  ASSERT_FALSE(tiles.empty());
  bool covers_middle = false;
  for (const ReceiverTile& tile : tiles) {
    covers_middle = covers_middle || (tile.min_world.x <= 0 && tile.max_world.x >= 0);
    EXPECT_LT(std::abs(tile.min_world.x), 10.0f);
  }
  EXPECT_TRUE(covers_middle);
}

TEST(MapFit, GetsTighterFromNoneToFull) {
  for (const LightType type : {LightType::rect, LightType::sun}) {
    const Scene scene = wide_scene(type);
    const LightView none = fitted(scene, LightFit::none);
    const LightView all = fitted(scene, LightFit::scene);
    const LightView frustum = fitted(scene, LightFit::frustum);
    const LightView full = fitted(scene, LightFit::full);
    EXPECT_GT(width(none), width(all));
    EXPECT_GT(width(all), 2.0 * width(frustum));
    EXPECT_GE(1.01 * (frustum.far_world - frustum.near_world), full.far_world - full.near_world);
    EXPECT_NEAR(width(full) / width(frustum), 1.0, 0.2) << "full adds the reach of penumbrae only";
  }
}

TEST(MapSnap, StandsStillInWholeTexelsWhileTheCameraMoves) {
  constexpr int kTexels = 512;
  Scene scene = wide_scene(LightType::sun);
  const LightView first = snapped(fitted(scene, LightFit::full), kTexels);
  const double texel = width(first) / kTexels;
  for (const double step : {0.0137, 0.0273, 0.0414}) {
    scene.camera.eye_world.x += step;
    scene.camera.at_world.x += step;
    const LightView view = snapped(fitted(scene, LightFit::full), kTexels);
    EXPECT_NEAR(width(view), width(first), 1e-5 * width(first));
    const double moved = (view.lateral_bounds.x - first.lateral_bounds.x) / texel;
    EXPECT_NEAR(moved, std::round(moved), 2e-2);
  }
}

TEST(MapSnap, CoversWhatTheFreeMapCovers) {
  const LightView free = fitted(wide_scene(LightType::rect), LightFit::full);
  const LightView view = snapped(free, 64);
  EXPECT_LE(view.lateral_bounds.x, free.lateral_bounds.x);
  EXPECT_LE(view.lateral_bounds.y, free.lateral_bounds.y);
  EXPECT_GE(view.lateral_bounds.z, free.lateral_bounds.z);
  EXPECT_GE(view.lateral_bounds.w, free.lateral_bounds.w);
  EXPECT_LT(width(view), 1.25 * width(free));
}

}  // namespace
}  // namespace umbrameter
