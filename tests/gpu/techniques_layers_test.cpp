// SPDX-License-Identifier: Apache-2.0
// Cubes and cascades: nothing outside them, nothing to be seen where two of their maps meet, and otherwise what a single
// map says.

#include "core/error.h"
#include "realtime/inspect.h"
#include "realtime/realtime.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"
#include "tests/support/source_dir.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace umbrameter {
namespace {

using namespace test;
using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;

const std::array<const char*, 3> kCubes = {"hard_cube", "pcf_cube", "pcss_cube"};
const std::array<const char*, 6> kCascades = {"hard_cascades", "pcf_cascades",  "pcf_atlas",
                                              "pcss_cascades", "evsm_cascades", "smrt_cascades"};

/// The inside of a box of 4 m with a lamp off its middle; the camera in a corner sees floor, ceiling and four walls.
Scene room(bool has_shelf) {
  Scene scene;
  add_box(scene, {-2, -2, -2}, {2, 2, 2});
  if (has_shelf) add_box(scene, {-0.4, -0.2, -1.4}, {0.5, 0.1, -0.9});
  scene.lights = {sphere_light({0.3, 0.4, -0.2}, 0.05)};
  scene.camera.eye_world = {-1.9, 0.5, 1.9};
  scene.camera.at_world = {0.6, -0.1, -0.6};
  scene.camera.vertical_fov_deg = 100.0;
  finish_scene(scene);
  return scene;
}

ParameterValues small_cube(const std::string& id) {
  ParameterValues values{{"face_size", int64_t{256}}};
  if (id == "pcss_cube") values.insert({{"search_taps", int64_t{32}}, {"filter_taps", int64_t{32}}});
  return values;
}

/// How far a point of room()'s walls lies from the nearest edge of its wall, as the lamp sees it, in texels there.
double texels_to_edge(const glm::dvec3& p, const glm::dvec3& lamp, double texel_world) {
  constexpr double kHalfSide = 2.0;
  const glm::dvec3 to_lamp = glm::normalize(lamp - p);
  const glm::dvec3 size = glm::abs(p);
  const int own = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  double nearest = 1e30;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == own) continue;
    const double across = std::sqrt(1.0 - to_lamp[axis] * to_lamp[axis]);
    nearest = std::min(nearest, (kHalfSide - size[axis]) * across / texel_world);
  }
  return nearest;
}

struct CubeReach {
  const char* id;
  double texels;  // from a receiver to the middle of the farthest texel that it is compared with
};

TEST(cubes, light_every_wall_of_an_empty_room_across_the_edges_of_their_faces) {
  UMBRAMETER_REQUIRE_GL();
  // Where two walls meet a texel may hold the other wall; nowhere else, and no seam along the edges of faces.
  const double own_texel = std::sqrt(0.5);
  const double disk = 2.0 + std::sqrt(2.0);  // its radius and the blend of four
  const double slack = 1.0 + own_texel;      // of the search's cone of rays
  for (const CubeReach& cube :
       {CubeReach{"hard_cube", own_texel}, {"pcf_cube", disk}, {"pcss_cube", slack}}) {
    const Scene scene = room(false);
    const Frame frame = render(scene, cube.id, small_cube(cube.id));
    const auto v = frame.image.plane("visibility"), texel = frame.image.plane("texel_world");
    const auto x = frame.image.plane("position.x"), y = frame.image.plane("position.y"),
               z = frame.image.plane("position.z");
    int far_from_edges = 0;
    for (size_t i = 0; i < v.size(); ++i) {
      const double distance = texels_to_edge({x[i], y[i], z[i]}, scene.light().center_world, texel[i]);
      if (distance <= cube.texels) continue;
      ++far_from_edges;
      EXPECT_EQ(v[i], 1.0f) << cube.id << ", " << distance << " texels from an edge";
    }
    EXPECT_GT(far_from_edges, 12000) << cube.id << ": of 14400";
  }
}

TEST(cubes, leave_no_receiver_outside_where_a_single_map_does) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = room(true);
  EXPECT_THAT(render(scene, "hard").warnings, testing::Contains(HasSubstr("outside the light's map")));
  for (const char* id : kCubes) {
    const Frame frame = render(scene, id, small_cube(id));
    EXPECT_THAT(frame.warnings, IsEmpty()) << id;
    const auto texel = frame.image.plane("texel_world");
    EXPECT_EQ(std::ranges::count(texel, 0.0f), 0) << id << ": every pixel shows a wall, and each has a texel";
  }
}

TEST(hard_cube, is_the_hard_shadow_of_a_single_map) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = half_plane_scene(light_at_4(LightType::sphere, 0.5));
  const auto single = visibility(scene, "hard", {{"map_size", int64_t{1024}}});
  const auto cube = visibility(scene, "hard_cube", {{"face_size", int64_t{1024}}});
  int apart = 0;
  for (size_t i = 0; i < single.size(); ++i) apart += single[i] != cube[i] ? 1 : 0;
  EXPECT_LT(apart, 150) << "of 14400 pixels, along an edge of 90";
  EXPECT_GT(std::ranges::count(cube, 0.0f), 2000);
}

TEST(pcss_cube, is_within_001_of_the_half_plane_under_a_sphere) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::sphere, 1.0);
  const Frame frame =
      render(half_plane_scene(light), "pcss_cube",
             {{"face_size", int64_t{1024}}, {"search_taps", int64_t{128}}, {"filter_taps", int64_t{128}}});
  const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p); };
  EXPECT_LE(floor_error(frame, truth).rmse, 0.01);
}

/// A floor of 400 m under a sun, and plates 2 m above it near the camera and far from it.
Scene long_scene() {
  Scene scene;
  add_floor(scene, {60, 400}, 0.0, {0, -195});
  add_floor(scene, {1, 1}, 2.0, {0, -6});
  add_floor(scene, {6, 6}, 2.0, {3, -60});
  add_floor(scene, {20, 30}, 2.0, {-8, -250});
  scene.lights = {sun_light({0.4, 1, 0.1}, 0.005)};
  scene.camera.eye_world = {0, 4, 3};
  scene.camera.at_world = {0, 0, -14};
  scene.camera.vertical_fov_deg = 50.0;
  finish_scene(scene);
  return scene;
}

/// Share of a sun's disk beyond an edge at distance d (tangents).
double sun_share(double d) {
  const double t = std::clamp(d, -1.0, 1.0);
  return (std::acos(-t) + t * std::sqrt(1.0 - t * t)) / std::numbers::pi;
}

struct Rect {
  glm::dvec2 min, max;
};

/// Of the floor of long_scene(), whose plates are far wider than penumbrae: the share is that of its nearest edge.
double long_visibility(const glm::dvec3& p) {
  const glm::dvec2 shift(2.0 * 0.4, 2.0 * 0.1);  // along the ray to the sun's centre, 2 m up
  const double radius = 2.0 * std::sqrt(1.0 + 0.4 * 0.4 + 0.1 * 0.1) * std::tan(0.005);
  double visible = 1.0;
  for (const Rect& plate :
       {Rect{{-0.5, -6.5}, {0.5, -5.5}}, Rect{{0, -63}, {6, -57}}, Rect{{-18, -265}, {2, -235}}}) {
    const glm::dvec2 q = glm::dvec2(p.x, p.z) + shift;
    const glm::dvec2 inside = glm::min(q - plate.min, plate.max - q);
    visible = std::min(visible, sun_share(-std::min(inside.x, inside.y) / radius));
  }
  return visible;
}

ParameterValues cascades(int64_t count, ParameterValues more = {}) {
  more.insert({{"cascade_count", count}, {"cascade_size", int64_t{512}}});
  return more;
}

double long_error(const std::string& id, const ParameterValues& values) {
  return floor_error(render(long_scene(), id, values), long_visibility).rmse;
}

TEST(cascades, put_shadows_near_and_far_where_one_map_cannot) {
  UMBRAMETER_REQUIRE_GL();
  const double one = long_error("pcss_cascades", cascades(1));
  const double four = long_error("pcss_cascades", cascades(4));
  RecordProperty("one_and_four", fmt::format("{:.4f} {:.4f}", one, four));
  EXPECT_LT(four, 0.5 * one);
  EXPECT_LT(four, 0.05);
}

TEST(cascades, of_every_fit_cover_every_receiver) {
  UMBRAMETER_REQUIRE_GL();
  for (const char* id : kCascades) {
    for (const char* fit : {"frustum", "full", "visible", "sphere"}) {
      for (const char* range : {"scene", "visible"}) {
        const Frame frame =
            render(long_scene(), id,
                   cascades(3, {{"cascade_fit", std::string(fit)}, {"shadow_range", std::string(range)}}));
        EXPECT_THAT(frame.warnings, IsEmpty()) << id << " " << fit << " " << range;
      }
    }
  }
}

TEST(cascades, end_where_they_are_told_to) {
  UMBRAMETER_REQUIRE_GL();
  const Frame frame = render(long_scene(), "hard_cascades", cascades(2, {{"max_distance_world", 30.0}}));
  EXPECT_THAT(frame.warnings, testing::ElementsAre(HasSubstr("outside the light's map")));
  const auto v = frame.image.plane("visibility");
  const auto z = frame.image.plane("position.z");
  for (size_t i = 0; i < v.size(); ++i) {
    if (z[i] >= -40.0f) continue;
    ASSERT_EQ(v[i], 1.0f) << i;
  }
  EXPECT_GT(std::ranges::count(v, 0.0f), 0);
}

TEST(hard_cascades, of_one_map_are_the_hard_shadow) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 0.5));
  const auto single = visibility(scene, "hard", {{"map_size", int64_t{1024}}});
  const auto one =
      visibility(scene, "hard_cascades", {{"cascade_count", int64_t{1}}, {"cascade_size", int64_t{1024}}});
  EXPECT_LT(mean_difference(single, one), 0.01);
  EXPECT_GT(std::ranges::count(one, 0.0f), 2000);
}

TEST(evsm_cascades, of_one_map_are_evsm) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = half_plane_scene(light_at_4(LightType::sun, 0.5));
  const auto single = visibility(scene, "evsm", {{"map_size", int64_t{512}}});
  const auto one =
      visibility(scene, "evsm_cascades", {{"cascade_count", int64_t{1}}, {"cascade_size", int64_t{512}}});
  EXPECT_LT(mean_difference(single, one), 0.01);
  EXPECT_GT(std::ranges::count_if(one, [](float v) { return v < 0.01f; }), 2000);
}

TEST(cascades, say_which_map_each_pixel_is_looked_up_in) {
  UMBRAMETER_REQUIRE_GL();
  const Frame frame = render(long_scene(), "hard_cascades", cascades(3));
  const auto map = frame.image.plane("map_index"), id = frame.image.plane("primitive_id");
  for (size_t i = 0; i < map.size(); ++i) ASSERT_EQ(map[i] < 0.0f, id[i] < 0.0f) << i;
  for (const float index : {0.0f, 1.0f, 2.0f}) EXPECT_GT(std::ranges::count(map, index), 100) << index;
  EXPECT_FALSE(render(long_scene(), "hard_cascades", cascades(1)).image.has("map_index"));
}

TEST(pcss_cascades, are_within_001_of_the_half_plane_under_a_sun) {
  UMBRAMETER_REQUIRE_GL();
  const Light light = light_at_4(LightType::sun, 1.0);
  const Frame frame =
      render(half_plane_scene(light), "pcss_cascades",
             {{"cascade_size", int64_t{1024}}, {"search_taps", int64_t{128}}, {"filter_taps", int64_t{128}}});
  const auto truth = [&](const glm::dvec3& p) { return half_plane_visibility(light, p); };
  EXPECT_LE(floor_error(frame, truth).rmse, 0.01);
}

/// A floor of 200 m under a slanting sun, and plates above it all the way, higher the farther, so that every slice has edges.
Scene rows_of_plates() {
  Scene scene;
  add_floor(scene, {60, 200}, 0.0, {0, -95});
  for (double z = -3.0; z > -180.0; z *= 1.2) add_floor(scene, {-0.3 * z, -0.08 * z}, 1.0 - 0.05 * z, {0, z});
  scene.lights = {sun_light({0.8, 1, 0.1}, 0.005)};
  scene.camera.eye_world = {0, 20, 3};
  scene.camera.at_world = {0, 0, -40};
  scene.camera.vertical_fov_deg = 50.0;
  finish_scene(scene);
  return scene;
}

/// The greatest difference of a pixel between maps in an atlas and in an array. Disks reach over the edges of the maps, which
/// fit their slice without a margin.
double atlas_apart(const Scene& scene, int64_t count) {
  const ParameterValues values = cascades(
      count,
      {{"cascade_fit", std::string("frustum")}, {"cascade_size", int64_t{64}}, {"radius_texels", 24.0}});
  const auto array = visibility(scene, "pcf_cascades", values);
  const auto atlas = visibility(scene, "pcf_atlas", values);
  EXPECT_GT(std::ranges::count_if(atlas, [](float v) { return v < 1.0f; }), 1000)
      << "blocked taps, " << count;
  double most = 0.0;
  for (size_t i = 0; i < array.size(); ++i)
    most = std::max(most, static_cast<double>(std::abs(array[i] - atlas[i])));
  return most;
}

TEST(pcf_atlas, shows_what_layers_of_an_array_show) {
  UMBRAMETER_REQUIRE_GL();
  const double step = 1.0 / 256.0;  // of a sampler's weights
  const Scene plates = rows_of_plates();
  const Scene half_plane = half_plane_scene(light_at_4(LightType::sun, 0.5));
  for (const int64_t count : {1, 2, 3, 4, 5, 8}) {
    EXPECT_LE(atlas_apart(plates, count), step) << count;
    EXPECT_LE(atlas_apart(half_plane, count), step) << count << ": casters over the edges of maps";
  }
}

struct Range {
  double near = 0.0, far = 0.0;
};

/// Of a picture's receivers, along the camera's axis.
std::vector<double> axis_distances(const Scene& scene, const Frame& frame) {
  const glm::dvec3 eye = scene.camera.eye_world;
  const glm::dvec3 forward = glm::normalize(scene.camera.at_world - eye);
  const auto x = frame.image.plane("position.x"), y = frame.image.plane("position.y"),
             z = frame.image.plane("position.z"), id = frame.image.plane("primitive_id");
  std::vector<double> distances;
  for (size_t i = 0; i < x.size(); ++i)
    distances.push_back(id[i] < 0.0f ? -1.0 : glm::dot(glm::dvec3(x[i], y[i], z[i]) - eye, forward));
  return distances;
}

/// Where each of `count` slices in equal ratios of distance has company: from half a step before its end to its end.
std::vector<Range> overlaps(const Range& all, int count) {
  std::vector<Range> found;
  for (int i = 1; i < count; ++i) {
    const double ratio = all.far / all.near;
    found.push_back(
        {all.near * std::pow(ratio, (i - 0.5) / count), all.near * std::pow(ratio, 1.0 * i / count)});
  }
  return found;
}

TEST(cascades, blend_only_where_slices_overlap) {
  UMBRAMETER_REQUIRE_GL();
  const Scene scene = rows_of_plates();
  const auto frame = [&](const char* blend, double overlap) {
    return render(scene, "hard_cascades",
                  cascades(4, {{"cascade_blend", std::string(blend)},
                               {"cascade_overlap", overlap},
                               {"cascade_size", int64_t{64}},  // so coarse that two maps disagree along edges
                               {"split_lambda", 1.0},
                               {"shadow_range", std::string("visible")}}));
  };
  const auto picture = [&](const char* blend, double overlap) {
    const Frame drawn = frame(blend, overlap);
    const auto plane = drawn.image.plane("visibility");
    return std::vector<float>(plane.begin(), plane.end());
  };
  EXPECT_EQ(picture("mix", 0.0), picture("none", 0.0));
  EXPECT_EQ(picture("dither", 0.0), picture("none", 0.0));
  const std::vector<double> distance = axis_distances(scene, frame("none", 0.5));
  Range all{1e30, 0.0};
  for (const double d : distance) {
    if (d > 0.0) all = {std::min(all.near, d), std::max(all.far, d)};
  }
  std::array<int, 3> blended{};
  const auto none = picture("none", 0.5), mix = picture("mix", 0.5), dither = picture("dither", 0.5);
  for (size_t i = 0; i < none.size(); ++i) {
    EXPECT_TRUE(dither[i] == 0.0f || dither[i] == 1.0f) << "a dithered pixel asks one map";
    if (mix[i] == none[i]) continue;
    int inside = 0;
    for (size_t k = 0; const Range& overlap : overlaps(all, 4)) {
      const bool is_inside = distance[i] > 0.999 * overlap.near && distance[i] < 1.001 * overlap.far;
      blended[k++] += is_inside ? 1 : 0;
      inside += is_inside ? 1 : 0;
    }
    EXPECT_EQ(inside, 1) << "mixed at " << distance[i];
  }
  EXPECT_THAT(blended, testing::Each(testing::Gt(0))) << "each pair of slices has edges to blend";
  EXPECT_LT(mean_difference(mix, none), 0.05);
  EXPECT_GT(mean_difference(dither, none), 0.0);
}

TEST(dump, shows_what_a_layer_of_a_resource_holds) {
  UMBRAMETER_REQUIRE_GL();
  const std::filesystem::path realtime = source_dir() / "realtime";
  const auto renderer = make_realtime_renderer({realtime / "techniques", realtime / "shaders", {}});
  RenderRequest request{
      .width_px = 64, .height_px = 36, .technique = "hard_cube", .parameters = small_cube("hard_cube")};
  SilentProgress progress;
  const Scene scene = room(false);
  const auto dumped = [&](const char* part) {
    return dump_resource(*renderer, scene, request, parse_resource_part(part), progress);
  };
  // The ceiling is 1.6 above the lamp: one distance over all of the +y face, near / z but for the far plane's share.
  const Image up = dumped("shadow_map:2");
  EXPECT_EQ(up.width, 256);
  const auto depth = up.plane("Y");
  EXPECT_NEAR(*std::ranges::max_element(depth), *std::ranges::min_element(depth), 1e-5);
  EXPECT_NE(depth[0], dumped("shadow_map:3").plane("Y")[0]);
  const Frame frame = renderer->render(scene, request, progress);
  EXPECT_TRUE(std::ranges::equal(dumped("visibility").plane("Y"), frame.image.plane("visibility")));
  EXPECT_TRUE(std::ranges::equal(dumped("gbuffer.position").plane("G"), frame.image.plane("position.y")));
  EXPECT_THROW(dumped("shadow_map:6"), Error);
  EXPECT_THROW(dumped("shadow_map:0:1"), Error);
  EXPECT_THROW(dumped("shadow_mpa"), Error);
}

TEST(final_shaders, are_what_the_driver_compiles) {
  UMBRAMETER_REQUIRE_GL();
  const std::filesystem::path realtime = source_dir() / "realtime";
  const auto renderer = make_realtime_renderer({realtime / "techniques", realtime / "shaders", {}});
  const RenderRequest request{.width_px = 64,
                              .height_px = 36,
                              .technique = "pcss_cube",
                              .parameters = {{"filter_taps", int64_t{21}}}};
  const auto shaders = final_shaders(*renderer, room(false), request);
  ASSERT_EQ(shaders.size(), 3u);  // a vertex shader that writes depth, and two for the screen
  EXPECT_EQ(shaders[0].pass, "map");
  EXPECT_EQ(shaders[0].stage, "vertex");
  EXPECT_EQ(shaders[2].pass, "visibility");
  EXPECT_THAT(shaders[2].text, AllOf(HasSubstr("#version 450 core"), HasSubstr("#define FILTER_TAPS 21"),
                                     HasSubstr("uniform samplerCube shadow_map;"), HasSubstr("view_cube[6]"),
                                     HasSubstr("float visible_share(")));
}

}  // namespace
}  // namespace umbrameter
