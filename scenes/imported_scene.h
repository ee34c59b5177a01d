// SPDX-License-Identifier: Apache-2.0
#pragma once
// What another program's file holds besides meshes, and the scene file that comes of it.

#include "scenes/animation_time.h"
#include "scenes/mesh_data.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace umbrameter {

/// A scene file as text.
struct ImportedScene {
  std::string toml;  // docs/scene-format.md; its mesh is the other program's file, by name
  std::vector<std::string> warnings;
};

/// Looks along -z, with y up.
struct FoundCamera {
  std::string name;  // for people: "node 'Camera'"
  glm::dmat4 world_from_camera{1.0};
  double vertical_fov_deg = 45.0;
  double near_world = 0.0;  // 0: left to the loader
};

enum class FoundLightKind : uint8_t { point, spot, area, sun };

/// Shines along -z; sizes in metres, absent where the file has none.
struct FoundLight {
  std::string name;
  FoundLightKind kind = FoundLightKind::point;
  glm::dmat4 world_from_light{1.0};
  std::optional<double> radius_world;
  std::optional<glm::dvec2> size_world;
  std::optional<double> angular_diameter_deg;
};

struct FoundScene {
  std::filesystem::path path;
  std::optional<AnimationTime> at;
  Bounds3 bounds_world;
  std::vector<FoundCamera> cameras;
  std::vector<Light> known_lights;  // nothing is missing of them; names need not differ
  std::vector<FoundLight> lights;
  std::vector<std::string> warnings;
};

/// A light without a size. Its tangent is the one that follows from the direction.
Light light_of(std::string name, LightType type, const glm::dvec3& center_world,
               const glm::dvec3& direction_world);

/// Around all of the mesh, with what it repeats.
Bounds3 bounds_of(const MeshData& mesh);

/// The first camera is taken, the others stand in the text as comments; without one the scene is seen from a corner of its
/// bounds. Point lights become spheres, spots and areas disks, or rects where they have a size; suns suns. What has no size
/// gets 0.05 m or 0.53 degrees, with a warning; without lights a sun stands high. The scene file calls the mesh's file
/// `mesh_file`; empty: by its name, as if they stood side by side. With `at` the mesh has its time.
ImportedScene write_scene(FoundScene found, const std::filesystem::path& mesh_file);

}  // namespace umbrameter
