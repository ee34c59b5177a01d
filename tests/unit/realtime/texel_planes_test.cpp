// SPDX-License-Identifier: Apache-2.0
// Without this an error could be told by the wrong texel.
#include "realtime/executor/texel_planes.h"

#include "realtime/harness/frame_uniforms.h"

#include <gtest/gtest.h>

#include <array>

namespace umbrameter {
namespace {

// Two points below a light at the origin that looks down -y; the second is background.
Image points(const glm::vec3& p_world) {
  Image image(2, 1);
  for (const char* name : {"position.x", "position.y", "position.z"}) image.add_plane(name);
  image.plane("position.x")[0] = p_world.x;
  image.plane("position.y")[0] = p_world.y;
  image.plane("position.z")[0] = p_world.z;
  image.add_plane("primitive_id", -1.0f)[0] = 3.0f;
  return image;
}

FittedView view_down(bool is_orthographic) {
  FittedView fitted;
  // x = world x, y = world z, distance = -world y
  fitted.view.light_from_world =
      glm::mat4(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 0, 1));
  fitted.view.lateral_bounds = {-1.0f, -2.0f, 1.0f, 2.0f};
  fitted.view.near_world = 1.0f;
  fitted.view.far_world = 10.0f;
  fitted.view.is_orthographic = is_orthographic;
  fitted.data = make_light_view_data(fitted.view, 100);
  return fitted;
}

TEST(TexelPlanes, perspective_texels_grow_with_distance) {
  Image image = points({1.0f, -4.0f, 2.0f});
  add_texel_planes(std::array{view_down(false)}, image);
  // x/z = .25: (.25 + 1) / 2 of 100 texels; y/z = .5: (.5 + 2) / 4.
  EXPECT_FLOAT_EQ(image.plane("texel.x")[0], 62.5f);
  EXPECT_FLOAT_EQ(image.plane("texel.y")[0], 62.5f);
  EXPECT_FLOAT_EQ(image.plane("texel_world")[0], 0.16f);  // the wider side: 4 / 100, four units away
}

TEST(TexelPlanes, biases_add_up_in_world_units) {
  Image image = points({1.0f, -4.0f, 2.0f});
  add_texel_planes(std::array{view_down(false)}, image);
  add_bias_plane({{"bias_world", 0.5}, {"bias_texels", 2.0}, {"normal_offset_texels", 1.0}}, image);
  EXPECT_FLOAT_EQ(image.plane("bias_world")[0], 0.5f + 3.0f * 0.16f);
  EXPECT_EQ(image.plane("bias_world")[1], 0.0f);  // background
}

TEST(TexelPlanes, without_a_manual_bias_there_is_none) {
  for (const ParameterValues& parameters :
       {ParameterValues{{"taps", int64_t{4}}},
        ParameterValues{{"bias_mode", std::string("auto")}, {"bias_texels", 2.0}}}) {
    Image image = points({1.0f, -4.0f, 2.0f});
    add_texel_planes(std::array{view_down(false)}, image);
    add_bias_plane(parameters, image);
    EXPECT_FALSE(image.has("bias_world"));
  }
}

TEST(TexelPlanes, orthographic_texels_do_not) {
  Image image = points({0.5f, -4.0f, 1.0f});
  add_texel_planes(std::array{view_down(true)}, image);
  EXPECT_FLOAT_EQ(image.plane("texel.x")[0], 75.0f);
  EXPECT_FLOAT_EQ(image.plane("texel.y")[0], 75.0f);
  EXPECT_FLOAT_EQ(image.plane("texel_world")[0], 0.04f);
}

TEST(TexelPlanes, background_and_what_lies_behind_the_light_have_none) {
  Image image = points({1.0f, 4.0f, 2.0f});
  add_texel_planes(std::array{view_down(false)}, image);
  for (const float width : image.plane("texel_world")) EXPECT_EQ(width, 0.0f);
}

TEST(TexelPlanes, each_point_is_told_by_the_first_map_that_covers_it) {
  FittedView beside = view_down(true);
  beside.view.lateral_bounds = {5.0f, 5.0f, 6.0f, 6.0f};
  const std::array maps{beside, view_down(true), view_down(true)};
  const Image inside = map_indices(maps, points({0.5f, -4.0f, 1.0f})),
              outside = map_indices(maps, points({3.0f, -4.0f, 1.0f}));
  EXPECT_EQ(inside.plane("Y")[0], 1.0f);
  EXPECT_EQ(inside.plane("Y")[1], -1.0f);  // background
  EXPECT_EQ(outside.plane("Y")[0], -1.0f);
}

}  // namespace
}  // namespace umbrameter
