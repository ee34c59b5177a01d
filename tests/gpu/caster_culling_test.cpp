// SPDX-License-Identifier: Apache-2.0
// Leaving out triangles that cannot reach a map must change no pixel of any technique, and must be said.

#include "realtime/realtime.h"
#include "tests/gpu/technique_fixture.h"
#include "tests/support/procedural_scene.h"
#include "tests/support/source_dir.h"
#include "tests/support/technique_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace umbrameter {
namespace {

using namespace test;

const std::filesystem::path kRealtime = source_dir() / "realtime";

/// A small picture in the middle of many boxes on a wide floor.
Scene wide_scene(const Light& light) {
  Scene scene;
  for (int x = -20; x < 20; ++x) {
    for (int z = -20; z < 20; ++z) {
      add_floor(scene, {0.5, 0.5}, 0.0, {0.5 * x, 0.5 * z});
      const double height = 0.1 + 0.05 * ((x * 7 + z * 3) & 7);
      add_box(scene, {0.5 * x, 0, 0.5 * z}, {0.5 * x + 0.15, height, 0.5 * z + 0.15});
    }
  }
  scene.lights = {light};
  scene.camera.eye_world = {1.5, 1.2, 1.0};
  scene.camera.at_world = {0, 0, 0};
  scene.camera.vertical_fov_deg = 40.0;
  finish_scene(scene);
  return scene;
}

std::unique_ptr<Renderer> renderer_of(const std::filesystem::path& techniques, bool culls) {
  return make_realtime_renderer({techniques, kRealtime / "shaders", "", culls});
}

Frame render_with(Renderer& renderer, const Scene& scene, const std::string& technique,
                  const ParameterValues& values) {
  SilentProgress progress;
  return renderer.render(scene, {160, 90, 1, technique, values}, progress);
}

std::vector<float> plane(const Frame& frame) {
  const auto values = frame.image.plane("visibility");
  return {values.begin(), values.end()};
}

bool says_so(const Frame& frame) {
  return std::ranges::any_of(
      frame.left_out, [](const std::string& text) { return text.find("outside them") != std::string::npos; });
}

TEST(CasterCulling, ChangesNoPixelOfAnyTechnique) {
  UMBRAMETER_REQUIRE_GL();
  const auto all = renderer_of(kRealtime / "techniques", false);
  size_t with_saving = 0;
  for (const LightType type : {LightType::rect, LightType::disk, LightType::sphere, LightType::sun}) {
    const Scene scene = wide_scene(light_at_4(type, 0.5));
    for (const Technique& technique : techniques()) {
      if (!technique.supports(type)) continue;
      const Frame culled = render(scene, technique.id, quick(technique, 256));
      const Frame whole = render_with(*all, scene, technique.id, quick(technique, 256));
      EXPECT_EQ(plane(culled), plane(whole)) << technique.id << " " << to_text(type);
      EXPECT_FALSE(says_so(whole)) << technique.id;
      with_saving += says_so(culled) ? 1 : 0;
    }
  }
  EXPECT_GT(with_saving, 40u);  // of all but planar, which projects by a shader of its own
}

/// Shows, per pixel, the triangle the map holds there: its index is of all triangles of the scene.
TEST(CasterCulling, ShaderThatAsksForTheTriangleGetsAllOfThem) {
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
[[resource]]
name = "ids"
format = "r32f"
width = 64
height = 64
[[pass]]
id = "map"
kind = "scene"
view = "light"
fragment = "ids.frag"
writes = ["map", "ids"]
clear = [0]
[[pass]]
id = "show"
kind = "fullscreen"
fragment = "show.frag"
reads = ["ids"]
writes = ["visibility"]
)");
  folder.write("show.frag",
               "void main() { out_visibility = texelFetch(ids, ivec2(gl_FragCoord.xy) % 64, 0).x; }");
  const Scene scene = wide_scene(light_at_4(LightType::rect, 0.5));
  const auto shown = [&](const std::string& value, bool culls) {
    folder.write("ids.frag", "void main() { out_ids = " + value + "; }");
    const auto renderer = renderer_of(folder.techniques_folder(), culls);
    return render_with(*renderer, scene, "tried", {});
  };
  const std::string index = "float(gl_PrimitiveID) / 65536.0";
  const Frame culled = shown(index, true);
  EXPECT_EQ(plane(culled), plane(shown(index, false)));
  EXPECT_FALSE(says_so(culled));
  EXPECT_TRUE(says_so(shown("0.5", true)));
}

}  // namespace
}  // namespace umbrameter
