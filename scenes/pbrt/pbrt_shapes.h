// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shapes of pbrt: meshes with their holes, and those that shine.

#include "scenes/pbrt/pbrt_parameters.h"

#include "scenes/foreign/foreign_scene.h"

#include <glm/mat3x3.hpp>

#include <map>
#include <optional>
#include <string>

namespace umbrameter {

class PbrtShapes {
 public:
  explicit PbrtShapes(ForeignScene& scene) : scene_(scene) {}

  /// Texture "name" "float" "class" parameters.
  void add_texture(const std::string& name, const std::string& kind, const PbrtParameters& parameters);

  /// A shape's mesh in scene.meshes, and the matrix that brings it to the shape's own space; absent and counted for what is not
  /// read.
  struct Mesh {
    size_t mesh = 0;
    glm::dmat4 shape_from_mesh{1.0};
  };
  std::optional<Mesh> mesh_of(const std::string& type, const PbrtParameters& parameters);

  /// The light of a shape that shines; `reverses`: its normals are turned around. Absent where it is none that we have.
  std::optional<Light> light_of(const std::string& type, const PbrtParameters& parameters,
                                const glm::dmat4& world_from_shape, bool reverses);

 private:
  struct Texture {
    std::string kind;
    PbrtParameters parameters;
    std::optional<uint32_t> mask;
    bool is_read = false;
  };
  struct Holes {
    uint32_t mask = 0;
    glm::dmat3 to_uv{1.0};
  };

  std::optional<Primitive> read_geometry(const std::string& type, const PbrtParameters& parameters,
                                         glm::dmat4& shape_from_mesh, bool wants_uv);
  std::optional<Primitive> read_ply(const PbrtParameters& parameters, bool wants_uv);
  std::optional<Holes> holes_of(const PbrtParameters& parameters);
  std::optional<Holes> all_holes(double alpha);
  std::optional<Holes> read_texture(const std::string& name, const FileLocation& where);
  std::filesystem::path find_file(const PbrtParameters& parameters);

  ForeignScene& scene_;
  std::map<std::string, Texture> textures_;
  std::map<std::string, size_t> known_;  // meshes by what they are made of
};

}  // namespace umbrameter
