// SPDX-License-Identifier: Apache-2.0
// Without these an instance could stand elsewhere in a map than in the picture, or be left out of one technique's maps.

#include "scenes/instances.h"
#include "core/progress.h"
#include "metrics/image/parity.h"
#include "realtime/realtime.h"
#include "reference/reference.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/instanced_scene.h"
#include "tests/support/procedural_scene.h"
#include "tests/support/source_dir.h"
#include "tests/support/technique_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace umbrameter {
namespace {

using namespace test;

const std::filesystem::path kRealtimeRoom = source_dir() / "realtime";
constexpr int kWidth_px = 240, kHeight_px = 160;

const InstancedSceneOptions kOptions[] = {{false, false}, {true, false}, {false, true}, {true, true}};

Light trees_light(LightType type) {
  Light light = light_at_4(type, 0.5);
  if (type == LightType::sun) light = sun_light({0.4, 1, 0.3}, 0.06);
  return light;
}

ReferenceSettings few_samples() {
  ReferenceSettings settings;
  settings.samples_per_pixel = 8;
  return settings;
}

double share_apart(const std::vector<float>& a, const std::vector<float>& b, float tolerance) {
  size_t count = 0;
  for (size_t i = 0; i < a.size(); ++i) count += std::abs(a[i] - b[i]) <= tolerance ? 0 : 1;
  return static_cast<double>(count) / static_cast<double>(a.size());
}

std::vector<float> plane_of(const Frame& frame, const std::string& channel) {
  const auto values = frame.image.plane(channel);
  return {values.begin(), values.end()};
}

TEST(instances, are_the_same_surfaces_in_both_renderers) {
  UMBRAMETER_REQUIRE_GL();
  for (const InstancedSceneOptions& options : kOptions) {
    const Scene scene = instanced_scene(trees_light(LightType::rect), options);
    const Frame drawn = render(scene, "hard", {}, 1, kWidth_px, kHeight_px);
    SilentProgress progress;
    const Frame traced =
        make_reference_renderer(few_samples())->render(scene, {kWidth_px, kHeight_px, 1, {}, {}}, progress);
    const glm::dvec3& eye_world = scene.camera.eye_world;
    const Parity parity = compare_surfaces(drawn.image, traced.image, eye_world, {});
    EXPECT_GE(parity.agreement, 0.995) << options.is_smooth << options.has_leaves;
    EXPECT_GE(static_cast<double>(parity.same_primitive), 0.998 * static_cast<double>(parity.covered));
    EXPECT_LE(share_apart(plane_of(drawn, "shading_normal.x"), plane_of(traced, "shading_normal.x"), 1e-3f),
              0.002);
  }
}

TEST(instances, have_the_gbuffer_of_their_flattened_twin) {
  UMBRAMETER_REQUIRE_GL();
  for (const InstancedSceneOptions& options : kOptions) {
    const Scene scene = instanced_scene(trees_light(LightType::rect), options);
    const Frame own = render(scene, "hard", {}, 1, kWidth_px, kHeight_px);
    const Frame flat = render(flattened(scene), "hard", {}, 1, kWidth_px, kHeight_px);
    for (const char* channel :
         {"position.x", "position.y", "position.z", "normal.x", "normal.y", "normal.z", "shading_normal.x",
          "shading_normal.y", "shading_normal.z", "unshadowed_irradiance"})
      EXPECT_LE(share_apart(plane_of(own, channel), plane_of(flat, channel), 1e-4f), 0.002) << channel;
    if (options.has_leaves) continue;  // then they are numbered otherwise
    EXPECT_LE(share_apart(plane_of(own, "primitive_id"), plane_of(flat, "primitive_id"), 0.0f), 0.002);
  }
}

TEST(every_technique, draws_instances_as_their_flattened_twin) {
  UMBRAMETER_REQUIRE_GL();
  for (const Technique& technique : techniques()) {
    for (const InstancedSceneOptions& options : {kOptions[1], kOptions[2]}) {
      const Scene scene = instanced_scene(trees_light(any_light(technique)), options);
      const Frame own = render(scene, technique.id, quick(technique));
      const Frame flat = render(flattened(scene), technique.id, quick(technique));
      const auto a = plane_of(own, "visibility"), b = plane_of(flat, "visibility");
      EXPECT_LE(mean_difference(a, b), 0.002) << technique.id << options.has_leaves;
      EXPECT_LE(share_apart(a, b, 0.1f), 0.005) << technique.id << options.has_leaves;
      Scene without = scene;
      without.instanced.clear();
      without.hash.clear();
      EXPECT_GT(mean_difference(a, plane_of(render(without, technique.id, quick(technique)), "visibility")),
                0.02)
          << technique.id << ": trees have shadows";
    }
  }
}

/// Twenty rows of trees, most of them outside of what the picture's map covers.
Scene wide_forest(const Light& light) {
  Scene scene = instanced_scene(light, kOptions[2]);
  for (auto& mesh : scene.instanced) {
    auto many = std::make_shared<InstancedMesh>(*mesh);
    const std::vector<glm::mat4x3> few = mesh->world_from_mesh;
    many->world_from_mesh.clear();
    for (int row = -10; row < 10; ++row) {
      for (glm::mat4x3 place : few) {
        place[3] += glm::vec3(4.5f * static_cast<float>(row), 0, 0.3f * static_cast<float>(row));
        many->world_from_mesh.push_back(place);
      }
    }
    mesh = many;
  }
  scene.hash.clear();
  return scene;
}

TEST(instances, left_out_of_a_map_change_no_pixel_and_are_said) {
  UMBRAMETER_REQUIRE_GL();
  const auto all =
      make_realtime_renderer({kRealtimeRoom / "techniques", kRealtimeRoom / "shaders", "", false});
  for (const char* technique : {"hard", "pcss"}) {
    for (const LightType type : {LightType::rect, LightType::sun}) {
      const Scene scene = wide_forest(trees_light(type));
      SilentProgress progress;
      const Frame whole = all->render(scene, {160, 90, 1, technique, {}}, progress);
      const Frame culled = render(scene, technique);
      EXPECT_EQ(plane_of(culled, "visibility"), plane_of(whole, "visibility")) << technique;
      EXPECT_TRUE(std::ranges::any_of(culled.left_out, [](const std::string& text) {
        return text.find("outside them") != std::string::npos;
      })) << technique;
    }
  }
}

TEST(instances, need_a_vertex_shader_that_declares_its_position) {
  UMBRAMETER_REQUIRE_GL();
  TechniqueFolder folder;
  folder.write("technique.toml", manifest_head() + R"(
[[view]]
name = "light"
fit = "visible"
size = 64
[[resource]]
name = "map"
format = "depth32f"
width = 64
height = 64
[[pass]]
id = "map"
kind = "scene"
view = "light"
vertex = "own.vert"
writes = ["map"]
clear = [0]
[[pass]]
id = "show"
kind = "fullscreen"
fragment = "show.frag"
reads = ["map"]
writes = ["visibility"]
)");
  folder.write("own.vert",
               "layout(location = 0) in vec4 p;\nvoid main() { gl_Position = VIEW.clip_from_light * "
               "(VIEW.light_from_world * p); }\n");
  folder.write("show.frag", "void main() { out_visibility = texture(map, vec2(0.5)).x; }\n");
  const auto renderer =
      make_realtime_renderer({folder.techniques_folder(), kRealtimeRoom / "shaders", "", true});
  SilentProgress progress;
  const Scene scene = instanced_scene(trees_light(LightType::rect));
  try {
    renderer->render(scene, {32, 32, 1, "tried", {}}, progress);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("declares its position 0 times, and the scene has instances"),
              std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("own.vert"), std::string::npos);
  }
}

}  // namespace
}  // namespace umbrameter
