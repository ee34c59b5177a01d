// SPDX-License-Identifier: Apache-2.0
#pragma once
// The scene both renderers draw: one camera, one or more area lights, one merged triangle list, and meshes that stand in
// several places (scenes/instances.h). Positions are float, and those of the list final (world space), so that Embree and GL
// see bit-identical vertices.

#include "core/error.h"
#include "scenes/animation_time.h"
#include "scenes/cutouts.h"
#include "scenes/light.h"
#include "scenes/motion.h"
#include "scenes/shared_list.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace umbrameter {

struct Bounds3 {
  glm::dvec3 min{std::numeric_limits<double>::infinity()};
  glm::dvec3 max{-std::numeric_limits<double>::infinity()};
  bool empty() const { return min.x > max.x; }
  double diagonal() const;
};

struct Camera {
  glm::dvec3 eye_world{0, 0, 1};
  glm::dvec3 at_world{0};
  glm::dvec3 up_world{0, 1, 0};
  double vertical_fov_deg = 45.0;
  double near_world = 0.0;  // derived by the loader: 1e-4 of the scene's diagonal unless given
};

/// A named run of triangles: one `[[mesh]]` of the scene file, or one material of an OBJ file.
struct MeshPart {
  std::string name;
  uint32_t first_triangle = 0;
  uint32_t triangle_count = 0;
};

struct InstancedMesh;

struct Scene {
  std::string name;   // file stem
  std::string title;  // one line for people
  std::string doc;    // what is in the picture and what it stresses
  FileLocation source;
  Camera camera;
  std::vector<Light> lights;  // at least one; commands use `active_light`
  size_t active_light = 0;
  Motion motion;  // that led to the picture

  SharedList<glm::vec3> positions_world;
  SharedList<glm::vec3> normals_world;  // per vertex, unit shading normals; empty = flat shading everywhere
  SharedList<glm::uvec3> triangles;     // vertex indices; primitive_id = index here
  std::vector<MeshPart> parts;
  SharedList<Cutout> cutouts;  // of the last triangles, one each; empty = all of them are solid
  SharedList<AlphaMask> masks;
  std::vector<std::shared_ptr<const InstancedMesh>> instanced;  // besides the triangles above
  std::vector<std::filesystem::path>
      side_files;  // what the meshes' files named and was asked for, there or not
  std::vector<AnimatedMesh>
      animated;  // meshes at a moment of their files' animations; the triangles are those
  Bounds3 bounds_world;

  std::vector<std::string>
      warnings;      // for the reader of a report: dropped triangles, light inside geometry, ...
  std::string hash;  // of everything above that can change a picture

  const Light& light() const { return lights.at(active_light); }
  /// Triangles from here on have holes.
  uint32_t first_cutout() const { return static_cast<uint32_t>(triangles.size() - cutouts.size()); }
};

/// Geometric unit normal of one of scene.triangles, from its winding (not flipped towards anybody).
glm::dvec3 triangle_normal_world(const Scene& scene, uint32_t triangle);

glm::dmat4 view_from_world(const Camera& camera);
/// Reversed-depth, infinite far (core/spaces.h).
glm::dmat4 clip_from_world(const Camera& camera, int width_px, int height_px);
/// Unit world direction through the continuous pixel position.
glm::dvec3 camera_ray_direction_world(const Camera& camera, const glm::dvec2& p_px, int width_px,
                                      int height_px);

/// Limits of a loadable scene; exceeding one is Error{input}.
inline constexpr uint32_t kMaxTriangles = (1u << 24) - 1;  // primitive_id stays exact in a float

}  // namespace umbrameter
