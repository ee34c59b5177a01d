// SPDX-License-Identifier: Apache-2.0
// The cube that other renderers are timed on: its closed form against exact arithmetic, and the reference against it.

#include "reference/exact/box_visibility.h"
#include "reference/exact/exact_visibility.h"
#include "tests/statistical/agreement.h"

#include "scenes/load_scene.h"
#include "tests/support/source_dir.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace umbrameter {
namespace {

const BoxUnderLight kCube{{-0.5, 0, -0.5}, {0.5, 1, 0.5}, {-2, 4, 1}, {3, 2}};

Scene load_cube() {
  return load_scene(source_dir() / "bench/cube.toml", SceneSearch{});
}

TEST(BoxVisibility, equals_exact_arithmetic) {
  Scene cube;
  add_box(cube, kCube.box_min_world, kCube.box_max_world);
  std::vector<TriangleCorners> triangles;
  for (const glm::uvec3& t : cube.triangles) {
    triangles.push_back({cube.positions_world[t.x], cube.positions_world[t.y], cube.positions_world[t.z]});
  }
  const PolygonLight light =
      rectangle_light(kCube.light_center_world, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, kCube.light_size_xz_world);
  size_t partly = 0;
  for (const double x : {-0.8, -0.2, 0.6, 0.75, 1.3}) {
    for (const double z : {-1.7, -0.9, -0.55, 0.3, 0.8}) {
      const glm::dvec3 p{x, 0, z};
      if (std::abs(x) <= 0.5 && std::abs(z) <= 0.5) continue;
      const double exact = exact_visibility(triangles, p, {0, 1, 0}, light);
      EXPECT_NEAR(box_visibility(kCube, p, {0, 1, 0}), exact, 1e-12) << x << ", " << z;
      if (exact > 0.0 && exact < 1.0) ++partly;
    }
  }
  EXPECT_GT(partly, 5u);
  EXPECT_DOUBLE_EQ(box_visibility(kCube, {0, 0.5, 0.5}, {0, 0, 1}),
                   0.75);                                           // of z in [0, 2] what lies beyond 0.5
  EXPECT_EQ(box_visibility(kCube, {0.5, 0.5, 0}, {1, 0, 0}), 0.0);  // the light ends at x = -0.5
  EXPECT_EQ(box_visibility(kCube, {0, 1, 0}, {0, 1, 0}), 1.0);
}

TEST(BoxVisibility, is_what_the_reference_finds) {
  const Frame frame = render_reference(load_cube(), {.side_px = 96, .samples_per_pixel = 512});
  const Truth truth = in_penumbra([](const glm::dvec3& p) {
    // Which of the cube's faces, or the floor: positions are float.
    const glm::dvec3 n = p.y > 0.9999   ? glm::dvec3(0, 1, 0)
                         : p.y < 1e-4   ? glm::dvec3(0, 1, 0)
                         : p.z > 0.4999 ? glm::dvec3(0, 0, 1)
                                        : glm::dvec3(1, 0, 0);
    return box_visibility(kCube, p, n);
  });
  EXPECT_EQ(objection(compare(frame, truth)), "");
}

}  // namespace
}  // namespace umbrameter
