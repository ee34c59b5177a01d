// SPDX-License-Identifier: Apache-2.0
// Scene data on demand: rays through the BVH meet what a test of every triangle meets, and nothing is made that nobody reads.

#include "realtime/inspect.h"
#include "scenes/instances.h"
#include "tests/gpu/tried_technique.h"
#include "tests/support/cutout_card.h"
#include "tests/support/instanced_scene.h"
#include "tests/support/models.h"
#include "tests/support/procedural_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace umbrameter {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int kSidePx = 48;
constexpr double kReach = 64.0;  // t is shown in these

Scene small_scene() {
  Scene scene;
  add_floor(scene, {4, 4});
  add_box(scene, {-0.5, 0.5, -0.5}, {0.5, 1, 0.5});
  scene.camera = camera_above({0, 0, 0}, 2, 20);
  scene.lights.push_back(sun_light({0, 1, 0}, 0.01));
  finish_scene(scene);
  return scene;
}

std::string pass(const std::string& reads) {
  return "[[pass]]\nid = \"v\"\nkind = \"fullscreen\"\nfragment = \"v.frag\"\nreads = [" + reads +
         "]\nwrites = [\"visibility\"]\n";
}

constexpr const char* kTraversal = R"("scene.positions", "scene.triangles", "scene.bvh")";

glm::dvec3 lowest(const Scene& scene) {
  return glm::dvec3(glm::vec3(scene.bounds_world.min));
}
glm::dvec3 extent(const Scene& scene) {
  return glm::dvec3(glm::vec3(scene.bounds_world.max)) - lowest(scene);
}

/// One ray a pixel from anywhere in the scene's box to anywhere; the twin of Ray.
std::string ray_shader(const Scene& scene, const std::string& answer) {
  const auto vector = [](const glm::dvec3& v) {
    return fmt::format("vec3({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
  };
  return fmt::format(
      "#include \"bvh.glsl\"\n#include \"white_noise.glsl\"\nvoid main() {{\n"
      "  uvec2 px = uvec2(gl_FragCoord.xy);\n"
      "  vec2 a = white_noise(uvec3(px, 0)), b = white_noise(uvec3(px, 1)), c = white_noise(uvec3(px, 2));\n"
      "  vec3 origin = {} + {} * vec3(a, b.x), direction = 2.0 * vec3(b.y, c) - 1.0;\n  {}\n}}\n",
      vector(lowest(scene)), vector(extent(scene)), answer);
}

glm::dvec2 white_noise(uint32_t x, uint32_t y, uint32_t z) {
  glm::uvec3 v = glm::uvec3(x, y, z) * 1664525u + 1013904223u;
  for (int round = 0; round < 2; ++round) {
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    if (round == 0) v ^= v >> 16u;
  }
  return glm::dvec2(v.x >> 8u, v.y >> 8u) * std::exp2(-24.0);
}

struct Ray {
  glm::dvec3 origin, direction;

  Ray(const Scene& scene, uint32_t x, uint32_t y) {
    const glm::dvec2 a = white_noise(x, y, 0), b = white_noise(x, y, 1), c = white_noise(x, y, 2);
    origin = lowest(scene) + extent(scene) * glm::dvec3(a, b.x);
    direction = 2.0 * glm::dvec3(b.y, c) - 1.0;
  }
};

/// Where the ray meets a triangle, and the weights of its corners b and c; t = infinity for nowhere.
glm::dvec3 meet(const Ray& ray, const std::array<glm::dvec3, 3>& corners) {
  const glm::dvec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0],
                   p = glm::cross(ray.direction, ac);
  const double det = glm::dot(ab, p);
  const glm::dvec3 from = ray.origin - corners[0], q = glm::cross(from, ab);
  const double u = glm::dot(from, p) / det, v = glm::dot(ray.direction, q) / det, t = glm::dot(ac, q) / det;
  const bool is_met = det != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0;
  return {is_met ? t : std::numeric_limits<double>::infinity(), u, v};
}

struct Holes {
  const SharedList<Cutout>& cutouts;
  const SharedList<AlphaMask>& masks;
  uint32_t first = 0;

  bool has(uint32_t triangle, double u, double v) const {
    if (triangle < first) return false;
    const Cutout& cutout = cutouts[triangle - first];
    return is_hole(masks[cutout.mask], uv_at(cutout, static_cast<float>(u), static_cast<float>(v)));
  }
};

double nearest(const Ray& ray, const Scene& scene) {
  double t = std::numeric_limits<double>::infinity();
  const auto take = [&](const std::array<glm::dvec3, 3>& corners, const Holes& holes, uint32_t triangle) {
    const glm::dvec3 met = meet(ray, corners);
    if (met.x < t && !holes.has(triangle, met.y, met.z)) t = met.x;
  };
  const Holes own{scene.cutouts, scene.masks, scene.first_cutout()};
  for (uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const glm::uvec3& c = scene.triangles[i];
    take({scene.positions_world[c.x], scene.positions_world[c.y], scene.positions_world[c.z]}, own, i);
  }
  for (const Instance& instance : list_instances(scene)) {
    const Holes holes{instance.mesh->cutouts, instance.mesh->masks, instance.mesh->first_cutout()};
    for (uint32_t i = 0; i < instance.mesh->triangles.size(); ++i) take(instance.corners_world(i), holes, i);
  }
  return t;
}

class SceneDataTest : public TriedTechnique {
 protected:
  SceneDataTest() : TriedTechnique(small_scene(), kSidePx) {}

  void write(const std::string& body) {
    const std::string lights = R"("rect", "disk", "sphere", "sun")";
    folder_.write("technique.toml", replaced(manifest_head(), "\"rect\", \"sun\"", lights) + body);
  }

  /// Rays whose answers differ, of all.
  size_t wrong_nearest() {
    write(pass(kTraversal));
    shader("v.frag",
           ray_shader(
               scene_,
               fmt::format("out_visibility = min(nearest_hit(origin, direction, {0:.1f}).t / {0:.1f}, 1.0);",
                           kReach)));
    return count_wrong([](double t) { return std::min(t / kReach, 1.0); });
  }

  size_t wrong_any() {
    write(pass(kTraversal));
    shader("v.frag", ray_shader(scene_, "out_visibility = is_any_hit(origin, direction, 1.0) ? 1.0 : 0.0;"));
    return count_wrong([](double t) { return t < 1.0 ? 1.0 : 0.0; });
  }

  size_t count_wrong(double (*expected)(double)) {
    const std::vector<float> found = visibility();
    size_t wrong = 0, met = 0;
    for (uint32_t row = 0; row < kSidePx; ++row) {
      for (uint32_t x = 0; x < kSidePx; ++x) {
        const double t = nearest(Ray(scene_, x, kSidePx - 1 - row), scene_);
        met += t < kReach ? 1 : 0;
        const double error = std::abs(double{found[row * kSidePx + x]} - expected(t));
        wrong += error > 1e-5 * std::max(1.0, expected(t)) ? 1 : 0;
      }
    }
    EXPECT_GT(met, found.size() / 20);
    return wrong;
  }
};

TEST_F(SceneDataTest, RaysMeetWhatTheyMeetAmongSolidTriangles) {
  EXPECT_EQ(wrong_nearest(), 0u);
  EXPECT_EQ(wrong_any(), 0u);
}

TEST_F(SceneDataTest, RaysPassHolesAsDrawnTrianglesDo) {
  add_cutout_card(scene_, pattern_mask({"#..#", ".##.", "...#"}), {4, 4}, 0.25, 0.7);
  finish_scene(scene_);
  EXPECT_LE(wrong_nearest(), 2u);  // of 2304: on the edge of a mask's texel
  EXPECT_LE(wrong_any(), 2u);
}

TEST_F(SceneDataTest, RaysMeetInstancesWhereTheyStand) {
  for (const bool has_leaves : {false, true}) {
    scene_ = instanced_scene(sun_light({0, 1, 0}, 0.01), {.is_smooth = true, .has_leaves = has_leaves});
    EXPECT_LE(wrong_nearest(), 2u) << has_leaves;  // of 2304: grazing an edge
    EXPECT_LE(wrong_any(), 2u) << has_leaves;
  }
}

TEST_F(SceneDataTest, RaysMeetWhatTheyMeetOfAScannedModel) {
  if (!has_models()) GTEST_SKIP() << no_models();
  scene_ = load_scene(model_search().library / "assets/bunny.toml", model_search());
  EXPECT_LE(wrong_nearest(), 2u);  // of 2304: grazing an edge
  EXPECT_LE(wrong_any(), 2u);
}

// All of the rays end about the edge between two triangles: not one may slip through.
TEST_F(SceneDataTest, NoRaySlipsBetweenTwoTriangles) {
  write(pass(kTraversal));
  shader("v.frag",
         "#include \"bvh.glsl\"\nvoid main() {\n"
         "  vec2 p = (gl_FragCoord.xy / 48.0 - 0.5) * 3.9;\n"
         "  vec3 origin = vec3(p.x, 9.0, -p.x * 0.37), target = vec3(p.y, 0.0, -p.y);\n"
         "  out_visibility = is_any_hit(origin, target - origin, 2.0) ? 1.0 : 0.0;\n}\n");
  scene_ = Scene{};
  add_floor(scene_, {4, 4});
  scene_.camera = camera_above({0, 0, 0}, 2, 20);
  scene_.lights.push_back(sun_light({0, 1, 0}, 0.01));
  finish_scene(scene_);
  EXPECT_THAT(visibility(), testing::Each(1.0f));
}

TEST_F(SceneDataTest, IsMadeOnceASceneAndOnlyForWhoReadsIt) {
  shader("v.frag", "void main() { out_visibility = 1.0; }");
  write(pass("\"scene.positions\", \"scene.triangles\", \"scene.normals\""));
  render();
  EXPECT_EQ(scene_data_made(*renderer_), 0u);
  write(pass("\"scene.bvh\""));
  for (int i = 0; i < 3; ++i) render();
  EXPECT_EQ(scene_data_made(*renderer_), 1u);
  write(pass("\"scene.bvh\", \"scene.adjacency\""));
  render();
  EXPECT_EQ(scene_data_made(*renderer_), 2u);
  add_box(scene_, {1, 0, 1}, {1.5, 1, 1.5});
  finish_scene(scene_);
  render();
  EXPECT_EQ(scene_data_made(*renderer_), 4u);
}

TEST_F(SceneDataTest, CountsAsMemoryOfTheTechnique) {
  shader("v.frag", "void main() { out_visibility = 1.0; }");
  write(pass(""));
  const uint64_t without = render().memory_bytes;
  write(pass("\"scene.positions\", \"scene.triangles\""));
  EXPECT_EQ(render().memory_bytes - without, 12 * (scene_.positions_world.size() + scene_.triangles.size()));
  write(pass("\"scene.adjacency\""));
  EXPECT_EQ(render().memory_bytes - without, 12 * scene_.triangles.size());
  write(pass("\"scene.bvh\""));
  EXPECT_EQ(render().memory_bytes - without,
            64 * scene_.triangles.size());  // a head, a node fewer than leaves
}

TEST_F(SceneDataTest, NeighboursLieAcrossEdges) {
  scene_ = Scene{};
  add_floor(scene_, {4, 4});  // two triangles, which share a diagonal
  scene_.camera = camera_above({0, 0, 0}, 2, 20);
  scene_.lights.push_back(sun_light({0, 1, 0}, 0.01));
  finish_scene(scene_);
  shader("v.frag",
         "void main() {\n  uint neighbours = 0u, sum = 0u;\n  for (uint i = 0u; i < 6u; ++i) {\n"
         "    if (scene_adjacency[i] == 0xffffffffu) continue;\n"
         "    ++neighbours;\n    sum += scene_adjacency[i] + 2u * (i / 3u);\n  }\n"
         "  out_visibility = neighbours == 2u && sum == 3u ? 1.0 : 0.0;\n}\n");
  write(pass("\"scene.adjacency\""));
  EXPECT_THAT(visibility(), testing::Each(1.0f));
}

TEST_F(SceneDataTest, RefusesWhatItCannotGive) {
  shader("v.frag", "void main() { out_visibility = 1.0; }");
  write(pass("\"scene.bhv\""));
  EXPECT_THAT(error_of(), AllOf(HasSubstr("reads 'scene.bhv', which is neither a resource nor built in"),
                                HasSubstr("did you mean 'scene.bvh'?")));
  write("frames_before = \"1\"\n" + pass("\"previous.scene.bvh\""));
  EXPECT_THAT(error_of(), HasSubstr("reads 'previous.scene.bvh', which is neither a resource nor built in"));
  write(pass("\"scene.bvh\""));
  shader("v.frag", "#include \"bvh.glsl\"\nvoid main() { out_visibility = 1.0; }");
  EXPECT_THAT(error_of(), HasSubstr("bvh.glsl needs reads"));
}

}  // namespace
}  // namespace umbrameter
